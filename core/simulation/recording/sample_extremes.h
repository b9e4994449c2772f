// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extremes of recorded quantities between two samples. A run evaluates its quantities at more points of its dense
// output than it samples. Where three points in a row follow one law, a parabola through them finds an extreme between
// them: on a sine with 20 points in a period it is off by less than 3e-4 of the amplitude. There is no parabola where
// two of the points are nearly at one time, so that it does not enlarge their errors, nor where a value is not known
// (NaN).
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace touchdown {

class SampleExtremes {
public:
    explicit SampleExtremes(std::size_t quantities) : quantities_(quantities) { clear(); }

    /// A point of the motion, not before the last one. `smooth`: the same law has held since the point before.
    void add(double time, std::span<const double> values, bool smooth);
    /// Since the last restart, by quantity.
    const std::vector<double>& least() const { return least_; }
    const std::vector<double>& most() const { return most_; }
    /// Begins the next interval at the last point.
    void restart();
    void pass(auto& stream)
    {
        stream(last_, before_, smoothPoints_);
        stream.fixed(least_);
        stream.fixed(most_);
        for (const Point& point : {last_, before_})
            stream.require(point.values.size() == quantities_ || (point.values.empty() && smoothPoints_ < 2));
    }

private:
    struct Point {
        double time = 0.0; // [s]
        std::vector<double> values;
        void pass(auto& stream) { stream(time, values); }
    };
    void clear();

    std::size_t quantities_;
    Point last_, before_;
    std::size_t smoothPoints_ = 0; // in a row up to the last one, at most 2
    std::vector<double> least_, most_;
};

} // namespace touchdown
