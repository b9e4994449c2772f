// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which static states a series has: one quantity between two values, or the lists of the case.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QString>

#include "core/simulation/recording/quantity.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

enum class Varied : std::uint8_t { Radius, Skew, Speed, Altitude, Lists };

struct SeriesChoice {
    Varied varied = Varied::Radius;
    double from = 0.0, to = 0.0;         // of the varied quantity [SI]
    double skewFrom = 0.0, skewTo = 0.0; // at the first and the last radius, evenly between [rad]
    int states = 9;
    bool operator==(const SeriesChoice&) const = default;
};

/// Whether the case lists more than one state.
bool hasLists(const Case& c);

/// About the case: from a half of its radius or speed to 1.5 of it, 10 degrees to either side of its skew, altitudes up
/// to 3000 m; or what it lists of them. Within the ranges of its parameters.
SeriesChoice usualChoice(const Case& c, Varied varied);

/// At least two; what is not varied is that of the case.
std::vector<SteadySeriesPoint> pointsOf(const Case& c, const SeriesChoice& choice);

/// The quantity over which the states are drawn: the first of radius, skew, speed and altitude that differs.
Varied axisOf(std::span<const SteadySeriesPoint> points);
double valueOf(const SteadySeriesPoint& point, Varied varied);
/// Name, SI unit and display unit.
Quantity quantityOf(Varied varied);

/// The part of a point that sets it apart from others with the same value on the axis, for the name of its curve:
/// "5400 rpm, 3000 m"; empty where all points of the series have the same.
QString curveName(const SteadySeriesPoint& point, std::span<const SteadySeriesPoint> points);

} // namespace touchdown
