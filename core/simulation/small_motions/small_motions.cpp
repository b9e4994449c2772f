// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/small_motions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics/film/film_oscillation.h"
#include "core/physics/film/film_slopes.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

using Complex = SmallMotions::Complex;

namespace {

constexpr int mostPasses = 40;         // for one mode
constexpr double farthestSecant = 5.0; // a secant's step, of |g(s) - s| [-]
constexpr double oscillating = 1e-6;   // least imaginary part of a rate, of its magnitude [-]
constexpr double doubtfulDecay = 0.2;  // damping ratio above which a mode may be a root of the film [-]
constexpr double perRate = 1e-6;       // [s]: in slider lengths and microseconds the entries are alike in size

/// Damping ratio of a rate [-].
double decayOf(Complex rate) { return -rate.real() / std::abs(rate); }

/// The nearest of some modes to a rate.
auto nearest(std::vector<SmallMotions::Mode>& modes, Complex rate)
{
    return std::ranges::min_element(modes, {}, [&](const auto& mode) { return std::abs(mode.rate - rate); });
}

} // namespace

SmallMotions::SmallMotions(FilmLevel& level, const SliderBody& body, const Matrix3& contact, const FilmSlopes* slopes)
    : level_(level), body_(body), contact_(contact)
{
    std::vector<double> residual(level.pressure.size());
    level.film.linearise(level.pressure, residual);
    oscillation_ = std::make_unique<FilmOscillation>(level.film, level.pressure, slopes);
    FilmLoads::Derivatives forces;
    level.loads.derivatives(level.pressure, forces);
    if (slopes) forces.byAttitude = slopes->forces;
    // The torques of the shear are part of the balance.
    for (std::size_t k = 0; k < 3; ++k) {
        byPressure_[k] = forces.byPressure[k];
        for (std::size_t m = 0; m < 3; ++m) byAttitude_(k, m) = forces.byAttitude[k][m];
        if (k == 0) continue;
        for (std::size_t at = 0; at < byPressure_[k].size(); ++at)
            byPressure_[k][at] -= body.shearArm() * forces.byPressure[k + 2][at];
        for (std::size_t m = 0; m < 3; ++m) byAttitude_(k, m) -= body.shearArm() * forces.byAttitude[k + 2][m];
    }
}

SmallMotions::~SmallMotions() = default;

void SmallMotions::ask(std::function<bool()> goOn) { oscillation_->ask(std::move(goOn)); }

const Vector3& SmallMotions::mass() const { return body_.inertia(); }

Eigen::Index SmallMotions::unknowns() const { return body_.holdsRoll() ? 2 : 3; }

Vector3 SmallMotions::scale() const { return {1.0, 1.0 / level_.gaps.length, 1.0 / level_.gaps.width}; }

SmallMotions::Film SmallMotions::film(Complex s)
{
    converged_ = true;
    const auto n = static_cast<std::size_t>(unknowns());
    ComplexMatrix3 z = oscillation_->stiffness(s, byPressure_, byAttitude_, converged_, n);
    // The trailing edge's height falls by half the length times the pitch when the centre keeps its own.
    z.col(1) -= 0.5 * level_.gaps.length * z.col(0);
    if (n == 2) z.row(2).setZero();
    Film result;
    result.damping = z.imag() / s.imag();
    result.stiffness = z.real() - s.real() * result.damping;
    return result;
}

