// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/linear_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/work/state_stream.h"

namespace touchdown {

using Complex = std::complex<double>;

namespace {

/// The integrals of e^(z (1 - x)) x^j over x from 0 to 1, j = 0..3.
std::array<Complex, 4> powersUnder(Complex z)
{
    constexpr double small = 1.0; // where the recursion would lose digits
    std::array<Complex, 4> integrals;
    if (std::abs(z) < small) {
        // Taylor's series, sum of z^m j!/(m + j + 1)!.
        constexpr int terms = 18;
        for (int j = 0; j < 4; ++j) {
            Complex term = 1.0 / (j + 1.0), sum = term;
            for (int m = 1; m < terms; ++m) sum += term *= z / (m + j + 1.0);
            integrals[static_cast<std::size_t>(j)] = sum;
        }
        return integrals;
    }
    integrals[0] = (std::exp(z) - 1.0) / z;
    for (std::size_t j = 1; j < 4; ++j) integrals[j] = (static_cast<double>(j) * integrals[j - 1] - 1.0) / z;
    return integrals;
}

} // namespace

LinearFilm::LinearFilm(LinearFilmModel model)
    : model_(std::move(model)),
      states_(model_.fit.poles.size(), ComplexVector3::Zero()),
      predicted_(states_),
      weights_(states_.size())
{
    const Matrix3 atRest = model_.fit.at(0.0).real();
    staticStiffness_ = 0.5 * (atRest + atRest.transpose());
}

void LinearFilm::start(const SliderMotion& motion, double /*time*/)
{
    accepted_ = motion;
    accepted_.q -= model_.place;
    // As if the slider had long stood there.
    forceNow_ = model_.force - model_.fit.at(0.0).real() * accepted_.q + disk_;
    for (std::size_t k = 0; k < states_.size(); ++k) states_[k] = -accepted_.q / model_.fit.poles[k].rate;
    stiffness_ = model_.fit.constant;
    atCubic_ = forceNow_ - disk_;
    cubic_ = Vector3::Zero();
    largestSize_ = squares_ = own_ = fourths_ = time_ = 0.0;
    lookAtMotion(0.0);
    dt_ = 0.0;
    started_ = false;
}

void LinearFilm::setDisk(double time, bool /*touched*/)
{
    constexpr double gone = -40.0; // exponent
    disk_ = Vector3::Zero();
    for (const LinearFilmModel::Wave& wave : model_.waves)
        disk_ += (std::polar(1.0, wave.omega * time) * wave.force).real();
    for (std::size_t k = 0; k < model_.transient.size(); ++k) {
        const Complex rate = model_.fit.poles[k].rate;
        if (rate.real() * time > gone) disk_ += termsOf(rate) * (std::exp(rate * time) * model_.transient[k]).real();
    }
}

void LinearFilm::setWeights(double dt)
{
    dt_ = dt;
    stiffness_ = model_.fit.constant;
    for (std::size_t k = 0; k < weights_.size(); ++k) {
        const FilmFit::Pole& pole = model_.fit.poles[k];
        Weights& weights = weights_[k];
        weights.decay = std::exp(pole.rate * dt);
        weights.integrals = powersUnder(pole.rate * dt);
        for (Complex& integral : weights.integrals) integral *= dt;
        stiffness_ += termsOf(pole.rate) * (pole.residue * weights.integrals[3]).real();
    }
}

FilmStepResult LinearFilm::step(double dt, const SliderMotion& from, const Vector3& q, double /*rate*/)
{
    if (dt != dt_) {
        setWeights(dt);
        started_ = false;
    }
    if (!started_) {
        started_ = true;
        const Vector3 u = from.q - model_.place, rise = dt * from.v, bend = 0.5 * dt * dt * from.a;
        quadratic_ = u + rise + bend;
        atCubic_ = model_.force - model_.fit.constant * quadratic_;
        for (std::size_t k = 0; k < states_.size(); ++k) {
            const FilmFit::Pole& pole = model_.fit.poles[k];
            const auto& [decay, integrals] = weights_[k];
            predicted_[k] = decay * states_[k] + integrals[0] * u + integrals[1] * rise + integrals[2] * bend;
            atCubic_ -= termsOf(pole.rate) * (pole.residue * predicted_[k]).real();
        }
    }
    cubic_ = q - model_.place - quadratic_;
    FilmStepResult result;
    result.converged = true;
    result.iterations = 1;
    return result;
}

double LinearFilm::follow(const Vector3& q, const Vector3& /*change*/)
{
    cubic_ = q - model_.place - quadratic_;
    return 0.0;
}

bool LinearFilm::accept(const SliderMotion& to)
{
    for (std::size_t k = 0; k < states_.size(); ++k) states_[k] = predicted_[k] + weights_[k].integrals[3] * cubic_;
    accepted_ = to;
    accepted_.q -= model_.place;
    forceNow_ = force();
    lookAtMotion(dt_);
    started_ = false;
    return true;
}

FilmEnergyState LinearFilm::energy()
{
    const Vector3 &u = accepted_.q, restoring = staticStiffness_ * u;
    FilmEnergyState state;
    state.stored = 0.5 * u.dot(restoring) - model_.force.dot(u);
    state.input = (forceNow_ - model_.force + restoring).dot(accepted_.v);
    return state;
}

double LinearFilm::smallMotion() const
{
    constexpr double least = 1e-9, share = 0.3; // [m], [-]
    return std::max(least, share * model_.spacing);
}

void LinearFilm::lookAtMotion(double dt)
{
    const double gap = std::max(model_.spacing, leastLinearGap);
    const Vector3 fromRest = accepted_.q + model_.place - model_.rest;
    const double size = fromRest.cwiseAbs().dot(model_.arms) / gap, waves = model_.waviness / gap;
    const double square = size * size, all = square + waves * waves;
    largestSize_ = std::max(largestSize_, size);
    squares_ += dt * square;
    own_ += dt * square * square;
    fourths_ += dt * all * all;
    time_ += dt;
}

double LinearFilm::errorBy(double fourths) const
{
    return linearErrorPerSize * (squares_ > 0.0 ? std::sqrt(fourths / squares_) : largestSize_);
}

double LinearFilm::linearityError() const { return errorBy(fourths_); }

bool LinearFilm::isTooFar(double limit) const
{
    double passage = 0.0; // before the slider follows them, waves are all that moves
    for (const LinearFilmModel::Wave& wave : model_.waves)
        passage = std::max(passage, 2.0 * std::numbers::pi / std::abs(wave.omega));
    return errorBy(time_ < passage ? own_ : fourths_) > limit;
}

void LinearFilm::pass(StateStream& stream)
{
    stream(states_, accepted_, forceNow_, disk_, stiffness_, largestSize_, squares_, own_, time_, fourths_);
    StateStream::require(states_.size() == predicted_.size());
    if (!stream.reads()) return;
    dt_ = 0.0;
    started_ = false;
}

} // namespace touchdown
