// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length of the next step of a run of the film. The film's formula is fitted to the slider's rate only where steps
// change by at most a quarter (numerics/backward_difference.h), and a longer step needs a new linearisation. So a
// length stays, or grows by that where the error allows more. A limit that falls is followed at that pace, too; an
// error that is too large shortens a step at once, and the step after it, which cannot be fitted, grows by up to two.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/numerics/backward_difference.h"

namespace touchdown {

class StepLength {
public:
    static constexpr double mostGrowth = 2.0;                       // BDF2 is stable up to 1 + sqrt 2 (Grigorieff 1983)
    static constexpr double smoothChange = 0.99 * mostChangeForFit; // of a step against the last one
    static constexpr double worstFactor = 0.75;                     // below which a step is tried again
    static constexpr double longestPhase =
        0.5; // omega dt of the fastest motion, so that slower ones keep their damping, too

    /// Steps as long as the error allows, from a first one; with error zero all have its length [s], [m].
    StepLength(double first, double allowedError) : allowed_(allowedError), first_(first), wanted_(first) {}

    bool fixed() const { return allowed_ == 0.0; }
    /// After a step of length `last` (zero: the first one). Unless lengths are fixed it approaches `longest` smoothly,
    /// or is no longer, where forces have just jumped.
    double next(double last, double longest, bool jumped = false) const
    {
        double dt = wanted_;
        if (last > 0.0) dt = std::min(dt, mostGrowth * last);
        return fixed() ? dt : std::min(dt, jumped ? longest : std::max(longest, last / smoothChange));
    }
    /// Ratio of the allowed length to that of a step with this error, which grows with the cube of the length.
    double factor(double error) const { return safety * std::cbrt(allowed_ / std::max(error, 1e-300)); }
    bool isTooLong(double error) const { return !fixed() && factor(error) < worstFactor; }

    /// Length of a step that is tried again.
    double shortened(double dt, double error)
    {
        shortened_ = true;
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
        const double change = factor(error), growth = shortened_ ? mostGrowth : smoothChange;
        wanted_ = fixed() ? first_
                          : dt * (change >= worthGrowing ? std::min(change, growth)
                                                         : std::clamp(change, 1.0 / smoothChange, 1.0));
        shortened_ = false;
    }

private:
    static constexpr double safety = 0.9;
    static constexpr double worthGrowing = 1.3; // with some room beyond smoothChange

    double allowed_;         // [m]
    double first_;           // [s]
    double wanted_;          // where nothing else limits it [s]
    bool shortened_ = false; // the step that is tried
};

} // namespace touchdown