/// The oscillations with this response of the film at all rates, by frequency, without the nearest to each known mode.
std::vector<SmallMotions::Mode> SmallMotions::trials(const Film& film, const std::vector<Mode>& known) const
{
    const Vector3 scale = this->scale(), toMass = mass().cwiseInverse();
    Matrix3 K = film.stiffness + contact_, C = film.damping;
    K.diagonal() += body_.springs();
    C.diagonal() += body_.dampers();
    K = (scale.cwiseInverse().cwiseProduct(toMass)).asDiagonal() * K * scale.asDiagonal();
    C = (scale.cwiseInverse().cwiseProduct(toMass)).asDiagonal() * C * scale.asDiagonal();
    const Eigen::Index n = unknowns();
    SmallMatrix companion = SmallMatrix::Zero(2 * n, 2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        companion(i, n + i) = 1.0;
        for (Eigen::Index j = 0; j < n; ++j) {
            companion(n + i, j) = -K(i, j) * (perRate * perRate);
            companion(n + i, n + j) = -C(i, j) * perRate;
        }
    }
    std::vector<Mode> list;
    if (!companion.allFinite()) return list;
    const Eigenpairs eigen = eigenpairsOf(companion);
    for (Eigen::Index k = 0; k < 2 * n; ++k) {
        const Complex rate = eigen.values[k] / perRate;
        if (!(rate.imag() > oscillating * std::abs(rate))) continue;
        Mode& mode = list.emplace_back(Mode{rate, ComplexVector3::Zero()});
        for (Eigen::Index i = 0; i < n; ++i) mode.shape[i] = scale[i] * eigen.vectors(i, k);
    }
    std::ranges::sort(list, {}, [](const Mode& mode) { return mode.rate.imag(); });
    for (const Mode& mode : known)
        if (const auto same = nearest(list, mode.rate); same != list.end()) list.erase(same);
    return list;
}

/// Follows one mode to where its rate stays; false if it does not, if it turns real or the film is not solved.
bool SmallMotions::follow(Mode& mode, const std::vector<Mode>& known, double tolerance)
{
    Complex before, missedBefore;
    for (int pass = 0; pass < mostPasses; ++pass) {
        const Complex s = mode.rate;
        mode.film = film(s);
        std::vector<Mode> left = trials(mode.film, known);
        if (!converged_ || left.empty()) return false;
        const Mode& next = *nearest(left, s);
        const Complex missed = next.rate - s;
        mode.shape = next.shape;
        mode.rate = next.rate;
        if (std::abs(missed) <= tolerance * std::abs(s)) return true;
        if (pass > 0 && missed != missedBefore) {
            const Complex secant = -missed * (s - before) / (missed - missedBefore);
            if (std::abs(secant) < farthestSecant * std::abs(missed) && (s + secant).imag() > 0.0)
                mode.rate = s + secant;
        }
        before = s;
        missedBefore = missed;
    }
    return false;
}

std::vector<SmallMotions::Mode> SmallMotions::find(double tolerance, const std::function<bool(std::size_t)>& goOn,
                                                   std::span<const Complex> near)
{
    std::vector<Mode> known;
    const auto complete = [&] { return known.size() == static_cast<std::size_t>(unknowns()); };
    const auto asked = [&] { return !goOn || goOn(known.size()); };
    const auto followed = [&](Mode trial) {
        if (follow(trial, known, tolerance)) known.push_back(std::move(trial));
    };
    for (const Complex rate : near)
        if (!complete() && asked()) followed({rate, ComplexVector3::Zero()});
    // Trials: the modes that the film would have if it answered as at 100 kHz; where that leaves one out, as at other
    // rates. A mode that was lost nearby is sought at one rate alone.
    constexpr std::array frequencies{1e5, 3e5, 1e6, 3e4}; // [Hz]
    const bool asBefore = !near.empty() && known.size() == near.size();
    for (const double frequency : std::span(frequencies).first(asBefore ? 1 : frequencies.size())) {
        if (complete() || !asked()) break;
        for (const Mode& trial : trials(film({0.0, 2.0 * std::numbers::pi * frequency}), known))
            if (!complete() && asked()) followed(trial);
    }
    // The film answers with roots of its own, which decay within few periods. Where one of them was met, a mode that
    // decays more slowly may have been passed by: it is sought from the other rates.
    for (std::size_t k = 0; k < known.size() && !asBefore; ++k)
        for (const double frequency : frequencies) {
            if (decayOf(known[k].rate) < doubtfulDecay || !asked()) break;
            std::vector<Mode> others = known;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
            for (Mode& trial : trials(film({0.0, 2.0 * std::numbers::pi * frequency}), others))
                if (follow(trial, others, tolerance) && decayOf(trial.rate) < decayOf(known[k].rate))
                    known[k] = std::move(trial);
        }
    std::ranges::sort(known, {}, [](const Mode& mode) { return mode.rate.imag(); });
    return known;
}

