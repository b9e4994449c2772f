// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/case/contact_law.h"
#include "core/case/integrator_kind.h"
#include "core/formats/units.h"
#include "core/numerics/small_matrix.h"
#include "core/numerics/stability_region.h"
#include "core/physics/film/film_rate.h"
#include "core/simulation/flight/step_length.h"
#include "core/simulation/springs/spring_model.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/runs/measured_run.h"
#include "core/studies/stability/closing_gap.h"
#include "core/studies/stability/stability_curves.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double referenceTolerance = 1e-10; // of the run that shows where the case goes

/// The upper half of the eigenvalues of (q, q').
std::vector<Complex> ratesOf(const Eigen::Matrix<double, 2, 4>& jacobian)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix.topRightCorner<2, 2>().setIdentity();
    matrix.bottomRows<2>() = jacobian;
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
    std::vector<std::string> wanted{"front_spacing", "rear_spacing", "flying_height"};
    if (characteristic(c)) wanted.push_back("contact_force");
    const MeasuredRun run = measureRun(c, wanted, goOn);
    if (run.summary.status == RunStatus::Cancelled) return false;

    const SpringModel model(c);
    way.motions.push_back({"in the static state", ratesOf(model.jacobian(model.staticState(), {}))});
    LocalMotion flying, touching;
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        const auto value = [&](std::size_t column) { return run.columns[column][i]; };
        const double front = value(0), rear = value(1); // above the disk under them [m]
        const bool contact = wanted.size() > 3 && value(3) != 0.0;
        const SpringModel::Mode mode{front > c.springs.cutoff, rear > c.springs.cutoff,
                                     contact ? ContactRegion::Pressed : ContactRegion::Apart};
        LocalMotion here{contact ? "in contact" : "closest to the disk",
                         ratesOf(model.jacobianAt({value(2), front, rear}, mode))};
        LocalMotion& most = contact ? touching : flying;
        if (most.rates.empty() || here.fastest() > most.fastest()) most = std::move(here);
    }
    for (LocalMotion* each : {&flying, &touching})
        if (!each->rates.empty()) way.motions.push_back(std::move(*each));
    return true;
}

void setCharts(StudyReport& picture, const std::string& ofRegions, const ChartPanel& regions,
               const std::string& ofGrowth, const std::vector<ChartPanel>& growth)
{
    picture.charts = {{"Where each method is stable", ofRegions, {regions}},
                      {"Growth in one step against the step", ofGrowth, growth}};
}

bool makeSpringPicture(const Case& c, StudyReport& picture, const std::function<bool()>& goOn)
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

    const LocalMotion& fastest = *std::ranges::max_element(way.motions, {}, &LocalMotion::fastest);
    const double damping = dampingRatio(fastest);
    setCharts(
        picture,
        "A method damps y' = lambda y inside its line and amplifies it outside; newmark damps it left of its line. "
        "Marks: the case's own eigenvalues times its " +
            step.text +
            ". The lower half of the plane is its mirror image. cvode's Adams methods change order and step and "
            "have no single region.",
        regionPanel(methods, way.motions, step.length),
        "The largest factor by which a step changes the fastest motion of the case, " + fastest.where +
            ", whose damping ratio is " + fewDigits(damping, "") +
            ": above 1 it is unstable. Vertical lines: the case's eigenvalues with " + step.text + ".",
        {growthPanel(methods, damping, way.motions, step.length)});
    picture.tables = {limitTable(methods, way.motions, step.length), eigenvalueTable(way.motions)};
    tellLimits(methods, way.motions, step, picture);
    return true;
}

/// How film and slider are solved together in a step.
struct CoupledMethod {
    std::string name, sentence;
    CoupledRule rule;
    bool isTheCases = false;
};

std::vector<CoupledMethod> coupledMethods(const Case& c)
{
    const bool staggered = c.film.coupling == FilmCoupling::Staggered;
    return {
        {"monolithic, Fox & Goodwin",
         "film and slider at once (Fox and Goodwin's rule)",
         {.beta = 1.0 / 12},
         !staggered},
        {"monolithic, trapezoidal",
         "film and slider at once (the trapezoidal rule, which runs take near the limit of the other one)",
         {.beta = 0.25},
         false},
        {"staggered, iterated",
         "film and slider staggered until they agree",
         {.coupling = CouplingKind::Iterated},
         staggered},
        {"staggered, twice", "film and slider staggered twice", {.coupling = CouplingKind::InTurns, .turns = 2}, false},
        {"one-way", "film and slider staggered once", {.coupling = CouplingKind::InTurns, .turns = 1}, false}};
}

/// The fitted formula at this omega h; without it at that of each motion itself.
std::vector<LinearMethod> filmMethods(std::optional<double> phase = {})
{
    const auto fitted = [phase](Complex z) {
        return backwardGrowth(BackwardRule::Fitted, z, phase ? *phase : std::abs(z));
    };
    const auto backward = [](BackwardRule rule) { return [rule](Complex z) { return backwardGrowth(rule, z); }; };
    const auto newmark = [](double beta) { return [beta](Complex z) { return newmarkGrowth(beta, 0.5, z); }; };
    return {{"Euler", "Euler for the air", backward(BackwardRule::Euler)},
            {"BDF2", "BDF2 for the air", backward(BackwardRule::Bdf2)},
            {"BDF2OPT", "BDF2OPT for the air", backward(BackwardRule::Bdf2Opt)},
            {"fitted", "the fitted formula for the air", fitted},
            {"trapezoidal", "the trapezoidal rule for the slider", newmark(0.25)},
            {"Fox & Goodwin", "Fox and Goodwin's rule for the slider", newmark(1.0 / 12)}};
}

