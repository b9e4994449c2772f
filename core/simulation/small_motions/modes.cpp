// SPDX-License-Identifier: GPL-3.0-or-later
//
// Air bearing modes of a case, and the dynamic stiffness of its film over frequency: see
// small_motions.h.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/small_motions/mode_errors.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "core/work/team.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

using Complex = SmallMotions::Complex;

AirBearingMode describe(const Case& c, Complex s, const ComplexVector3& shape)
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

/// A sentence where the grid leaves the sign of a damping ratio open, or its error is not known.
std::string doubtfulModes(const ModesResult& result)
{
    std::size_t doubtful = 0, unknown = 0;
    for (const AirBearingMode& mode : result.modes) {
        if (std::isnan(mode.dampingError)) ++unknown;
        if (mode.dampingError >= std::abs(mode.dampingRatio)) ++doubtful;
    }
    if (unknown > 0) return "the errors of the modes are not known: no coarser grid has them all";
    if (doubtful == 0) return {};
    return std::to_string(doubtful) + (doubtful == 1 ? " mode has a damping ratio" : " modes have damping ratios") +
           " below the error that the grid leaves: more film.nodes are needed";
}

} // namespace

ModesResult modes(const Case& c, const SteadyCallback& callback)
{
    const TeamScope team(filmThreads(c));
    ModesResult result;
    result.steady = steadyWithContact(c, callback);
    result.status = result.steady.status;
    result.message = result.steady.message;
    if (result.status != SteadyStatus::Converged) return result;

    const std::unique_ptr<FilmBalance> slider = FilmBalance::at(
        c, result.steady, [&] { return !callback || callback(progressAbout(result.steady, "contact")); });
    if (!slider) {
        result.status = SteadyStatus::Cancelled;
        result.message = "cancelled while the modes were sought";
        return result;
    }
    SmallMotions solver(slider->level(), slider->body(), slider->contactStiffness(result.steady.contact.region),
                        slider->filmSlopes());
    std::string stage;
    double reported = 0.0;
    const auto report = [&](const std::string& doing) {
        if (result.status == SteadyStatus::Cancelled) return false;
        stage = doing;
        reported = wallClock();
        const bool goOn = !callback || callback(progressAbout(result.steady, stage));
        if (!goOn) {
            result.status = SteadyStatus::Cancelled;
            result.message = "cancelled while the modes were sought";
        }
        return goOn;
    };
    constexpr double longestSilence = 0.03; // [s]
    solver.ask([&] {
        return (result.status != SteadyStatus::Cancelled && wallClock() - reported < longestSilence) || report(stage);
    });
    const std::vector<SmallMotions::Mode> found =
        solver.find(1e-9, [&](std::size_t known) { return report("mode " + std::to_string(known + 1)); });
    if (result.status == SteadyStatus::Cancelled) return result;
    for (const SmallMotions::Mode& mode : found) result.modes.push_back(describe(c, mode.rate, mode.shape));
    const std::size_t lost = static_cast<std::size_t>(c.degreesOfFreedom) - found.size();
    bool filmSolved = true;
    for (int k = 0; k <= 8; ++k) {
        const double frequency = 1e4 * std::pow(10.0, 0.25 * k); // 10 kHz to 1 MHz
        if (!report("dynamic stiffness")) return result;
        const SmallMotions::Film answer = solver.film({0.0, 2.0 * std::numbers::pi * frequency});
        if (result.status == SteadyStatus::Cancelled) return result;
        filmSolved = filmSolved && solver.converged();
        result.stiffness.push_back({frequency, answer.stiffness, answer.damping});
    }
    std::vector<Complex> rates;
    for (const SmallMotions::Mode& mode : found) rates.push_back(mode.rate);
    const std::vector<Complex> half = coarserRates(c, result.steady, 0.5, rates, report);
    const std::vector<Complex> quarter = half.empty() ? half : coarserRates(c, result.steady, 0.25, rates, report);
    if (result.status == SteadyStatus::Cancelled) return result;
    setErrors(result.modes, rates, half, quarter);
    const auto add = [&result](const std::string& sentence) {
        if (!result.message.empty() && !sentence.empty()) result.message += "; ";
        result.message += sentence;
    };
    if (lost > 0)
        add(std::to_string(lost) + (lost == 1 ? " mode is" : " modes are") +
            " so strongly damped that it does not oscillate, or could not be followed");
    add(doubtfulModes(result));
    if (!filmSolved) {
        result.status = SteadyStatus::NotConverged;
        result.message = "a linear system of the oscillating film was not solved to 1e-8";
    }
    return result;
}

} // namespace touchdown
