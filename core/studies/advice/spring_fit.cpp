// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/spring_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Jacobi>
#include <Eigen/LU>

#include "core/case/contact_law.h"
#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

namespace {

constexpr double twoPi = 2.0 * std::numbers::pi;

/// Undamped modes of (z, pitch), by frequency; shapes with phi^T M phi = 1.
struct UndampedModes {
    Eigen::Vector2d omega; // [rad/s]
    Eigen::Matrix2d shapes;
};

UndampedModes undampedModes(const Eigen::Matrix2d& stiffness, const Case& c)
{
    const Eigen::Vector2d perRootMass(1.0 / std::sqrt(c.slider.mass), 1.0 / std::sqrt(c.slider.pitchInertia));
    const Eigen::Matrix2d scaled = perRootMass.asDiagonal() * stiffness * perRootMass.asDiagonal();
    Eigen::JacobiRotation<double> rotation;
    rotation.makeJacobi(scaled, 0, 1);
    Eigen::Matrix2d vectors; // of the scaled matrix
    vectors << rotation.c(), rotation.s(), -rotation.s(), rotation.c();
    Eigen::Vector2d squares = (vectors.transpose() * scaled * vectors).diagonal();
    if (squares[0] > squares[1]) {
        squares.reverseInPlace();
        vectors.col(0).swap(vectors.col(1));
    }
    return {squares.cwiseMax(0.0).cwiseSqrt(), perRootMass.asDiagonal() * vectors};
}

/// Dashpots at both arms that give modes these damping ratios: 2 zeta omega = sum c (b phi)^2, b = (1, arm).
Eigen::Vector2d dashpots(const UndampedModes& modes, const std::array<double, 2>& arms,
                         const std::array<double, 2>& ratios)
{
    Eigen::Matrix2d shares;
    Eigen::Vector2d wanted;
    for (Eigen::Index k = 0; k < 2; ++k) {
        wanted[k] = 2.0 * ratios[static_cast<std::size_t>(k)] * modes.omega[k];
        for (Eigen::Index i = 0; i < 2; ++i)
            shares(k, i) = std::pow(modes.shapes(0, k) + arms[static_cast<std::size_t>(i)] * modes.shapes(1, k), 2);
    }
    // Where both arms take the same share of each mode, no pair of dashpots is the only one.
    Eigen::Index left = shares.col(1).norm() > shares.col(0).norm() ? 1 : 0;
    if (std::abs(shares.determinant()) > 1e-12 * shares.squaredNorm()) {
        const Eigen::Vector2d both = shares.inverse() * wanted;
        if (both.minCoeff() >= 0.0) return both;
        left = both[0] < 0.0 ? 1 : 0;
    }
    // One alone, by least squares.
    Eigen::Vector2d one = Eigen::Vector2d::Zero();
    one[left] = std::max(0.0, shares.col(left).dot(wanted) / shares.col(left).squaredNorm());
    return one;
}

void takeStart(Case& springs, const Case& c, const SteadyResult& rest, double padDistance)
{
    const SliderBody body(c, rest.attitude);
    double height = c.initial.heightOffset, pitch = c.initial.pitchOffset; // from rest
    if (c.initial.state == InitialState::Given) {
        const Vector3 q = body.coordinates({c.initial.nominalTrailingEdgeHeight, c.initial.pitch, c.initial.roll});
        height = q[0] - body.rest()[0];
        pitch = q[1] - body.rest()[1];
    }
    springs.initial = InitialCase{};
    springs.initial.flyingHeight = rest.minimumSpacing + height - padDistance * pitch;
    springs.initial.pitch = rest.attitude.pitch + pitch;
    springs.initial.verticalVelocity = c.initial.verticalVelocity;
    springs.initial.pitchVelocity = c.initial.pitchVelocity;
    springs.initial.branch = c.initial.branch;
}

double dampingRatio(double damping, double inertia, double stiffness)
{
    return stiffness > 0.0 ? damping / (2.0 * std::sqrt(inertia * stiffness)) : 0.0;
}

SpringFit failed(std::string problem)
{
    SpringFit fit;
    fit.problem = std::move(problem);
    return fit;
}

} // namespace

bool springsKnowDisk(const Case& c)
{
    const DiskSurface& surface = c.diskSurface;
    return !(hasBumps(surface) && surface.bumpShape == BumpShape::Ellipsoid && surface.motion == SurfaceMotion::Moving);
}