/// Largest omega h, of the mode as a slider on a film that leaks [-]; infinite where there is none.
double coupledLimit(const CoupledRule& rule, double damping)
{
    constexpr double shortest = 1e-4, longest = 100.0;
    const double w = largestStable(
        [&](double at) { return coupledGrowth(rule, at, 0.0, 2.0 * damping) <= stableGrowth; }, shortest, longest);
    return w < longest ? w : std::numeric_limits<double>::infinity();
}

LocalMotion motionOf(const AirBearingMode& mode)
{
    const double size = 2.0 * std::numbers::pi * mode.frequency /
                        std::sqrt(std::max(1e-12, 1.0 - mode.dampingRatio * mode.dampingRatio));
    return {mode.kind + " mode at " + fewDigits(mode.frequency, "kHz", 3),
            {{-mode.dampingRatio * size, 2.0 * std::numbers::pi * mode.frequency}},
            true};
}

double explicitLimit(const Case& c, const SteadyResult& rest)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    FilmLevel level(c, recess, MinimumSpacing(c.surface, recess), rest.grid);
    level.gaps.pad.pad<double>(rest.pressure, level.pressure);
    level.film.setAttitude(rest.attitude);
    std::vector<double> residual(level.pressure.size());
    level.film.linearise(level.pressure, residual);
    const double rate = fastestFilmRate(level.film);
    return rate > 0.0 ? 2.0 / rate : std::numeric_limits<double>::infinity();
}

bool makeFilmPicture(const Case& c, StudyReport& picture, const std::function<bool()>& goOn)
{
    Case at = c;
    at.steady.sensitivities = at.steady.allEquilibria = at.steady.fixedAttitude = false;
    const ModesResult result = modes(at, [&](const SteadyProgress&) { return goOn(); });
    if (result.status == SteadyStatus::Cancelled) return false;
    if (result.modes.empty()) {
        picture.message = "there are no modes: " + (result.message.empty() ? "none oscillates" : result.message);
        return true;
    }
    std::vector<LocalMotion> motions;
    for (const AirBearingMode& mode : result.modes) motions.push_back(motionOf(mode));
    if (!result.message.empty()) picture.warnings.push_back("Modes: " + result.message + ".");
    const LocalMotion& fastest = *std::ranges::max_element(motions, {}, &LocalMotion::fastest);
    const bool fixed = c.run.steps == StepControl::Fixed;
    const double length = fixed ? c.run.step : StepLength::longestPhase / fastest.fastest();
    const CaseStep step{length, (fixed ? "steps of " : "steps of at most ") + fewDigitsOfTime(length), !fixed};
    const double damping = std::max(0.0, dampingRatio(fastest));

    const std::vector<LinearMethod> methods = filmMethods();
    ChartPanel together = growthPanel({}, damping, motions, step.length);
    for (const CoupledMethod& method : coupledMethods(c))
        addGrowth(together, method.name, [&](double w) { return coupledGrowth(method.rule, w, 0.0, 2.0 * damping); });
    setCharts(
        picture,
        "Euler, BDF2, BDF2OPT and the formula fitted to the fastest mode, of the air, are stable outside of their "
        "lines; the trapezoidal rule, of the slider, left of its line, Fox & Goodwin's inside. Marks: the modes "
        "of the static state times its " +
            step.text + "; contact adds its stiffness to them. The lower half of the plane is its mirror image.",
        regionPanel(filmMethods(step.length * fastest.fastest()), motions, step.length),
        "Left: rules alone, on the fastest mode, whose damping ratio is " + fewDigits(damping, "") +
            ". Right: slider and film together, the film a spring with the leak that gives it that damping. "
            "Above 1 a method is unstable; the staggered, iterated method ends where its iterations do not "
            "converge.",
        {growthPanel(methods, damping, motions, step.length), together});

    tellLimits(methods, motions, step, picture);
    StudyTable limits = limitTable(methods, motions, step.length);
    for (const CoupledMethod& method : coupledMethods(c)) {
        double least = std::numeric_limits<double>::infinity();
        const LocalMotion* first = &motions.front();
        for (const LocalMotion& motion : motions) {
            const double limit = coupledLimit(method.rule, std::max(0.0, dampingRatio(motion))) / motion.fastest();
            if (limit < least) least = limit, first = &motion;
            const bool finite = std::isfinite(limit);
            limits.rows.push_back(
                {method.name, motion.where, known(finite, limit), step.length, known(finite, step.length / limit)});
        }
        picture.findings.push_back(limitSentence(method.sentence, least, motionText(*first)) +
                                   (method.isTheCases ? "; this case takes " + step.text + "." : "."));
    }
    if (!goOn()) return false;
    const double air = explicitLimit(c, result.steady);
    limits.rows.push_back({"explicit", "air alone", air, step.length, step.length / air});
    picture.findings.push_back("Explicit steps of the air would be stable up to " + fewDigitsOfTime(air) +
                               " on this grid; those of runs are implicit.");
    picture.tables = {std::move(limits), eigenvalueTable(motions)};
    if (!goOn()) return false;
    return addClosingGap(c, picture, goOn);
}

} // namespace

bool makeLinearPicture(const Case& c, StudyReport& picture, const std::function<bool()>& goOn)
{
    return c.model == ModelKind::Springs ? makeSpringPicture(c, picture, goOn) : makeFilmPicture(c, picture, goOn);
}

} // namespace touchdown
