// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/mode_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_balance.h"

namespace touchdown {

using Complex = std::complex<double>;

namespace {

constexpr double rateTolerance = 1e-6; // of a rate on a coarser grid [-]
constexpr double perHalving = 0.5;     // of an error of first order, when cells are halved [-]
constexpr int multiple = 16;           // of which numbers of cells are multiples

Complex nearest(std::span<const Complex> rates, Complex rate)
{
    return *std::ranges::min_element(rates, {}, [&](Complex other) { return std::abs(other - rate); });
}

} // namespace

std::vector<Complex> coarserRates(const Case& c, const SteadyResult& fine, double share, std::span<const Complex> near,
                                  const std::function<bool(const std::string& stage)>& goOn)
{
    const auto cells = [share](int count) {
        return static_cast<int>(std::lround(share * count / multiple)) * multiple;
    };
    const std::array<int, 2> coarse{cells(fine.grid.nx()), cells(fine.grid.ny())};
    if (std::min(coarse[0], coarse[1]) < 2 * multiple) return {};
    Case there = c;
    there.steady.stiffness = there.steady.sensitivities = there.steady.allEquilibria = false;
    there.film.accuracy = 0.0;
    there.film.nodes = {coarse[0] + 1, coarse[1] + 1};
    there.initial.nominalTrailingEdgeHeight = fine.attitude.height;
    there.initial.pitch = fine.attitude.pitch;
    there.initial.roll = fine.attitude.roll;
    const std::string stage =
        "modes on " + std::to_string(there.film.nodes[0]) + " x " + std::to_string(there.film.nodes[1]) + " nodes";
    const SteadyResult state = steadyWithContact(there, [&](const SteadyProgress&) { return goOn(stage); });
    if (state.status != SteadyStatus::Converged || state.contact.state != fine.contact.state) return {};
    bool goesOn = true;
    const auto ask = [&] { return goesOn = goesOn && goOn(stage); };
    const std::unique_ptr<FilmBalance> slider = FilmBalance::at(there, state, ask);
    if (!slider) return {};
    SmallMotions solver(slider->level(), slider->body(), slider->contactStiffness(state.contact.region),
                        slider->filmSlopes());
    solver.ask(ask);
    std::vector<Complex> rates;
    for (const SmallMotions::Mode& mode : solver.find(
             rateTolerance, [&](std::size_t) { return ask(); }, near))
        rates.push_back(mode.rate);
    return goesOn && rates.size() >= near.size() ? rates : std::vector<Complex>{};
}

void setErrors(std::vector<AirBearingMode>& modes, std::span<const Complex> finest, std::span<const Complex> half,
               std::span<const Complex> quarter)
{
    if (half.empty()) return;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const Complex s = finest[k], s2 = nearest(half, s);
        double apart = std::abs(s - s2);
        if (quarter.empty())
            apart /= perHalving;
        else
            apart = std::max(apart, perHalving * std::abs(s2 - nearest(quarter, s2)));
        apart /= std::abs(s);
        modes[k].dampingError = dampingErrorFactor * apart;
        modes[k].frequencyError = frequencyErrorFactor * apart * modes[k].frequency;
    }
}

} // namespace touchdown
