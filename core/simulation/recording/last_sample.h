// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run takes samples at whole multiples of its interval, and one more where it ends between two of them, so that its
// last sample is its end. What needs equal intervals leaves that sample out: spectra, and the verdict of a motion.
#pragma once

#include <cmath>

namespace touchdown {

/// Whether the sample at a time is no multiple of the interval [s]: then it is the last one of its run.
inline bool isBetweenSamples(double time, double interval)
{
    constexpr double rounding = 1e-6; // of an interval [-]
    const double intervals = time / interval;
    return std::abs(intervals - std::round(intervals)) > rounding;
}

} // namespace touchdown
