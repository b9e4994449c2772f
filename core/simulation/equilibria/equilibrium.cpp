// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/equilibrium.h"

namespace touchdown {

std::string_view name(Stability stability)
{
    switch (stability) {
    case Stability::Stable: return "stable";
    case Stability::Neutral: return "neutral";
    case Stability::Flutter: return "unstable, oscillating";
    case Stability::Divergence: return "unstable";
    }
    return {};
}

std::string_view name(EquilibriumMark mark)
{
    switch (mark) {
    case EquilibriumMark::Fold: return "fold";
    case EquilibriumMark::Hopf: return "Hopf point";
    case EquilibriumMark::Switch: return "switch";
    case EquilibriumMark::Kink: return "kink";
    }
    return {};
}

} // namespace touchdown