// By central differences: the film knows its derivatives by the attitude, not those by each cell's gap.
SmallMotions::SurfaceAnswer SmallMotions::surfaceAnswer(std::span<const double> height)
{
    constexpr double step = 1e-12; // of the highest point [m]
    constexpr double rate = 1e6;   // of storage [1/s]
    const std::size_t size = level_.pressure.size();
    SurfaceAnswer answer{.flow = std::vector<double>(size, 0.0), .storage = std::vector<double>(size, 0.0)};
    double highest = 0.0;
    for (const double w : height) highest = std::max(highest, std::abs(w));
    if (highest == 0.0) return answer;

    GasFilm& film = level_.film;
    const Attitude attitude = film.attitude();
    std::vector<double> surface(size), residual(size), history(size);
    for (std::size_t at = 0; at < size; ++at) history[at] = rate * film.volumes()[at] * level_.pressure[at];
    for (const double sign : {1.0, -1.0}) {
        const double share = sign * step / highest, per = sign * highest / (2.0 * step);
        for (std::size_t at = 0; at < size; ++at) surface[at] = share * height[at];
        film.setSurface(surface);
        film.setAttitude(attitude);
        film.residual(level_.pressure, residual);
        for (std::size_t at = 0; at < size; ++at) {
            answer.flow[at] += per * residual[at];
            answer.storage[at] -= per * residual[at] / rate;
        }
        film.setStorage(rate, history);
        film.residual(level_.pressure, residual);
        for (std::size_t at = 0; at < size; ++at) answer.storage[at] += per * residual[at] / rate;
        film.setStorage(0.0, {});
        answer.force += per * body_.filmForce(level_.loads.loadAndShear(level_.pressure));
    }
    film.setSurface({});
    film.setAttitude(attitude);
    film.linearise(level_.pressure, residual);
    return answer;
}

ComplexMatrix3 SmallMotions::dynamic(Complex s, const Film& at) const
{
    ComplexMatrix3 sum = s * at.damping + at.stiffness + contact_;
    sum.diagonal() += s * s * mass() + s * body_.dampers() + body_.springs();
    return sum;
}

ComplexMatrix3 SmallMotions::dynamicSlope(Complex s, const Film& near)
{
    // K_f and C_f change slowly: this difference leaves out a term of second order, about this share of their change.
    constexpr double apart = 1e-3; // of s
    const Complex there = (1.0 + apart) * s;
    const Film at = film(there);
    ComplexMatrix3 sum = ((at.stiffness + there * at.damping) - (near.stiffness + s * near.damping)) / (there - s);
    sum.diagonal() += 2.0 * s * mass() + body_.dampers();
    return sum;
}

ComplexVector3 SmallMotions::force(Complex s, std::span<const double> real, std::span<const double> imaginary,
                                   std::span<const double> present)
{
    const Complex i(0.0, 1.0);
    const SurfaceAnswer first = surfaceAnswer(real), second = surfaceAnswer(imaginary);
    std::vector<Complex> source(first.flow.size());
    for (std::size_t at = 0; at < source.size(); ++at)
        source[at] = first.flow[at] + i * second.flow[at] + s * (first.storage[at] + i * second.storage[at]);
    if (!present.empty()) {
        const SurfaceAnswer before = surfaceAnswer(present);
        for (std::size_t at = 0; at < source.size(); ++at) source[at] -= before.storage[at];
    }
    converged_ = true;
    ComplexVector3 force = oscillation_->answer(s, source, byPressure_, converged_) + first.force + i * second.force;
    if (body_.holdsRoll()) force[2] = 0.0;
    return force;
}

} // namespace touchdown
