// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length of the next step of a run of the film. A longer one needs a new linearisation, so lengths are kept for a while
// and then doubled.
#pragma once

#include <algorithm>
#include <cmath>

namespace touchdown {

class StepLength {
public:
    static constexpr double mostGrowth = 2.0;   // BDF2 is stable up to 1 + sqrt 2 (Grigorieff 1983)
    static constexpr double worstFactor = 0.75; // below which a step is tried again
    static constexpr double longestPhase =
        0.5; // omega dt of the fastest motion, so that slower ones keep their damping, too

    /// Steps as long as the error allows, from a first one; with error zero all have its length [s], [m].
    StepLength(double first, double allowedError) : allowed_(allowedError), first_(first), wanted_(first) {}

    bool fixed() const { return allowed_ == 0.0; }
    /// After a step of length `last` (zero: the first one), and no longer than `longest` unless lengths are fixed.
    double next(double last, double longest) const
    {
        double dt = wanted_;
        if (last > 0.0) dt = std::min(dt, mostGrowth * last);
        return fixed() ? dt : std::min(dt, longest);
    }
    /// Ratio of the allowed length to that of a step with this error, which grows with the cube of the length.
    double factor(double error) const { return safety * std::cbrt(allowed_ / std::max(error, 1e-300)); }
    bool isTooLong(double error) const { return !fixed() && factor(error) < worstFactor; }

    /// Length of a step that is tried again.
    double shortened(double dt, double error)
    {
        sinceLimit_ = 0;
        return wanted_ = dt * std::max(factor(error), 0.25);
    }
    /// Length after a step that failed.
    double halved(double dt)
    {
        wanted_ = std::min(wanted_, 0.5 * dt);
        return 0.5 * dt;
    }
    void accepted(double dt, double error)
    {
        if (fixed()) wanted_ = first_;
        if (fixed()) return;
        const double change = factor(error);
        if (change < 1.0) wanted_ = change * dt;
        sinceLimit_ = change < worthGrowing ? 0 : sinceLimit_ + 1;
        if (change < worthGrowingAtOnce && sinceLimit_ < patience) return;
        wanted_ = std::max(wanted_, std::min(mostGrowth, change) * dt);
        sinceLimit_ = 0;
    }

private:
    static constexpr double safety = 0.9;
    static constexpr double worthGrowing = 1.6, worthGrowingAtOnce = 4.0;
    static constexpr int patience = 16; // steps, longer than a moment of an oscillation

    double allowed_;     // [m]
    double first_;       // [s]
    double wanted_;      // where nothing else limits it [s]
    int sinceLimit_ = 0; // steps since the last one that could not have been longer
};

} // namespace touchdown
