// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/linear_motion.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/simulation/small_motions/film_modes.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double modeTolerance = 1e-5; // of s [-]
constexpr double slow = 1e3;           // at which the film is steady [1/s]

/// Each wave of the surface alone.
std::vector<DiskSurface> singleWaves(const DiskSurface& surface)
{
    std::vector<DiskSurface> waves;
    if (surface.kind != DiskSurfaceKind::Waves || surface.motion != SurfaceMotion::Moving) return waves;
    const auto one = [](const std::vector<double>& list, std::size_t k) {
        return std::vector<double>{list.empty() ? 0.0 : list[k]};
    };
    for (std::size_t k = 0; k < surface.waveAmplitudes.size(); ++k) {
        DiskSurface& wave = waves.emplace_back(surface);
        wave.waveAmplitudes = one(surface.waveAmplitudes, k);
        wave.waveLengths = one(surface.waveLengths, k);
        wave.waveAngles = one(surface.waveAngles, k);
        wave.wavePhases = one(surface.wavePhases, k);
    }
    return waves;
}

/// A wave of the surface over the film's cells: a sin(phi - omega t) = Re W e^(i omega t), W = w(t = 0) + i w(a quarter
/// of a period before). With omega < 0 that quarter lies as far ahead.
struct Wave {
    double omega = 0.0;                // [1/s]
    std::vector<double> real, quarter; // [m]; padded
};

std::vector<Wave> wavesOf(const Case& c, const FilmModes& film)
{
    std::vector<Wave> waves;
    for (const DiskSurface& surface : singleWaves(c.diskSurface)) {
        const DiskTopography topography(surface);
        DiskUnderFilm under(c, topography, film.grid(), film.pad());
        const double number = 2.0 * std::numbers::pi / surface.waveLengths[0],
                     angle = surface.waveAngles[0]; // [rad/m], [rad]
        const double omega = number * (under.velocity().x * std::cos(angle) + under.velocity().y * std::sin(angle));
        if (omega == 0.0) continue;
        Wave& wave = waves.emplace_back(Wave{.omega = omega, .real = {}, .quarter = {}});
        wave.real.resize(film.pad().size());
        wave.quarter.resize(film.pad().size());
        under.at(0.0, wave.real);
        under.at(-0.5 * std::numbers::pi / omega, wave.quarter);
    }
    return waves;
}

MotionTerm answerTo(FilmModes& film, const Wave& wave)
{
    const Complex s(0.0, wave.omega);
    const Eigen::Vector3cd force = film.force(s, wave.real, wave.quarter);
    const bool solved = film.converged();
    const Eigen::Vector3d scale = film.scale();
    const Eigen::Matrix3cd dynamic = scale.asDiagonal() * film.dynamic(s, film.film(s)) * scale.asDiagonal();
    MotionTerm term{.rate = s,
                    .amplitude = scale.asDiagonal() * dynamic.partialPivLu().solve(scale.asDiagonal() * force)};
    if (!solved) term.amplitude.setConstant(std::numeric_limits<double>::quiet_NaN());
    return term;
}

/// What a start with velocity v, displaced by q, which takes the force D(0) q, and the waves that begin with it make of
/// a mode.
MotionTerm setGoing(FilmModes& film, const FilmModes::Mode& mode, const Eigen::Vector3d& displacing,
                    const Eigen::Vector3d& v, const std::vector<Wave>& waves)
{
    const Complex s = mode.rate;
    Eigen::Vector3cd right = film.mass() * v - displacing / s;
    if (!waves.empty()) {
        std::vector<double> real(film.pad().size(), 0.0), imaginary(real), present(real);
        for (const Wave& wave : waves) {
            const Complex i(0.0, 1.0), before = 0.5 / (s - i * wave.omega), behind = 0.5 / (s + i * wave.omega);
            for (std::size_t at = 0; at < real.size(); ++at) {
                const Complex w(wave.real[at], wave.quarter[at]), sum = before * w + behind * std::conj(w);
                real[at] += sum.real();
                imaginary[at] += sum.imag();
                present[at] += wave.real[at];
            }
        }
        right += film.force(s, real, imaginary, present);
    }
    const Eigen::Vector3d scale = film.scale();
    const Eigen::JacobiSVD<Eigen::Matrix3cd> svd(scale.asDiagonal() * film.dynamic(s, mode.film) * scale.asDiagonal(),
                                                 Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3cd shape = scale.asDiagonal() * svd.matrixV().col(2);
    const Eigen::RowVector3cd left = svd.matrixU().col(2).adjoint() * scale.asDiagonal();
    const Complex share = (left * right)(0) / (left * film.dynamicSlope(s, mode.film) * shape)(0);
    return {.rate = s, .amplitude = 2.0 * share * shape};
}

} // namespace

