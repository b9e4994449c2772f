// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/slip.h"

#include <array>
#include <cassert>
#include <numbers>

#include "core/physics/film/kinetic_flow_rate.h"

namespace touchdown {

std::span<const std::string_view> slipModelNames()
{
    static constexpr std::array<std::string_view, 9> names{"continuum",       "first-order",      "second-order",
                                                           "1.5-order",       "fukui-kaneko",     "fukui-kaneko-fit",
                                                           "new-first-order", "new-second-order", "combination"};
    return names;
}

double inverseKnudsen(double knudsen) { return 0.5 / std::numbers::inv_sqrtpi / knudsen; }

SlipExpansion slipExpansion(SlipModel model, double accommodation)
{
    const double a = (2.0 - accommodation) / accommodation;
    switch (model) {
    case SlipModel::Continuum: return {0.0, 0.0};
    case SlipModel::FirstOrder: return {6.0 * a, 0.0};
    case SlipModel::SecondOrder: return {6.0, 6.0};
    case SlipModel::OnePointFiveOrder: return {6.0 * a, 8.0 / 3.0};
    case SlipModel::NewFirstOrder: return {4.0 * a, 0.0};
    case SlipModel::NewSecondOrder: return {4.0 * a, 3.0};
    case SlipModel::FukuiKaneko:
    case SlipModel::FukuiKanekoFit:
    case SlipModel::Combination: break;
    }
    assert(!"no expansion in Kn");
    return {};
}

double flowFactor(const Slip& slip, double knudsen)
{
    assert(slip.model != SlipModel::Combination);
    const double d = inverseKnudsen(knudsen);
    if (slip.model == SlipModel::FukuiKaneko) return 6.0 * kineticFlowRate(d).value / d;
    if (slip.model == SlipModel::FukuiKanekoFit) return 6.0 * fittedFlowRate(d).value / d;
    const SlipExpansion q = slipExpansion(slip.model, slip.accommodation);
    return 1.0 + knudsen * (q.first + knudsen * q.second);
}

} // namespace touchdown
