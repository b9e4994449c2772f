// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cycle followed in one parameter by pseudo-arclength (core/numerics/continuation.h), through folds.
//
//   fold               a real multiplier passes 1: two cycles meet (saddle-node)
//   period doubling    a real multiplier passes -1
//   Neimark-Sacker     a complex pair leaves the unit circle
//   grazing            the set of switches along the cycle changes: the motion touches the end of an interval of the
//                      law without crossing it. The return map has a kink or a jump there. The cycle is sought beyond,
//                      also with one crossing of the section more or less, and the branch ends where there is none.
//
// Stable and unstable parts follow from the multipliers at each point.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/studies/cycles/limit_cycle.h"

namespace touchdown {

enum class CycleMark : std::uint8_t { Fold, PeriodDoubling, NeimarkSacker, Grazing, End };
inline std::string_view name(CycleMark mark)
{
    constexpr std::array<std::string_view, 5> names{"fold", "period doubling", "Neimark-Sacker", "grazing",
                                                    "end of the branch"};
    static_assert(names.size() == static_cast<std::size_t>(CycleMark::End) + 1);
    return names[static_cast<std::size_t>(mark)];
}

struct MarkedCycle {
    CycleMark kind = CycleMark::Fold;
    LimitCycle at;
    std::string remark;    // "take-off": the switch that appears or is lost; else why the branch ends
    bool ends = false;     // the branch ends here, within the range
    std::size_t point = 0; // of the branch
};

struct CycleBranch {
    std::vector<LimitCycle> points; // in their order along it, with the marks
    std::vector<MarkedCycle> marks; // by rising point
};

struct CycleTrace {
    std::function<std::shared_ptr<const BouncingSlider>(double value)> sliderAt; // null where the case is not valid
    double from = 0.0, to = 1.0;                                                 // range of the parameter [its unit]
    std::function<bool()> goOn{};
    std::function<void(double share)> reached{}; // receives each value at which cycles are sought, by its share
    /// The share of a value in the range, and back.
    double share(double value) const { return (value - from) / (to - from); }
    double value(double share) const { return std::lerp(from, to, share); }
};

/// The branch through a cycle, in both directions.
CycleBranch traceCycle(const CycleTrace& trace, const LimitCycle& start);
/// Whether a cycle lies on the branch, between two of its points.
bool liesOn(const CycleBranch& branch, const LimitCycle& cycle);

} // namespace touchdown
