// SPDX-License-Identifier: GPL-3.0-or-later
//
// Air bearing modes: the s for which (s^2 M + s C + K + Z(s)) q = 0 has a solution q = (height of the mass centre, pitch, roll),
// with M, C, K of slider and suspension and Z of the film. For a trial s the film is written as Z = K_f + s C_f with real
// K_f, C_f; the eigenvalue of that quadratic problem next to s is the next trial. Where it stays, the equation holds exactly.
// The eigenvalue that stands for a mode already found is left out, else two trials may end at one mode.
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "core/physics/film_oscillation.h"
#include "core/simulation/film_setup.h"
#include "core/simulation/steady.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

struct Film {
    Eigen::Matrix3d stiffness, damping; // K_f, C_f
};

class ModeSolver {
public:
    ModeSolver(const Case& c, const SteadyResult& state)
        : case_(c), recess_(c.surface, c.slider.length, c.slider.width), spacing_(c.surface, recess_),
          level_(c, recess_, spacing_, state.grid)
    {
        level_.gaps.pad.pad<double>(state.pressure, level_.pressure);
        level_.film.setAttitude(state.attitude);
        std::vector<double> residual(level_.pressure.size());
        level_.film.linearise(level_.pressure, residual);
        oscillation_ = std::make_unique<FilmOscillation>(level_.film, level_.pressure);
        GasFilm::ForceDerivatives forces;
        level_.film.forceDerivatives(level_.pressure, forces);
        // The torques of the shear are part of what the static state balances.
        const double arm = sliderLoad(c).shearArm;
        for (std::size_t k = 0; k < 3; ++k) {
            byPressure_[k] = forces.byPressure[k];
            byAttitude_[k] = forces.byAttitude[k];
            if (k == 0) continue;
            for (std::size_t at = 0; at < byPressure_[k].size(); ++at) byPressure_[k][at] -= arm * forces.byPressure[k + 2][at];
            for (std::size_t m = 0; m < 3; ++m) byAttitude_[k][m] -= arm * forces.byAttitude[k + 2][m];
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

    /// About the mass centre; s must not be real.
    Film film(Complex s)
    {
        converged_ = true;
        const ComplexMatrix3 z = oscillation_->stiffness(s, byPressure_, byAttitude_, converged_);
        Film result;
        for (int k = 0; k < 3; ++k)
            for (int m = 0; m < 3; ++m) {
                // The trailing edge's height falls by half the length times the pitch when the centre keeps its own.
                Complex entry = z[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)];
                if (case_.degreesOfFreedom == 2 && (k == 2 || m == 2)) entry = 0.0;
                else if (m == 1) entry -= 0.5 * case_.slider.length * z[static_cast<std::size_t>(k)][0];
                result.damping(k, m) = entry.imag() / s.imag();
                result.stiffness(k, m) = entry.real() - s.real() * result.damping(k, m);
            }
        return result;
    }

    struct Eigen6 {
        Eigen::VectorXcd values;
        Eigen::MatrixXcd vectors;
    };
    Eigen6 eigenvalues(const Film& film) const
    {
        Eigen::Matrix<double, 6, 6> companion = Eigen::Matrix<double, 6, 6>::Zero();
        // In slider lengths and microseconds the entries are alike in size.
        const Eigen::Vector3d scale(1.0, 1.0 / case_.slider.length, 1.0 / case_.slider.width);
        const Eigen::Matrix3d toMass = mass_.inverse();
        const Eigen::Matrix3d K = scale.asDiagonal().inverse() * (toMass * (springs_ + film.stiffness)) * scale.asDiagonal();
        const Eigen::Matrix3d C = scale.asDiagonal().inverse() * (toMass * (dampers_ + film.damping)) * scale.asDiagonal();
        companion.topRightCorner<3, 3>() = Eigen::Matrix3d::Identity();
        companion.bottomLeftCorner<3, 3>() = -K * (perRate * perRate);
        companion.bottomRightCorner<3, 3>() = -C * perRate;
        const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> solver(companion);
        return {solver.eigenvalues() / perRate, scale.asDiagonal() * solver.eigenvectors().topRows<3>()};
    }

    static auto nearest(const Eigen6& eigen, const std::vector<Eigen::Index>& among, Complex s)
    {
        const auto nearer = [&](Eigen::Index a, Eigen::Index b) { return std::abs(eigen.values[a] - s) < std::abs(eigen.values[b] - s); };
        return std::min_element(among.begin(), among.end(), nearer);
    }

    /// Those that oscillate, but for the nearest to each of the known modes.
    static std::vector<Eigen::Index> unknown(const Eigen6& eigen, const std::vector<Complex>& known)
    {
        std::vector<Eigen::Index> left;
        for (Eigen::Index k = 0; k < 6; ++k)
            if (eigen.values[k].imag() > 1e-6 * std::abs(eigen.values[k])) left.push_back(k);
        for (const Complex mode : known)
            if (const auto same = nearest(eigen, left, mode); same != left.end()) left.erase(same);
        return left;
    }

    /// Follows one eigenvalue to where it stays; false if it does not, if it turns real or the film is not solved.
    bool follow(Complex& s, Eigen::Vector3cd& shape, const std::vector<Complex>& known)
    {
        for (int pass = 0; pass < 40; ++pass) {
            const Eigen6 eigen = eigenvalues(film(s));
            const std::vector<Eigen::Index> left = unknown(eigen, known);
            if (!converged_ || left.empty()) return false;
            const Eigen::Index next = *nearest(eigen, left, s);
            shape = eigen.vectors.col(next);
            const double change = std::abs(eigen.values[next] - s);
            s = eigen.values[next];
            if (change <= 1e-9 * std::abs(s)) return true;
        }
        return false;
    }

    /// Whether the film was solved at the last s.
    bool converged() const { return converged_; }

private:
    static constexpr double perRate = 1e-6; // [s]

    const Case& case_;
    Recess recess_;
    MinimumSpacing spacing_;
    FilmLevel level_;
    std::unique_ptr<FilmOscillation> oscillation_;
    std::array<std::vector<double>, 3> byPressure_;
    std::array<std::array<double, 3>, 3> byAttitude_{};
    Eigen::Matrix3d mass_, springs_, dampers_;
    bool converged_ = true;
};

AirBearingMode describe(const Case& c, Complex s, const Eigen::Vector3cd& shape)
{
    const double length = c.slider.length, width = c.slider.width;
    Complex largest = 0.0;
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
            const Complex corner = shape[0] - x * length * shape[1] - y * width * shape[2];
            if (std::abs(corner) > std::abs(largest)) largest = corner;
        }
    AirBearingMode mode;
    mode.frequency = s.imag() / (2.0 * std::numbers::pi);
    mode.dampingRatio = -s.real() / std::abs(s);
    const std::array<double, 3> parts{std::abs(shape[0]), 0.5 * length * std::abs(shape[1]), 0.5 * width * std::abs(shape[2])};
    constexpr std::array names{"vertical", "pitch", "roll"};
    mode.kind = names[static_cast<std::size_t>(std::max_element(parts.begin(), parts.end()) - parts.begin())];
    for (int k = 0; k < 3; ++k) {
        const Complex part = shape[k] / largest;
        mode.shape[static_cast<std::size_t>(k)] = {part.real(), part.imag()};
    }
    return mode;
}

