// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/linear_state.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/numerics/rational_fit.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/simulation/small_motions/disk_waves.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

namespace {

using Complex = FilmFit::Complex;

constexpr std::size_t mostKept = 4;
constexpr double worstFit = 5e-3; // of the largest entry of the stiffness [-]

struct Kept {
    std::mutex mutex;
    std::vector<std::shared_ptr<const LinearState>> states; // the last one made first
};
Kept& kept()
{
    static Kept states;
    return states;
}

/// Rates between those of the fit, none of them near to that of a wave, where the answer is not finite [1/s].
std::vector<double> ratesBeside(const std::vector<DiskWave>& waves)
{
    constexpr int count = 20;
    constexpr double apart = 0.02, step = 1.05; // of a rate [-]
    const auto meets = [&](double rate) {
        return std::ranges::any_of(
            waves, [&](const DiskWave& wave) { return std::abs(std::abs(wave.omega) / rate - 1.0) < apart; });
    };
    std::vector<double> rates;
    for (int k = 0; k < count; ++k) {
        double rate = 2.0 * std::numbers::pi * lowestFitted * std::pow(highestFitted / lowestFitted, k / (count - 1.0));
        while (meets(rate)) rate *= step;
        rates.push_back(rate);
    }
    return rates;
}

/// The force by waves that begin, Phi(s), less that by which they last:
///   Phi(s) = sum of (f/(s - i omega) + f*/(s + i omega))/2 + sum a_k/(s - p_k)
ComplexVector3 transientForce(const LinearFilmModel& film, SmallMotions& motions, const std::vector<DiskWave>& waves,
                              Complex s)
{
    const Complex i(0.0, 1.0);
    std::vector<double> real(waves.front().real.size(), 0.0), imaginary(real), present(real);
    ComplexVector3 lasting = ComplexVector3::Zero();
    for (std::size_t n = 0; n < waves.size(); ++n) {
        const DiskWave& wave = waves[n];
        const Complex before = 0.5 / (s - i * wave.omega), behind = 0.5 / (s + i * wave.omega);
        for (std::size_t at = 0; at < real.size(); ++at) {
            const Complex w(wave.real[at], wave.quarter[at]), sum = before * w + behind * std::conj(w);
            real[at] += sum.real();
            imaginary[at] += sum.imag();
            present[at] += wave.real[at];
        }
        lasting += before * film.waves[n].force + behind * film.waves[n].force.conjugate();
    }
    return motions.force(s, real, imaginary, present) - lasting;
}

void setWaves(LinearFilmModel& film, SmallMotions& motions, const std::vector<DiskWave>& waves, bool& solved,
              const std::function<bool()>& goOn)
{
    if (waves.empty()) return;
    const Eigen::DiagonalMatrix<double, 3> scale(motions.scale()); // its own values: scale() returns a temporary
    double largest = 0.0;                                          // of the lasting forces, at the corners [N]
    for (const DiskWave& wave : waves) {
        if (!goOn()) return;
        const ComplexVector3 force = motions.force({0.0, wave.omega}, wave.real, wave.quarter);
        solved = solved && motions.converged() && force.allFinite();
        film.waves.push_back({wave.omega, force});
        largest = std::max(largest, (scale * force).cwiseAbs().maxCoeff());
    }
    std::vector<RationalSample> samples, some, others;
    for (const double rate : ratesBeside(waves)) {
        if (!goOn()) return;
        const ComplexVector3 left = scale * transientForce(film, motions, waves, {0.0, rate});
        solved = solved && motions.converged() && left.allFinite();
        const RationalSample& sample =
            samples.emplace_back(RationalSample{{0.0, rate}, {left[0], left[1], left[2]}, {rate, rate, rate}});
        (samples.size() % 4 == 3 ? others : some).push_back(sample);
    }
    if (!solved) return;
    std::vector<Complex> poles;
    for (const FilmFit::Pole& pole : film.fit.poles) poles.push_back(pole.rate);
    // Its error by values that a fit to the others has not seen.
    const RationalFit part = fitResidues(some, poles, false);
    double missed = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        for (const RationalSample& sample : samples)
            largest = std::max(largest, sample.s.imag() * std::abs(sample.values[k]));
        for (const RationalSample& sample : others)
            missed = std::max(missed, sample.s.imag() * std::abs(part.at(sample.s, k) - sample.values[k]));
    }
    film.transientError = largest > 0.0 ? missed / largest : 0.0;
    const RationalFit fit = fitResidues(samples, poles, false);
    for (const std::vector<Complex>& residue : fit.residues)
        film.transient.push_back(motions.scale().cwiseInverse().asDiagonal() *
                                 ComplexVector3(residue[0], residue[1], residue[2]));
}

/// By which ratio the waves of a case are those of another one; nothing where they are others.
std::optional<double> ratioOfWaves(const DiskSurface& surface, const DiskSurface& known)
{
    if (!hasWaves(surface)) return 0.0;
    if (!hasWaves(known) || known.waveAmplitudes.size() != surface.waveAmplitudes.size()) return std::nullopt;
    const double ratio = surface.waveAmplitudes.front() / known.waveAmplitudes.front();
    DiskSurface scaled = known;
    for (std::size_t k = 0; k < known.waveAmplitudes.size(); ++k) {
        const double amplitude = ratio * known.waveAmplitudes[k];
        constexpr double rounding = 1e-12;
        if (!(std::abs(surface.waveAmplitudes[k] - amplitude) <= rounding * std::abs(amplitude))) return std::nullopt;
        scaled.waveAmplitudes[k] = surface.waveAmplitudes[k];
    }
    return scaled == surface ? std::optional(ratio) : std::nullopt;
}