Attitude LinearMotion::at(double time) const
{
    Eigen::Vector3d q = Eigen::Vector3d::Zero();
    for (const auto* terms : {&modes, &waves})
        for (const MotionTerm& term : *terms) q += (std::exp(term.rate * time) * term.amplitude).real();
    return {steady.attitude.height + q[0] - halfLength * q[1], steady.attitude.pitch + q[1],
            steady.attitude.roll + q[2]};
}

bool LinearMotion::unstable() const
{
    for (const MotionTerm& mode : modes)
        if (mode.rate.real() > 0.0) return true;
    return false;
}

LinearMotion linearMotion(const Case& c, const SteadyCallback& callback, MotionParts parts)
{
    LinearMotion motion;
    motion.halfLength = 0.5 * c.slider.length;
    Case still = c;
    still.steady.fixedAttitude = still.steady.stiffness = still.steady.sensitivities = still.steady.allEquilibria =
        false;
    motion.steady = steady(still, callback);
    motion.status = motion.steady.status;
    motion.message = motion.steady.message;
    if (motion.status != SteadyStatus::Converged) return motion;

    const auto stopped = [&] {
        if (!callback || callback({.stage = "small motions",
                                   .iteration = 0,
                                   .residual = motion.steady.residual,
                                   .loadError = motion.steady.loadError,
                                   .attitude = motion.steady.attitude}))
            return false;
        motion.status = SteadyStatus::Cancelled;
        motion.message = "cancelled while the modes were sought";
        return true;
    };
    FilmModes film(c, motion.steady);
    const bool all = parts == MotionParts::All;
    std::vector<FilmModes::Mode> found;
    if (all) found = film.find([&](std::size_t) { return !stopped(); }, modeTolerance);
    if (motion.status == SteadyStatus::Cancelled) return motion;
    if (all && found.size() != static_cast<std::size_t>(c.degreesOfFreedom)) {
        motion.status = SteadyStatus::Failed;
        motion.message = "a mode is so strongly damped that it does not oscillate, or could not be followed";
        return motion;
    }
    const std::vector<Wave> waves = wavesOf(c, film);
    for (const Wave& wave : waves) {
        if (stopped()) return motion;
        motion.waves.push_back(answerTo(film, wave));
    }

    const SliderBody body(c, motion.steady.attitude);
    const InitialCase& start = c.initial;
    Eigen::Vector3d q, v(start.verticalVelocity, start.pitchVelocity, body.holdsRoll() ? 0.0 : start.rollVelocity);
    if (start.state == InitialState::Static) {
        q = {start.heightOffset, start.pitchOffset, body.holdsRoll() ? 0.0 : start.rollOffset};
    } else {
        const Vector3 from = body.coordinates({start.nominalTrailingEdgeHeight, start.pitch, start.roll});
        for (Eigen::Index k = 0; k < 3; ++k)
            q[k] = from[static_cast<std::size_t>(k)] - body.rest()[static_cast<std::size_t>(k)];
    }
    Eigen::Vector3d displacing = Eigen::Vector3d::Zero();
    if (all && !q.isZero(0.0)) displacing = film.dynamic({0.0, slow}, film.film({0.0, slow})).real() * q;
    const bool atRest = q.isZero(0.0) && v.isZero(0.0) && waves.empty();
    for (const FilmModes::Mode& mode : found) {
        if (stopped()) return motion;
        motion.modes.push_back(atRest ? MotionTerm{mode.rate, Eigen::Vector3cd::Zero()}
                                      : setGoing(film, mode, displacing, v, waves));
    }
    const auto finite = [](const MotionTerm& term) { return term.amplitude.allFinite(); };
    if (std::ranges::all_of(motion.modes, finite) && std::ranges::all_of(motion.waves, finite)) return motion;
    motion.status = SteadyStatus::NotConverged;
    motion.message = "a linear system of the film over a wave was not solved to 1e-8";
    return motion;
}

} // namespace touchdown
