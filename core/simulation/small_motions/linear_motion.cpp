// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/linear_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/simulation/small_motions/disk_waves.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double modeTolerance = 1e-5; // of s [-]
constexpr double slow = 1e3;           // at which the film is steady [1/s]

/// D(s) in scales of q; a held roll is apart from the other two.
ComplexMatrix3 scaledDynamic(const SmallMotions& motions, Complex s, const SmallMotions::Film& film)
{
    ComplexMatrix3 scaled = motions.scale().asDiagonal() * motions.dynamic(s, film) * motions.scale().asDiagonal();
    if (motions.unknowns() == 2) scaled(2, 2) = scaled.cwiseAbs().maxCoeff();
    return scaled;
}

MotionTerm answerTo(SmallMotions& motions, const DiskWave& wave)
{
    const Complex s(0.0, wave.omega);
    const ComplexVector3 force = motions.force(s, wave.real, wave.quarter);
    const bool solved = motions.converged();
    const ComplexMatrix3 scaled = scaledDynamic(motions, s, motions.film(s)), inverse = adjugate(scaled);
    const ComplexVector3 right = motions.scale().asDiagonal() * force;
    MotionTerm term{.rate = s,
                    .amplitude = inverse * right / scaled.row(0).cwiseProduct(inverse.col(0).transpose()).sum()};
    term.amplitude = motions.scale().asDiagonal() * term.amplitude;
    if (!solved) term.amplitude.setConstant(std::numeric_limits<double>::quiet_NaN());
    return term;
}

/// A mode as excited by a start with velocity v and displacement q, with its force D(0) q, and by the waves.
MotionTerm setGoing(SmallMotions& motions, const SmallMotions::Mode& mode, const Vector3& displacing, const Vector3& v,
                    const std::vector<DiskWave>& waves)
{
    const Complex s = mode.rate;
    ComplexVector3 right = motions.mass().cwiseProduct(v) - displacing / s;
    if (!waves.empty()) {
        std::vector<double> real(waves.front().real.size(), 0.0), imaginary(real), present(real);
        for (const DiskWave& wave : waves) {
            const Complex i(0.0, 1.0), before = 0.5 / (s - i * wave.omega), behind = 0.5 / (s + i * wave.omega);
            for (std::size_t at = 0; at < real.size(); ++at) {
                const Complex w(wave.real[at], wave.quarter[at]), sum = before * w + behind * std::conj(w);
                real[at] += sum.real();
                imaginary[at] += sum.imag();
                present[at] += wave.real[at];
            }
        }
        right += motions.force(s, real, imaginary, present);
    }
    // D(s) is singular: the largest column and row of its adjugate are phi and psi.
    const ComplexMatrix3 null = adjugate(scaledDynamic(motions, s, mode.film));
    Eigen::Index row = 0, column = 0;
    null.cwiseAbs().maxCoeff(&row, &column);
    const Vector3 scale = motions.scale();
    const ComplexVector3 shape = scale.asDiagonal() * null.col(column);
    const ComplexVector3 left = scale.asDiagonal() * null.row(row).transpose();
    const Complex share =
        left.cwiseProduct(right).sum() / left.cwiseProduct(motions.dynamicSlope(s, mode.film) * shape).sum();
    return {.rate = s, .amplitude = 2.0 * share * shape};
}

} // namespace

Attitude LinearMotion::at(double time) const
{
    Vector3 q = Vector3::Zero();
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
    const TeamScope team(filmThreads(c));
    LinearMotion motion;
    motion.halfLength = 0.5 * c.slider.length;
    motion.steady = steady(attitudeCase(c), callback);
    motion.status = motion.steady.status;
    motion.message = motion.steady.message;
    if (motion.status != SteadyStatus::Converged) return motion;

    const auto stopped = [&] {
        if (!callback || callback(progressAbout(motion.steady, "small motions"))) return false;
        motion.status = SteadyStatus::Cancelled;
        motion.message = "cancelled while the modes were sought";
        return true;
    };
    const std::unique_ptr<FilmBalance> film = FilmBalance::at(c, motion.steady);
    SmallMotions motions(film->level(), film->body());
    const bool all = parts == MotionParts::All;
    std::vector<SmallMotions::Mode> found;
    if (all) found = motions.find(modeTolerance, [&](std::size_t) { return !stopped(); });
    if (motion.status == SteadyStatus::Cancelled) return motion;
    if (all && found.size() != static_cast<std::size_t>(c.degreesOfFreedom)) {
        motion.status = SteadyStatus::Failed;
        motion.message = "a mode is so strongly damped that it does not oscillate, or could not be followed";
        return motion;
    }
    const std::vector<DiskWave> waves = diskWaves(c, film->level().gaps);
    for (const DiskWave& wave : waves) {
        if (stopped()) return motion;
        motion.waves.push_back(answerTo(motions, wave));
    }

    const SliderBody& body = film->body();
    const InitialCase& start = c.initial;
    Vector3 q, v(start.verticalVelocity, start.pitchVelocity, body.holdsRoll() ? 0.0 : start.rollVelocity);
    if (start.state == InitialState::Static) {
        q = {start.heightOffset, start.pitchOffset, body.holdsRoll() ? 0.0 : start.rollOffset};
    } else {
        q = body.coordinates({start.nominalTrailingEdgeHeight, start.pitch, start.roll}) - body.rest();
    }
    Vector3 displacing = Vector3::Zero();
    if (all && !q.isZero(0.0)) displacing = motions.dynamic({0.0, slow}, motions.film({0.0, slow})).real() * q;
    const bool atRest = q.isZero(0.0) && v.isZero(0.0) && waves.empty();
    for (const SmallMotions::Mode& mode : found) {
        if (stopped()) return motion;
        motion.modes.push_back(atRest ? MotionTerm{mode.rate, ComplexVector3::Zero()}
                                      : setGoing(motions, mode, displacing, v, waves));
    }
    const auto finite = [](const MotionTerm& term) { return term.amplitude.allFinite(); };
    if (std::ranges::all_of(motion.modes, finite) && std::ranges::all_of(motion.waves, finite)) return motion;
    motion.status = SteadyStatus::NotConverged;
    motion.message = "a linear system of the film over a wave was not solved to 1e-8";
    return motion;
}

} // namespace touchdown
