// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does the slider fly, is it caught, or does it bounce for ever? A map over two values of the case. Each cell is run
// from several starts (SliderOf), each with a verdict (bouncing_run.h). Oscillations within the contact that never
// reach d_e count as caught. Beside each cell stands W, which one loop of
// its contact law takes out of the slider (core/physics/contact/ono_yamane.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/case/case_key.h"
#include "core/studies/cycles/bouncing_run.h"
#include "core/studies/runs/value_ranges.h"

namespace touchdown {

struct BouncingMapAxis {
    Parameter keys;
    ParameterText text;
    bool logarithmic = false;
    std::vector<double> values; // in rising order, both ends included [unit of the keys]
    /// Between the ends: 0 at the first value, 1 at the last one.
    double at(double share) const;
};

/// A point of the map with a name: "Fig. 12".
struct MapMark {
    std::string name;
    double x = 0.0, y = 0.0; // [units of the axes]
};

struct BouncingMapTask {
    Case start;
    BouncingMapAxis x, y;
    int starts = 3;
    BouncingSearch search;
    SliderOf sliderOf{};
    std::vector<MapMark> marks{};
};

struct MarkedMapTask : BouncingMapTask {
    bool marksByWork = false; // a mark or more stands where the law of the map has the W of its case
};

enum class MapClass : std::uint8_t { Flies, FliesOrCaught, Caught, Bounces, Unknown, Fails };
inline constexpr std::size_t mapClasses = 6;
inline std::string_view name(MapClass kind)
{
    constexpr std::array<std::string_view, mapClasses> names{
        "flies", "flies or is caught", "caught", "bounces for ever", "too short to tell", "fails"};
    return names[static_cast<std::size_t>(kind)];
}

struct MapCell {
    double x = 0.0, y = 0.0;              // [units of the axes]
    bool done = false;                    // all its runs have an end
    double cycleWork = 0.0;               // W; 0 where the case is not valid [J]
    std::array<int, bouncingEnds> ends{}; // number of runs by BouncingEnd
    std::string problem{};                // of a run that failed
    int runs(BouncingEnd end) const { return ends[static_cast<std::size_t>(end)]; }
    /// Bounces where one start does; else fails where one run does; else unknown where the end of one run is.
    MapClass kind() const;
};

/// How often the slider bounces, by the sign of W.
struct MapCount {
    std::size_t cells = 0;                // that are done
    std::size_t creating = 0, taking = 0; // bounce, with W < 0 and with W >= 0
    std::size_t quietFlying = 0,
                quietOther = 0; // do not bounce with W < 0: flies, or is caught from a start or from all
};
MapCount countOf(const std::vector<MapCell>& cells);

/// One cell; not done where it was stopped.
MapCell judgeCell(const BouncingMapTask& task, double x, double y, const std::function<bool()>& goOn = {});

/// Points (x, y) with W = 0, along y where W depends on x, else along x; fewer than two where W keeps its sign.
std::vector<std::pair<double, double>> zeroWork(const BouncingMapTask& task);

} // namespace touchdown