/// Whether the film answers to the disks of two cases in the same way.
bool sameWaves(const Case& a, const Case& b)
{
    return a.diskSurface == b.diskSurface || (!hasWaves(a.diskSurface) && !hasWaves(b.diskSurface));
}

} // namespace

void LinearFilmModel::scaleWaves(double ratio)
{
    if (ratio == 0.0) { // none, without an error
        waves.clear();
        transient.clear();
        waviness = transientError = 0.0;
        return;
    }
    for (Wave& wave : waves) wave.force *= ratio;
    for (ComplexVector3& amplitude : transient) amplitude *= ratio;
    waviness *= std::abs(ratio);
}

bool isStateOf(const LinearState& state, const Case& c)
{
    Case undamped = c;
    const SuspensionCase& solved = state.solved.suspension;
    undamped.suspension.damping = solved.damping;
    undamped.suspension.pitchDamping = solved.pitchDamping;
    undamped.suspension.rollDamping = solved.rollDamping;
    return isRestOf(undamped, state.solved, state.rest);
}

std::shared_ptr<const LinearState> knownLinearState(const Case& c)
{
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    std::shared_ptr<const LinearState> found;
    for (const auto& state : all.states)
        if (isStateOf(*state, c) && (!found || sameWaves(state->solved, c))) found = state;
    return found;
}

bool hasLinearState(const Case& c)
{
    const std::shared_ptr<const LinearState> own = knownLinearState(c);
    return own && (answersDisk(*own, c) || !hasWaves(c.diskSurface)); // waves are left out at once
}

std::shared_ptr<const LinearState> nearestLinearState(const Case& c)
{
    const Case sought = attitudeCase(c);
    // A contact that sees the disk finds its mean plane in a static state alone.
    const bool seesWaves = contactLaw(c).seesDisk && c.diskSurface.kind != DiskSurfaceKind::Flat;
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    std::shared_ptr<const LinearState> nearest;
    double ratio = 1.0;
    bool isOwn = false;
    for (const auto& state : all.states) {
        const bool own = isStateOf(*state, c);
        if ((nearest && (isOwn || !own)) || (!own && (seesWaves || !sameFilmApart(sought, state->solved)))) continue;
        const std::optional<double> scale = ratioOfWaves(c.diskSurface, state->solved.diskSurface);
        if (!scale && !sameWaves(state->solved, c)) continue;
        nearest = state;
        ratio = sameWaves(state->solved, c) ? 1.0 : *scale;
        isOwn = own;
    }
    if (!nearest || ratio == 1.0) return nearest;
    auto scaled = std::make_shared<LinearState>(*nearest);
    scaled->solved.diskSurface = c.diskSurface;
    scaled->film.scaleWaves(ratio);
    return scaled;
}

bool answersDisk(const LinearState& state, const Case& c) { return sameWaves(state.solved, c); }

std::shared_ptr<const LinearState> makeLinearState(const Case& c, SteadyResult rest, const LinearFilmModel* known,
                                                   const std::function<bool()>& goOn)
{
    bool goesOn = true, solved = true;
    const auto ask = [&] { return goesOn = goesOn && (!goOn || goOn()); };
    LinearFilmModel film;
    if (known) film = *known;
    film.waves.clear();
    film.transient.clear();
    film.waviness = film.transientError = 0.0;
    if (hasWaves(c.diskSurface))
        for (const double amplitude : c.diskSurface.waveAmplitudes)
            film.waviness = std::hypot(film.waviness, std::numbers::sqrt2 / 2.0 * amplitude);
    if (!known || hasWaves(c.diskSurface)) {
        const std::unique_ptr<FilmBalance> slider = FilmBalance::at(c, rest, goOn);
        if (!slider && ask())
            throw std::runtime_error("the contact of the static state was not solved again (film.motion)");
        if (!slider) return nullptr;
        FilmLevel& level = slider->level();
        film.place = film.rest = slider->body().coordinates(rest.attitude);
        film.force = slider->body().filmForce(level.loads.loadAndShear(level.pressure));
        film.ambientForce = level.film.ambient() * c.slider.length * c.slider.width;
        film.spacing = rest.minimumSpacing;
        film.arms = {1.0, 0.5 * c.slider.length, 0.5 * c.slider.width};
        SmallMotions motions(level, slider->body(), slider->contactStiffness(rest.contact.region),
                             slider->filmSlopes());
        motions.ask(ask);
        if (!known) film.fit = fitFilm(motions, solved, ask);
        if (goesOn) setWaves(film, motions, diskWaves(c, level.gaps), solved, ask);
    }
    if (!goesOn) return nullptr;
    if (!solved)
        throw std::runtime_error("the linear film was not found: its answer to one frequency did not converge "
                                 "(film.motion); \"full\" needs none");
    if (!film.fit.isFinite() || film.fit.error > worstFit)
        throw std::runtime_error("the linear film was not found: its fit has an error of " + percent(film.fit.error) +
                                 ", above " + percent(worstFit) + " (film.motion); \"full\" needs none");
    auto state = std::make_shared<const LinearState>(LinearState{attitudeCase(c), std::move(rest), std::move(film)});
    Kept& all = kept();
    const std::lock_guard lock(all.mutex);
    std::erase_if(all.states, [&](const auto& other) { return isStateOf(*other, c) && sameWaves(other->solved, c); });
    all.states.insert(all.states.begin(), state);
    all.states.resize(std::min(all.states.size(), mostKept));
    return state;
}

} // namespace touchdown
