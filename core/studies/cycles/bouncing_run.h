// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long run of the spring model, judged by its last tenth: it flies, it is caught, or it bounces. A bouncing run is
// the start of the search for its cycle: the smallest number n of crossings of the section after which a state returns
// nearly, then Newton's method.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/studies/cycles/limit_cycle.h"

namespace touchdown {

enum class BouncingEnd : std::uint8_t { Flies, Caught, Bounces, Failed };
inline std::string_view name(BouncingEnd end)
{
    constexpr std::array<std::string_view, 4> names{"flies", "caught", "bounces", "failed"};
    static_assert(names.size() == static_cast<std::size_t>(BouncingEnd::Failed) + 1);
    return names[static_cast<std::size_t>(end)];
}

inline constexpr std::size_t fewestCrossings = 3; // of the section in the last tenth, by a slider that bounces

struct BouncingSearch {
    double duration = 2e-3;  // of the run [s]
    int mostCrossings = 8;   // of a cycle; 0: no cycle is sought
    double tolerance = 1e-9; // of the run, in units of SpringModel::scale [-]
    std::function<bool()> goOn{};
};

struct BouncingRun {
    double value = 0.0;  // of the parameter [its unit]
    double height = 0.0; // flying height at the start [m]
    BouncingEnd end = BouncingEnd::Failed;
    std::size_t touchDowns = 0;      // from flying, in the last tenth
    bool touches = false;            // at the end: on the take-off branch
    SwingOf minimumSpacing;          // in the last tenth [m]
    double frequency = 0.0;          // of the last crossings of the run, at most 64, by those of the cycle [Hz]
    std::optional<LimitCycle> cycle; // where one was found
    std::string problem;             // why a bouncing run has none, or why the run failed
    double amplitude() const { return 0.5 * (minimumSpacing.most - minimumSpacing.least); }
};

/// The k-th start of a case: as it says, then at a tenth, a hundredth, ... of that height above d_e and at the static
/// pitch.
Case caseOfStart(const Case& c, int k);

/// From the start of the case, or from a state on the section (return_map.h).
BouncingRun searchCycle(const Case& c, double value, const Vector3& units, const BouncingSearch& search,
                        const std::optional<Vector3>& from = {});

} // namespace touchdown
