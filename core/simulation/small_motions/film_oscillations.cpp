// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/film_oscillations.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "core/physics/film/film_oscillation.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr int mostPasses = 30;         // for one rate
constexpr double rateTolerance = 1e-5; // of |g(s) - s|/|s| [-]
constexpr double farthestSecant = 5.0; // a secant's step, of |g(s) - s| [-]

/// What the film, steady at its attitude, answers to motions exp(s t) about it, with the torques of its shear.
class FilmAnswer {
public:
    FilmAnswer(FilmLevel& level, double shearArm, double length, Eigen::Index columns,
               const std::function<bool()>& goOn)
        : length_(length), columns_(static_cast<std::size_t>(columns))
    {
        std::vector<double> residual(level.pressure.size());
        level.film.linearise(level.pressure, residual);
        oscillation_.emplace(level.film, level.pressure);
        oscillation_->ask(goOn);
        FilmLoads::Derivatives forces;
        level.loads.derivatives(level.pressure, forces);
        for (std::size_t k = 0; k < 3; ++k) {
            byPressure_[k] = forces.byPressure[k];
            byAttitude_[k] = forces.byAttitude[k];
            if (k == 0) continue;
            for (std::size_t at = 0; at < byPressure_[k].size(); ++at)
                byPressure_[k][at] -= shearArm * forces.byPressure[k + 2][at];
            for (std::size_t m = 0; m < 3; ++m) byAttitude_[k][m] -= shearArm * forces.byAttitude[k + 2][m];
        }
    }

    /// Z(s) about the mass centre [N/m ...].
    Eigen::Matrix3cd at(Complex s)
    {
        converged_ = true;
        const ComplexMatrix3 z = oscillation_->stiffness(s, byPressure_, byAttitude_, converged_, columns_);
        Eigen::Matrix3cd result;
        for (int k = 0; k < 3; ++k)
            for (int m = 0; m < 3; ++m) result(k, m) = z[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)];
        result.col(1) -= 0.5 * length_ * result.col(0);
        return result;
    }
    /// Whether the film was solved at the last s.
    bool converged() const { return converged_; }

private:
    double length_; // [m]
    std::size_t columns_;
    std::optional<FilmOscillation> oscillation_;
    std::array<std::vector<double>, 3> byPressure_;
    std::array<std::array<double, 3>, 3> byAttitude_{};
    bool converged_ = true;
};

class OscillationSearch {
public:
    OscillationSearch(FilmBalance& balance, ContactRegion region, const std::function<bool()>& goOn)
        : body_(balance.body()),
          slider_(balance.setup().slider),
          unknowns_(balance.unknowns()),
          goOn_(goOn),
          touch_(balance.contactStiffness(region)),
          film_(balance.level(), body_.shearArm(), slider_.length, unknowns_, goOn)
    {}

    FilmOscillations search(const FilmOscillations& near)
    {
        for (Complex s : near.rates)
            if (goOn_() && !complete() && follow(s)) known_.push_back(s);
        // Trials: the oscillations that there would be if the film answered as at these rates. What was lost nearby is
        // sought at one alone.
        constexpr std::array<double, 3> frequencies{1e5, 3e5, 1e6}; // [Hz]
        const bool asBefore = !near.rates.empty() && known_.size() == near.rates.size();
        for (const double frequency : std::span(frequencies).first(asBefore ? 1 : frequencies.size())) {
            if (!goOn_() || complete()) break;
            for (Complex s : unknownOf(trials({0.0, 2.0 * std::numbers::pi * frequency})))
                if (goOn_() && !complete() && follow(s)) known_.push_back(s);
        }
        std::ranges::sort(known_, [](Complex a, Complex b) { return a.real() > b.real(); });
        const int lost = static_cast<int>(unknowns_) - static_cast<int>(known_.size());
        return {std::move(known_), lost};
    }

private:
    bool complete() const { return known_.size() == static_cast<std::size_t>(unknowns_); }

    bool follow(Complex& s)
    {
        Complex before, missedBefore;
        for (int pass = 0; pass < mostPasses && goOn_(); ++pass) {
            const std::vector<Complex> left = unknownOf(trials(s));
            if (!film_.converged() || left.empty()) return false;
            const Complex next = *std::ranges::min_element(left, {}, [&](Complex each) { return std::abs(each - s); });
            const Complex missed = next - s;
            if (std::abs(missed) <= rateTolerance * std::abs(s)) {
                s = next;
                return true;
            }
            Complex step = missed;
            if (pass > 0 && missed != missedBefore) {
                const Complex secant = -missed * (s - before) / (missed - missedBefore);
                if (std::abs(secant) < farthestSecant * std::abs(missed) && (s + secant).imag() > 0.0) step = secant;
            }
            before = s;
            missedBefore = missed;
            s += step;
        }
        return false;
    }

    /// The oscillations that there would be if the film answered at all rates as at s.
    std::vector<Complex> trials(Complex s)
    {
        constexpr double perRate = 1e-6; // [s]
        const Eigen::Matrix3cd answer = film_.at(s);
        Eigen::Matrix3d damping = answer.imag() / s.imag();
        Eigen::Matrix3d stiffness = answer.real() - s.real() * damping + touch_;
        Eigen::Matrix3d toMass = Eigen::Matrix3d::Zero();
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            stiffness(i, i) += body_.springs()[k];
            damping(i, i) += body_.dampers()[k];
            toMass(i, i) = 1.0 / body_.inertia()[k];
        }
        const Eigen::Vector3d scale(1.0, 1.0 / slider_.length, 1.0 / slider_.width);
        const Eigen::Matrix3d K = scale.asDiagonal().inverse() * (toMass * stiffness) * scale.asDiagonal();
        const Eigen::Matrix3d C = scale.asDiagonal().inverse() * (toMass * damping) * scale.asDiagonal();
        const Eigen::Index n = unknowns_;
        Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
        companion.topRightCorner(n, n).setIdentity();
        companion.bottomLeftCorner(n, n) = -K.topLeftCorner(n, n) * (perRate * perRate);
        companion.bottomRightCorner(n, n) = -C.topLeftCorner(n, n) * perRate;
        std::vector<Complex> list;
        if (!companion.allFinite()) return list;
        const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(companion, false).eigenvalues() / perRate;
        for (const Complex value : values)
            if (value.imag() > 1e-6 * std::abs(value)) list.push_back(value);
        std::ranges::sort(list, {}, [](Complex value) { return value.imag(); });
        return list;
    }
    /// Without the nearest to each of the known ones.
    std::vector<Complex> unknownOf(std::vector<Complex> list) const
    {
        for (const Complex rate : known_) {
            const auto same = std::ranges::min_element(list, {}, [&](Complex each) { return std::abs(each - rate); });
            if (same != list.end()) list.erase(same);
        }
        return list;
    }

    const SliderBody& body_;
    const SliderCase& slider_;
    Eigen::Index unknowns_;
    const std::function<bool()>& goOn_;
    Eigen::Matrix3d touch_;
    FilmAnswer film_;
    std::vector<Complex> known_;
};

} // namespace

FilmOscillations filmOscillations(FilmBalance& balance, ContactRegion region, const FilmOscillations& near,
                                  const std::function<bool()>& goOn)
{
    return OscillationSearch(balance, region, goOn).search(near);
}

double resolvedFrequency(FilmBalance& balance)
{
    constexpr double enough = 10.0; // cells
    const Case& c = balance.setup();
    return 0.5 * c.disk.speed * c.disk.radius * balance.level().gaps.grid.nx() / (enough * c.slider.length);
}

} // namespace touchdown