/// Says so where the grid is too coarse for the modes. The disk drags what a mode presses into the film along at half its speed U,
/// in waves U/(2 f) long. Of a few cells each they fade or come too early under the next pad, and take from the damping ratio
/// there or add to it: 5 % at ten cells, its sign at three.
std::string coarseGrid(const Case& c, const ModesResult& result)
{
    constexpr double enough = 10.0; // cells along a wave
    const double speed = c.disk.speed * c.disk.radius, cell = c.slider.length / result.steady.grid.nx();
    const double highest = 0.5 * speed / (enough * cell); // [Hz]
    if (speed == 0.0 || result.modes.empty() || result.modes.back().frequency <= highest) return {};
    return "above " + std::to_string(std::lround(highest / 1e3)) +
           " kHz the waves that the disk drags along span fewer than ten cells: damping ratios there need a finer grid";
}

} // namespace

ModesResult modes(const Case& c, const SteadyCallback& callback)
{
    ModesResult result;
    result.steady = steady(c, callback);
    result.status = result.steady.status;
    result.message = result.steady.message;
    if (result.status != SteadyStatus::Converged) return result;

    ModeSolver solver(c, result.steady);
    const auto tell = [&](const std::string& stage) {
        const bool goOn = !callback || callback({.stage = stage, .iteration = 0, .residual = result.steady.residual,
                                                 .loadError = result.steady.loadError, .attitude = result.steady.attitude});
        if (!goOn) {
            result.status = SteadyStatus::Cancelled;
            result.message = "cancelled while the modes were sought";
        }
        return goOn;
    };
    // Trials: the modes that the film would have if it answered as at 100 kHz; where that leaves one out, as at other rates.
    std::vector<Complex> known;
    const auto wanted = static_cast<std::size_t>(c.degreesOfFreedom);
    for (const double frequency : {1e5, 3e5, 1e6, 3e4}) { // [Hz]
        if (known.size() == wanted) break;
        const ModeSolver::Eigen6 first = solver.eigenvalues(solver.film({0.0, 2.0 * std::numbers::pi * frequency}));
        std::vector<Complex> trials;
        for (const Eigen::Index k : solver.unknown(first, known)) trials.push_back(first.values[k]);
        std::sort(trials.begin(), trials.end(), [](Complex a, Complex b) { return a.imag() < b.imag(); });
        for (Complex s : trials) {
            if (known.size() == wanted) break;
            if (!tell("mode " + std::to_string(known.size() + 1))) return result;
            Eigen::Vector3cd shape;
            if (!solver.follow(s, shape, known)) continue;
            known.push_back(s);
            result.modes.push_back(describe(c, s, shape));
        }
    }
    const std::size_t lost = wanted - known.size();
    std::sort(result.modes.begin(), result.modes.end(),
              [](const AirBearingMode& a, const AirBearingMode& b) { return a.frequency < b.frequency; });
    bool filmSolved = true;
    for (int k = 0; k <= 8; ++k) {
        const double frequency = 1e4 * std::pow(10.0, 0.25 * k); // 10 kHz to 1 MHz
        if (!tell("dynamic stiffness")) return result;
        const Film film = solver.film({0.0, 2.0 * std::numbers::pi * frequency});
        filmSolved = filmSolved && solver.converged();
        DynamicStiffness entry{.frequency = frequency};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                entry.stiffness[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = film.stiffness(row, column);
                entry.damping[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = film.damping(row, column);
            }
        result.stiffness.push_back(entry);
    }
    const auto add = [&result](const std::string& sentence) {
        if (!result.message.empty() && !sentence.empty()) result.message += "; ";
        result.message += sentence;
    };
    if (lost > 0)
        add(std::to_string(lost) + (lost == 1 ? " mode is" : " modes are") +
            " so strongly damped that it does not oscillate, or could not be followed");
    add(coarseGrid(c, result));
    if (!filmSolved) {
        result.status = SteadyStatus::NotConverged;
        result.message = "a linear system of the oscillating film was not solved to 1e-8";
    }
    return result;
}

} // namespace touchdown
