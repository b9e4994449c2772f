// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/numerics/small_matrix.h"
#include "core/numerics/stability_region.h"
#include "core/simulation/springs/spring_model.h"
#include "core/studies/runs/measured_run.h"
#include "core/studies/stability/stability_curves.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double referenceTolerance = 1e-10; // of the run that shows where the case goes

/// The upper half of the eigenvalues of (q, q').
std::vector<Complex> ratesOf(const SpringModel& model, const SpringModel::State& y, SpringModel::Mode mode)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix.topRightCorner<2, 2>().setIdentity();
    matrix.bottomRows<2>() = model.jacobian(y, mode);
    std::vector<Complex> rates;
    for (const Complex rate : eigenvaluesOf(matrix))
        if (rate.imag() >= 0.0) rates.push_back(rate);
    std::ranges::sort(rates, {}, [](Complex rate) { return std::abs(rate); });
    return rates;
}

/// Static state, the stiffest place without contact on the way of the case's own run, the stiffest in contact.
struct SpringWay {
    std::vector<LocalMotion> motions;
    double meanStep = 0.0; // of the case's own integrator [s]
};

bool followSprings(const Case& given, SpringWay& way, const std::function<bool()>& goOn)
{
    Case c = given;
    if (!hasFixedStep(c.run.integrator)) {
        const MeasuredRun own = measureRun(c, {}, goOn);
        if (own.summary.status == RunStatus::Cancelled) return false;
        if (own.summary.steps > 0) way.meanStep = own.summary.endTime / static_cast<double>(own.summary.steps);
    }
    c.run.integrator = IntegratorKind::Dopri5;
    c.run.tolerance = referenceTolerance;
    std::vector<std::string> wanted{"height",         "pitch",         "vertical_velocity",
                                    "pitch_velocity", "front_spacing", "rear_spacing"};
    if (c.contact == ContactKind::OnoYamane) wanted.push_back("contact_force");
    const MeasuredRun run = measureRun(c, wanted, goOn);
    if (run.summary.status == RunStatus::Cancelled) return false;

    const SpringModel model(c);
    way.motions.push_back({"in the static state", ratesOf(model, model.staticState(), {})});
    LocalMotion flying, touching;
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        const auto value = [&](std::size_t column) { return run.columns[column][i]; };
        const bool contact = wanted.size() > 6 && value(6) != 0.0;
        const SpringModel::Mode mode{value(4) > c.springs.cutoff, value(5) > c.springs.cutoff,
                                     contact ? ContactRegion::Pressed : ContactRegion::Apart};
        LocalMotion here{contact ? "in contact" : "closest to the disk",
                         ratesOf(model, {value(0), value(1), value(2), value(3)}, mode)};
        LocalMotion& most = contact ? touching : flying;
        if (most.rates.empty() || here.fastest() > most.fastest()) most = std::move(here);
    }
    for (LocalMotion* each : {&flying, &touching})
        if (!each->rates.empty()) way.motions.push_back(std::move(*each));
    return true;
}

} // namespace

double LocalMotion::fastest() const
{
    double most = 0.0;
    for (const Complex rate : rates) most = std::max(most, std::abs(rate));
    return most;
}

double largestStableStep(const std::function<double(Complex)>& growth, const LocalMotion& motion)
{
    constexpr double shortest = 1e-4, longest = 1e4; // |lambda| h
    double least = std::numeric_limits<double>::infinity();
    for (const Complex rate : motion.rates) {
        const double size = std::abs(rate);
        if (size == 0.0 || rate.real() > 1e-9 * size) continue;
        const Complex direction(std::min(0.0, rate.real() / size), rate.imag() / size);
        const double z =
            largestStable([&](double h) { return growth(h * direction) <= stableGrowth; }, shortest, longest);
        if (z < longest) least = std::min(least, z / size);
    }
    return least;
}

bool makeSpringPicture(const Case& c, LinearPicture& picture, const std::function<bool()>& goOn)
{
    SpringWay way;
    if (!followSprings(c, way, goOn)) return false;
    const double beta = c.run.newmarkBeta, gamma = c.run.newmarkGamma;
    const bool usual = beta == 0.25 && gamma == 0.5;
    const std::vector<LinearMethod> methods{
        {"rk4", "rk4 (switches located or not)", rk4Growth,
         c.run.integrator == IntegratorKind::Rk4 || c.run.integrator == IntegratorKind::Rk4Events},
        {"dopri5", "dopri5", dopri5Growth, c.run.integrator == IntegratorKind::Dopri5},
        {usual ? "newmark" : "newmark, beta " + fewDigits(beta, "", 3) + ", gamma " + fewDigits(gamma, "", 3),
         "newmark", [=](Complex z) { return newmarkGrowth(beta, gamma, z); },
         c.run.integrator == IntegratorKind::Newmark}};
    const bool adaptive = way.meanStep > 0.0;
    const double length = adaptive ? way.meanStep : c.run.step;
    const CaseStep step{length, "steps of " + fewDigitsOfTime(length) + (adaptive ? " on average" : ""), adaptive};

    StudyChart regions;
    regions.title = "Where each method is stable";
    regions.caption = "A method damps y' = lambda y inside its line and amplifies it outside; newmark damps it left of "
                      "its line. Marks: the case's own eigenvalues times its " +
                      step.text +
                      ". The lower half of the plane is its mirror image. cvode's Adams methods change order and step "
                      "and have no single region.";
    regions.panels.push_back(regionPanel(methods, way.motions, step.length));

    const LocalMotion& fastest = *std::ranges::max_element(way.motions, {}, &LocalMotion::fastest);
    StudyChart growth;
    growth.title = "Growth in one step against the step";
    growth.caption = "The largest factor by which a step changes the fastest motion of the case, " + fastest.where +
                     ", whose damping ratio is " + fewDigits(dampingRatio(fastest), "") +
                     ": above 1 it is unstable. Vertical lines: the case's eigenvalues with " + step.text + ".";
    growth.panels.push_back(growthPanel(methods, dampingRatio(fastest), 0.01, 10.0));
    addStepBands(growth.panels.back(), way.motions, step.length);
    picture.charts = {std::move(regions), std::move(growth)};
    picture.tables = {limitTable(methods, way.motions, step.length), eigenvalueTable(way.motions)};
    tellLimits(methods, way.motions, step, picture);
    return true;
}

bool makeLinearPicture(const Case& c, LinearPicture& picture, const std::function<bool()>& goOn)
{
    return c.model == ModelKind::Springs ? makeSpringPicture(c, picture, goOn) : makeFilmPicture(c, picture, goOn);
}

} // namespace touchdown
