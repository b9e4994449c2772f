// SPDX-License-Identifier: GPL-3.0-or-later
//
// Air bearing modes of a case, and what its film answers over frequency: see film_modes.h.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/numerics/wall_clock.h"
#include "core/simulation/small_motions/film_modes.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

namespace {

using Complex = FilmModes::Complex;

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
    const std::array<double, 3> parts{std::abs(shape[0]), 0.5 * length * std::abs(shape[1]),
                                      0.5 * width * std::abs(shape[2])};
    constexpr std::array names{"vertical", "pitch", "roll"};
    mode.kind = names[static_cast<std::size_t>(std::max_element(parts.begin(), parts.end()) - parts.begin())];
    for (int k = 0; k < 3; ++k) {
        const Complex part = shape[k] / largest;
        mode.shape[static_cast<std::size_t>(k)] = {part.real(), part.imag()};
    }
    return mode;
}

/// Says so where the grid is too coarse for the modes. The disk drags what a mode presses into the film along at half
/// its speed U, in waves U/(2 f) long. Of a few cells each they fade or come too early under the next pad, and take
/// from the damping ratio there or add to it: 5 % at ten cells, its sign at three.
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

    FilmModes solver(c, result.steady);
    std::string stage;
    double told = 0.0;
    const auto tell = [&](const std::string& doing) {
        if (result.status == SteadyStatus::Cancelled) return false;
        stage = doing;
        told = wallClock();
        const bool goOn = !callback || callback({.stage = stage,
                                                 .iteration = 0,
                                                 .residual = result.steady.residual,
                                                 .loadError = result.steady.loadError,
                                                 .attitude = result.steady.attitude});
        if (!goOn) {
            result.status = SteadyStatus::Cancelled;
            result.message = "cancelled while the modes were sought";
        }
        return goOn;
    };
    constexpr double longestSilence = 0.03; // [s]
    solver.ask([&] {
        return (result.status != SteadyStatus::Cancelled && wallClock() - told < longestSilence) || tell(stage);
    });
    const std::vector<FilmModes::Mode> found =
        solver.find([&](std::size_t known) { return tell("mode " + std::to_string(known + 1)); });
    if (result.status == SteadyStatus::Cancelled) return result;
    for (const FilmModes::Mode& mode : found) result.modes.push_back(describe(c, mode.rate, mode.shape));
    const std::size_t lost = static_cast<std::size_t>(c.degreesOfFreedom) - found.size();
    bool filmSolved = true;
    for (int k = 0; k <= 8; ++k) {
        const double frequency = 1e4 * std::pow(10.0, 0.25 * k); // 10 kHz to 1 MHz
        if (!tell("dynamic stiffness")) return result;
        const FilmModes::Film film = solver.film({0.0, 2.0 * std::numbers::pi * frequency});
        if (result.status == SteadyStatus::Cancelled) return result;
        filmSolved = filmSolved && solver.converged();
        DynamicStiffness entry{.frequency = frequency};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                entry.stiffness[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                    film.stiffness(row, column);
                entry.damping[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                    film.damping(row, column);
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
