// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/mode_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

using Complex = std::complex<double>;

namespace {

constexpr double tolerance = 1e-6; // of a rate on a coarser grid [-]
constexpr double ofQuarter = 0.25; // share of the difference of the coarser grids that counts [-]
constexpr double ofLargest = 0.5;  // share of the largest difference of the slider's modes that counts [-]
constexpr int multiple = 16;       // of which numbers of cells are multiples

double damping(Complex s) { return -s.real() / std::abs(s); }

Complex nearest(std::span<const Complex> rates, Complex rate)
{
    return *std::ranges::min_element(rates, {}, [&](Complex other) { return std::abs(other - rate); });
}

/// Differences of a mode: damping ratio, frequency relative to itself [-].
struct Difference {
    double damping = 0.0, frequency = 0.0;
    Difference(Complex a, Complex b)
        : damping(std::abs(touchdown::damping(a) - touchdown::damping(b))),
          frequency(std::abs(a.imag() - b.imag()) / a.imag())
    {}
    Difference() = default;
    /// The larger of each.
    void cover(const Difference& other, double share)
    {
        damping = std::max(damping, share * other.damping);
        frequency = std::max(frequency, share * other.frequency);
    }
};

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
    const SteadyResult state = steady(there, [&](const SteadyProgress&) { return goOn(stage); });
    if (state.status != SteadyStatus::Converged) return {};
    StaticFilm film(there, state);
    SmallMotions solver(film.level, film.body);
    bool goesOn = true;
    const auto ask = [&] { return goesOn = goesOn && goOn(stage); };
    solver.ask(ask);
    std::vector<Complex> rates;
    for (const SmallMotions::Mode& mode : solver.find(
             tolerance, [&](std::size_t) { return ask(); }, near))
        rates.push_back(mode.rate);
    return goesOn && rates.size() >= near.size() ? rates : std::vector<Complex>{};
}

void setErrors(std::vector<AirBearingMode>& modes, std::span<const Complex> finest, std::span<const Complex> half,
               std::span<const Complex> quarter)
{
    if (half.empty()) return;
    std::vector<Difference> differences;
    Difference largest;
    for (const Complex s : finest) {
        const Complex s2 = nearest(half, s);
        Difference x(s, s2);
        if (!quarter.empty()) x.cover(Difference(s2, nearest(quarter, s2)), ofQuarter);
        largest.cover(x, 1.0);
        differences.push_back(x);
    }
    for (std::size_t k = 0; k < modes.size(); ++k) {
        differences[k].cover(largest, ofLargest);
        modes[k].dampingError = dampingErrorFactor * differences[k].damping;
        modes[k].frequencyError = frequencyErrorFactor * differences[k].frequency * modes[k].frequency;
    }
}

} // namespace touchdown
