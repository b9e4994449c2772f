// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/film_modes.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchdown {

using Complex = FilmModes::Complex;

FilmModes::FilmModes(const Case& c, const SteadyResult& state)
    : case_(c),
      state_(state),
      recess_(c.surface, c.slider.length, c.slider.width),
      spacing_(c.surface, recess_),
      level_(c, recess_, spacing_, state.grid),
      shearArm_(sliderLoad(c).shearArm)
{
    level_.gaps.pad.pad<double>(state.pressure, level_.pressure);
    level_.film.setAttitude(state.attitude);
    std::vector<double> residual(level_.pressure.size());
    level_.film.linearise(level_.pressure, residual);
    oscillation_ = std::make_unique<FilmOscillation>(level_.film, level_.pressure);
    FilmLoads::Derivatives forces;
    level_.loads.derivatives(level_.pressure, forces);
    // The torques of the shear are part of what the static state balances.
    for (std::size_t k = 0; k < 3; ++k) {
        byPressure_[k] = forces.byPressure[k];
        byAttitude_[k] = forces.byAttitude[k];
        if (k == 0) continue;
        for (std::size_t at = 0; at < byPressure_[k].size(); ++at)
            byPressure_[k][at] -= shearArm_ * forces.byPressure[k + 2][at];
        for (std::size_t m = 0; m < 3; ++m) byAttitude_[k][m] -= shearArm_ * forces.byAttitude[k + 2][m];
    }
    const SliderCase& slider = c.slider;
    mass_ = Eigen::Vector3d(slider.mass, slider.pitchInertia, slider.rollInertia).asDiagonal();
    const SuspensionCase& s = c.suspension;
    springs_ = Eigen::Vector3d(s.stiffness, s.pitchStiffness, s.rollStiffness).asDiagonal();
    dampers_ = Eigen::Vector3d(s.damping, s.pitchDamping, s.rollDamping).asDiagonal();
    if (c.degreesOfFreedom == 2) {
        // A roll that is held is overdamped, apart from the others.
        constexpr double rate = 1e8; // [1/s]
        springs_(2, 2) = 2.0 * rate * rate * slider.rollInertia;
        dampers_(2, 2) = 3.0 * rate * slider.rollInertia;
    }
}

FilmModes::Film FilmModes::film(Complex s)
{
    converged_ = true;
    const ComplexMatrix3 z = oscillation_->stiffness(s, byPressure_, byAttitude_, converged_);
    Film result;
    for (int k = 0; k < 3; ++k)
        for (int m = 0; m < 3; ++m) {
            // The trailing edge's height falls by half the length times the pitch when the centre keeps its own.
            Complex entry = z[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)];
            if (case_.degreesOfFreedom == 2 && (k == 2 || m == 2))
                entry = 0.0;
            else if (m == 1)
                entry -= 0.5 * case_.slider.length * z[static_cast<std::size_t>(k)][0];
            result.damping(k, m) = entry.imag() / s.imag();
            result.stiffness(k, m) = entry.real() - s.real() * result.damping(k, m);
        }
    return result;
}

FilmModes::Eigen6 FilmModes::eigenvalues(const Film& film) const
{
    Eigen::Matrix<double, 6, 6> companion = Eigen::Matrix<double, 6, 6>::Zero();
    // In slider lengths and microseconds the entries are alike in size.
    const Eigen::Vector3d scale = this->scale();
    const Eigen::Matrix3d toMass = mass_.inverse();
    const Eigen::Matrix3d K =
        scale.asDiagonal().inverse() * (toMass * (springs_ + film.stiffness)) * scale.asDiagonal();
    const Eigen::Matrix3d C = scale.asDiagonal().inverse() * (toMass * (dampers_ + film.damping)) * scale.asDiagonal();
    companion.topRightCorner<3, 3>() = Eigen::Matrix3d::Identity();
    companion.bottomLeftCorner<3, 3>() = -K * (perRate * perRate);
    companion.bottomRightCorner<3, 3>() = -C * perRate;
    const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> solver(companion);
    return {solver.eigenvalues() / perRate, scale.asDiagonal() * solver.eigenvectors().topRows<3>()};
}

std::vector<Eigen::Index>::const_iterator FilmModes::nearest(const Eigen6& eigen,
                                                             const std::vector<Eigen::Index>& among, Complex s)
{
    const auto nearer = [&](Eigen::Index a, Eigen::Index b) {
        return std::abs(eigen.values[a] - s) < std::abs(eigen.values[b] - s);
    };
    return std::min_element(among.begin(), among.end(), nearer);
}

/// Those that oscillate, but for the nearest to each of the known modes.
std::vector<Eigen::Index> FilmModes::unknown(const Eigen6& eigen, const std::vector<Mode>& known)
{
    std::vector<Eigen::Index> left;
    for (Eigen::Index k = 0; k < 6; ++k)
        if (eigen.values[k].imag() > 1e-6 * std::abs(eigen.values[k])) left.push_back(k);
    for (const Mode& mode : known)
        if (const auto same = nearest(eigen, left, mode.rate); same != left.end()) left.erase(same);
    return left;
}