SpringFit fitSprings(const Case& c, const std::function<bool()>& goOn)
{
    if (c.contact != noContact && !characteristic(c))
        return failed(
            "springs are fitted to a film without contact or with contact = \"ono-yamane\", which acts on both alike");
    const auto ask = [&] { return !goOn || goOn(); };
    Case flat = c;
    flat.degreesOfFreedom = 2;
    flat.diskSurface.kind = DiskSurfaceKind::Flat;
    flat.steady.fixedAttitude = flat.steady.stiffness = flat.steady.sensitivities = flat.steady.allEquilibria = false;
    const SteadyResult rest = steady(flat, [&](const SteadyProgress&) { return ask(); });
    if (rest.status != SteadyStatus::Converged)
        return failed("there is no static state to fit springs about: " + rest.message);
    const std::unique_ptr<FilmBalance> film = FilmBalance::at(flat, rest);
    SmallMotions motions(film->level(), film->body());
    const std::vector<SmallMotions::Mode> modes = motions.find(1e-9, [&](std::size_t) { return ask(); });
    if (!ask()) return failed("stopped");
    if (modes.size() != 2) return failed("the film does not have two modes of height and pitch that oscillate");

    SpringFit fit;
    std::array<double, 2> ratios{};
    for (std::size_t k = 0; k < 2; ++k) {
        fit.filmFrequency[k] = modes[k].rate.imag() / twoPi;
        fit.filmDamping[k] = -modes[k].rate.real() / std::abs(modes[k].rate);
        ratios[k] = fit.filmDamping[k];
    }
    const double middle = std::sqrt(modes[0].rate.imag() * modes[1].rate.imag());
    const Eigen::Matrix2d answer = motions.film({0.0, middle}).stiffness.topLeftCorner<2, 2>();
    const Eigen::Matrix2d K = 0.5 * (answer + answer.transpose());
    const double padDistance = rest.minimumAt.x - 0.5 * c.slider.length;
    const double mean = K(0, 1) / K(0, 0), variance = K(1, 1) / K(0, 0) - mean * mean, toRear = mean + padDistance;
    if (!(K(0, 0) > 0.0) || !(variance > 0.0) || !(toRear > 0.0) || !(padDistance > 0.0))
        return failed("two springs with positive stiffness, one where the slider is lowest, cannot have the film's "
                      "stiffness matrix");

    Case& springs = fit.springs = c;
    springs.model = ModelKind::Springs;
    springs.degreesOfFreedom = 2;
    if (!springsKnowDisk(c)) springs.diskSurface = DiskSurface{};
    springs.adhesion = Adhesion{};
    SpringsCase& s = springs.springs;
    s = SpringsCase{};
    s.rearDistance = padDistance;
    s.frontDistance = mean + variance / toRear;
    if (!(s.frontDistance > 0.0)) return failed("the front spring would lie behind the mass centre");
    s.frontStiffness = K(0, 0) * toRear / (s.frontDistance + s.rearDistance);
    s.rearStiffness = K(0, 0) - s.frontStiffness;
    s.flyingHeight = rest.minimumSpacing;
    s.pitch = rest.attitude.pitch;
    // A spring is lost where the film's own flow changes its kind; less where the slider flies lower than that.
    s.cutoff = std::min(s.cutoff, 0.1 * rest.minimumSpacing);
    springs.springs.padDistance = padDistance;
    SuspensionCase& suspension = springs.suspension;
    suspension.dampingRatio = dampingRatio(c.suspension.damping, c.slider.mass, c.suspension.stiffness);
    suspension.pitchDampingRatio =
        dampingRatio(c.suspension.pitchDamping, c.slider.pitchInertia, c.suspension.pitchStiffness);
    takeStart(springs, c, rest, padDistance);
    springs.run.integrator = IntegratorKind::Dopri5;
    springs.title = "Springs fitted to: " + c.title;
    springs.about.assumed =
        "Two springs fitted to the film about its static state, with the rear one where the slider is lowest.";

    // Frequencies and damping with the suspension, as those of the film are.
    const std::array<double, 2> arms{s.frontDistance, -s.rearDistance};
    Eigen::Matrix2d fitted;
    fitted << s.frontStiffness + s.rearStiffness, s.frontStiffness * arms[0] + s.rearStiffness * arms[1],
        s.frontStiffness * arms[0] + s.rearStiffness * arms[1],
        s.frontStiffness * arms[0] * arms[0] + s.rearStiffness * arms[1] * arms[1];
    const Eigen::Vector2d scale(1.0, 1.0 / c.slider.length);
    fit.stiffnessLeft = (scale.asDiagonal() * (answer - fitted) * scale.asDiagonal()).norm() /
                        (scale.asDiagonal() * answer * scale.asDiagonal()).norm();
    const UndampedModes undamped = undampedModes(
        fitted + Eigen::Matrix2d(Eigen::Vector2d(c.suspension.stiffness, c.suspension.pitchStiffness).asDiagonal()), c);
    std::array<double, 2> own{};
    for (Eigen::Index k = 0; k < 2; ++k)
        own[static_cast<std::size_t>(k)] = (c.suspension.damping * std::pow(undamped.shapes(0, k), 2) +
                                            c.suspension.pitchDamping * std::pow(undamped.shapes(1, k), 2)) /
                                           (2.0 * undamped.omega[k]);
    const Eigen::Vector2d damping = dashpots(undamped, arms, {ratios[0] - own[0], ratios[1] - own[1]});
    s.frontDampingRatio = dampingRatio(damping[0], c.slider.mass, s.frontStiffness);
    s.rearDampingRatio = dampingRatio(damping[1], c.slider.mass, s.rearStiffness);
    for (Eigen::Index k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        double sum = own[at] * 2.0 * undamped.omega[k];
        for (Eigen::Index i = 0; i < 2; ++i)
            sum += damping[i] *
                   std::pow(undamped.shapes(0, k) + arms[static_cast<std::size_t>(i)] * undamped.shapes(1, k), 2);
        fit.springDamping[at] = sum / (2.0 * undamped.omega[k]);
        fit.springFrequency[at] = undamped.omega[k] / twoPi;
    }
    for (const CaseProblem& problem : checkCombinations(springs)) return failed(problem.key + ": " + problem.message);
    return fit;
}

} // namespace touchdown
