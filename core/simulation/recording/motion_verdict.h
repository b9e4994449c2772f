// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a slider's motion comes to, judged by the minimum spacing s over a window: the last tenth of a run, or the last
// third where the tenth holds less than 3 periods of a motion that is not at rest:
//
//   at rest           s swings by no more than 0.02 nm, peak to peak, nor was it about to move on
//   too short to tell the window holds less than 3 periods of the main motion, or fewer than 10 samples
//   settles           the swing is less than 90 % of that over the tenth or third before
//   bounces           else, and the slider touches the disk in the window
//   swings            else: the motion lasts without contact
//
// A period: s goes from the lowest quarter of its range in the window to the highest quarter and back. At rest it was
// not about to move on if the last half of the run swings by less than three times as much, or if s crossed its mean
// value of the window there and back.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/simulation/recording/run_summary.h"

namespace touchdown {

constexpr std::size_t fewestSamples = 10; // of a window that tells anything

struct MotionEvidence {
    bool third = false;                  // the window is the last third of the run, not the last tenth
    double swing = 0.0;                  // of the minimum spacing in the window, peak to peak [m]
    double swingBefore = 0.0;            // in as long a time before [m]
    double periods = 0.0;                // in the window
    bool movesOn = false;                // in the half before the end, though at rest in the last tenth
    bool touches = false;                // in the window
    std::size_t samples = fewestSamples; // in the window
};
constexpr double smallestSwing = 0.02e-9; // that matters, peak to peak [m]
constexpr double smallestDecay = 0.9;     // of the swing of sustained motion, from window to window [-]
constexpr double fewestPeriods = 3.0;

Motion motionOf(const MotionEvidence& evidence);
/// The rule that decided, with its figures, as one sentence.
std::string motionRule(const MotionEvidence& evidence);

/// Periods of a signal: half of its changes between the lowest and the highest quarter of its range.
double periodsOf(std::span<const double> signal);
/// Whether the last half of the samples, whose last tenth is at rest, was about to move on.
bool movesOn(std::span<const double> lastHalf);

} // namespace touchdown
