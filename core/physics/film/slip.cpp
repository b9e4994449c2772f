// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/slip.h"

#include <array>
#include <cassert>
#include <numbers>

#include "core/physics/film/kinetic_flow_rate.h"
#include "core/physics/film/slip_model.h"

namespace touchdown {

const SlipModel usualSlip = SlipModel::FukuiKaneko;

std::span<const SlipLaw> slipLaws()
{
    static constexpr std::array<SlipLaw, 9> laws{{
        {"continuum", true},
        {"first-order", true, 6.0},
        {"second-order", false, 6.0, 6.0},
        {"1.5-order", true, 6.0, 8.0 / 3.0},
        {"fukui-kaneko", false, 0.0, 0.0, kineticFlowRate},
        {"fukui-kaneko-fit", false, 0.0, 0.0, fittedFlowRate, false},
        {"new-first-order", true, 4.0},
        {"new-second-order", true, 4.0, 3.0},
        {"combination", false}, // of two others: FlowTable
    }};
    return laws;
}

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