/// Follows one eigenvalue to where it stays; false if it does not, if it turns real or the film is not solved.
bool FilmModes::follow(Mode& mode, const std::vector<Mode>& known, double tolerance)
{
    for (int pass = 0; pass < 40; ++pass) {
        mode.film = film(mode.rate);
        const Eigen6 eigen = eigenvalues(mode.film);
        const std::vector<Eigen::Index> left = unknown(eigen, known);
        if (!converged_ || left.empty()) return false;
        const Eigen::Index next = *nearest(eigen, left, mode.rate);
        mode.shape = eigen.vectors.col(next);
        const double change = std::abs(eigen.values[next] - mode.rate);
        mode.rate = eigen.values[next];
        if (change <= tolerance * std::abs(mode.rate)) return true;
    }
    return false;
}

std::vector<FilmModes::Mode> FilmModes::find(const std::function<bool(std::size_t)>& goOn, double tolerance)
{
    // Trials: the modes that the film would have if it answered as at 100 kHz; where that leaves one out, as at other
    // rates.
    std::vector<Mode> known;
    const auto wanted = static_cast<std::size_t>(case_.degreesOfFreedom);
    for (const double frequency : {1e5, 3e5, 1e6, 3e4}) { // [Hz]
        if (known.size() == wanted) break;
        const Eigen6 first = eigenvalues(film({0.0, 2.0 * std::numbers::pi * frequency}));
        std::vector<Mode> trials;
        for (const Eigen::Index k : unknown(first, known)) trials.push_back({first.values[k], {}, {}});
        std::sort(trials.begin(), trials.end(),
                  [](const Mode& a, const Mode& b) { return a.rate.imag() < b.rate.imag(); });
        for (Mode trial : trials) {
            if (known.size() == wanted) break;
            if (goOn && !goOn(known.size())) return known;
            if (follow(trial, known, tolerance)) known.push_back(trial);
        }
    }
    std::sort(known.begin(), known.end(), [](const Mode& a, const Mode& b) { return a.rate.imag() < b.rate.imag(); });
    return known;
}

Vector3 FilmModes::forces()
{
    const std::array<double, 5> all = level_.loads.loadAndShear(level_.pressure);
    return {all[0], all[1] - shearArm_ * all[3], all[2] - shearArm_ * all[4]};
}

// By central differences: the film knows its derivatives by the attitude, not those by each cell's gap.
FilmModes::SurfaceAnswer FilmModes::surfaceAnswer(std::span<const double> height)
{
    constexpr double step = 1e-12; // of the highest point [m]
    constexpr double rate = 1e6;   // of storage [1/s]
    const std::size_t size = level_.pressure.size();
    SurfaceAnswer answer{.flow = std::vector<double>(size, 0.0), .storage = std::vector<double>(size, 0.0)};
    double highest = 0.0;
    for (const double w : height) highest = std::max(highest, std::abs(w));
    if (highest == 0.0) return answer;

    GasFilm& film = level_.film;
    std::vector<double> surface(size), residual(size), history(size);
    for (std::size_t at = 0; at < size; ++at) history[at] = rate * film.volumes()[at] * level_.pressure[at];
    for (const double sign : {1.0, -1.0}) {
        const double share = sign * step / highest, per = sign * highest / (2.0 * step);
        for (std::size_t at = 0; at < size; ++at) surface[at] = share * height[at];
        film.setSurface(surface);
        film.setAttitude(state_.attitude);
        film.residual(level_.pressure, residual);
        for (std::size_t at = 0; at < size; ++at) {
            answer.flow[at] += per * residual[at];
            answer.storage[at] -= per * residual[at] / rate;
        }
        film.setStorage(rate, history);
        film.residual(level_.pressure, residual);
        for (std::size_t at = 0; at < size; ++at) answer.storage[at] += per * residual[at] / rate;
        film.setStorage(0.0, {});
        const Vector3 load = forces();
        for (std::size_t k = 0; k < 3; ++k) answer.force[k] += per * load[k];
    }
    film.setSurface({});
    film.setAttitude(state_.attitude);
    film.linearise(level_.pressure, residual);
    return answer;
}

Eigen::Matrix3cd FilmModes::dynamic(Complex s, const Film& at) const
{
    return s * s * mass_ + s * (dampers_ + at.damping) + springs_ + at.stiffness;
}

Eigen::Matrix3cd FilmModes::dynamicSlope(Complex s, const Film& near)
{
    // K_f and C_f change slowly: what this difference leaves out, of second order, is about this share of what they
    // change by.
    constexpr double apart = 1e-3; // of s
    const Complex there = (1.0 + apart) * s;
    const Film at = film(there);
    const Eigen::Matrix3cd change = (at.stiffness + there * at.damping) - (near.stiffness + s * near.damping);
    return 2.0 * s * mass_ + dampers_ + change / (there - s);
}

Eigen::Vector3cd FilmModes::force(Complex s, std::span<const double> real, std::span<const double> imaginary,
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
    const std::array<Complex, 3> byPressure = oscillation_->answer(s, source, byPressure_, converged_);
    Eigen::Vector3cd force;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const auto row = static_cast<std::size_t>(k);
        force[k] = byPressure[row] + first.force[row] + i * second.force[row];
    }
    if (case_.degreesOfFreedom == 2) force[2] = 0.0;
    return force;
}

} // namespace touchdown
