// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long run of a slider, with the verdict on its motion (core/simulation/recording/motion_verdict.h): it
// flies, it is caught, or it bounces. A run that does not come to rest is the start of the search for its cycle: the
// smallest number n of crossings of the section after which a state returns nearly, then Newton's method.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/studies/cycles/limit_cycle.h"

namespace touchdown {

/// The verdict on a run, as far as the cycles need it.
enum class BouncingEnd : std::uint8_t {
    Flies,   // without contact at the end
    Caught,  // in contact at the end, at rest or vibrating
    Bounces, // to the end
    Unknown, // too short to tell
    Failed
};
inline constexpr std::size_t bouncingEnds = 5;
inline std::string_view name(BouncingEnd end)
{
    constexpr std::array<std::string_view, bouncingEnds> names{"flies", "caught", "bounces", "too short to tell",
                                                               "failed"};
    static_assert(names.size() == static_cast<std::size_t>(BouncingEnd::Failed) + 1);
    return names[static_cast<std::size_t>(end)];
}

inline constexpr std::size_t fewestCrossings = 3; // of the section in the last tenth, by a slider on a cycle

struct BouncingSearch {
    double duration = 2e-3;  // of the run [s]
    int mostCrossings = 8;   // of a cycle; 0: no cycle is sought
    double tolerance = 1e-9; // of the run, in units of SpringModel::scale [-]
    std::function<bool()> goOn{};
    std::size_t mostSamples = std::size_t{1} << 17; // that the verdict is given on: the newest, at most twice as many
};

struct BouncingRun {
    double value = 0.0;  // of the parameter [its unit]
    double height = 0.0; // flying height at the start [m]
    BouncingEnd end = BouncingEnd::Failed;
    SwingOf minimumSpacing;          // in the last tenth [m]
    double frequency = 0.0;          // of the last crossings of the run, at most 64, by those of the cycle [Hz]
    std::optional<LimitCycle> cycle; // where one was found
    double modelError = 0.0;         // of a motion that is too large for a linear film, and has failed for that [-]
    std::string problem;             // why a run that still crosses the section has none, or why the run failed
    std::size_t samples = 0;         // that the verdict was given on
    double amplitude() const { return 0.5 * (minimumSpacing.most - minimumSpacing.least); }
};

/// The sliders like a case on springs or a linear film, under Ono and Yamane's contact.
SliderOf slidersLike(const Case& c);

/// From the slider's start, or from a state on the section (bouncing_slider.h).
BouncingRun searchCycle(const BouncingSlider& slider, double value, const BouncingSearch& search,
                        const std::optional<Eigen::VectorXd>& from = {});

/// The same of a case at its k-th start; where it has no slider, its problem says why.
BouncingRun runOf(const SliderOf& sliderOf, const Case& c, int start, double value, const BouncingSearch& search);

} // namespace touchdown
