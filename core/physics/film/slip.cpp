// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/slip.h"

#include <array>
#include <cassert>
#include <numbers>

#include "core/physics/film/kinetic_flow_rate.h"
#include "core/physics/film/slip_model.h"

namespace touchdown {

const SlipModel usualSlip = SlipModel::FukuiKaneko;

namespace {

/// An enumerator without a row does not compile (-Wswitch).
constexpr SlipLaw rowOf(SlipModel model)
{
    switch (model) {
    case SlipModel::Continuum:
        return {.name = "continuum", .label = "no slip", .meaning = "The air sticks to the walls."};
    case SlipModel::FirstOrder:
        return {.name = "first-order",
                .label = "first order",
                .meaning = "Slip of first order (Burgdorfer 1959).",
                .first = 6.0};
    case SlipModel::SecondOrder:
        return {.name = "second-order",
                .label = "second order",
                .meaning = "Slip of second order (Hsia & Domoto 1983).",
                .knowsAccommodation = false,
                .first = 6.0,
                .second = 6.0};
    case SlipModel::OnePointFiveOrder:
        return {.name = "1.5-order",
                .label = "order 1.5",
                .meaning = "Slip of order 1.5 (Mitsuya 1993).",
                .first = 6.0,
                .second = 8.0 / 3.0};
    case SlipModel::FukuiKaneko:
        return {.name = "fukui-kaneko",
                .label = "kinetic",
                .meaning = "Kinetic theory, the values of Fukui & Kaneko 1988, 1990.",
                .knowsAccommodation = false,
                .rate = kineticFlowRate};
    case SlipModel::FukuiKanekoFit:
        return {.name = "fukui-kaneko-fit",
                .label = "kinetic, fitted",
                .meaning = "Kinetic theory by the fit that Fukui & Kaneko published.",
                .knowsAccommodation = false,
                .rate = fittedFlowRate,
                .tabulated = false};
    case SlipModel::NewFirstOrder:
        return {.name = "new-first-order",
                .label = "new first order",
                .meaning = "Slip of first order by Wu & Bogy 2003.",
                .first = 4.0};
    case SlipModel::NewSecondOrder:
        return {.name = "new-second-order",
                .label = "new second order",
                .meaning = "Slip of second order by Wu & Bogy 2003.",
                .first = 4.0,
                .second = 3.0};
    case SlipModel::Combination: // FlowTable
        return {.name = "combination",
                .label = "combined (paper)",
                .meaning = "Kinetic; where the gap is small, new second order.",
                .knowsAccommodation = false};
    }
    return {}; // beyond the last enumerator
}

constexpr std::size_t countLaws()
{
    std::size_t count = 0;
    while (!rowOf(static_cast<SlipModel>(count)).name.empty()) ++count;
    return count;
}

constexpr auto laws = [] {
    std::array<SlipLaw, countLaws()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = rowOf(static_cast<SlipModel>(i));
    return rows;
}();

} // namespace

std::span<const SlipLaw> slipLaws() { return laws; }

const SlipLaw& slipLaw(SlipModel model) { return slipLaws()[static_cast<std::size_t>(model)]; }

double inverseKnudsen(double knudsen) { return 0.5 / std::numbers::inv_sqrtpi / knudsen; }

double flowFactor(const Slip& slip, double knudsen)
{
    assert(slip.model != SlipModel::Combination);
    const SlipLaw& law = slipLaw(slip.model);
    if (law.rate) {
        const double d = inverseKnudsen(knudsen);
        return 6.0 * law.rate(d).value / d;
    }
    return 1.0 + knudsen * (law.firstOrder(slip.accommodation) + knudsen * law.second);
}

} // namespace touchdown
