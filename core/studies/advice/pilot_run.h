// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first part of a run, its cost, and whether it can predict the rest. The case runs as if to its end, so that its
// steps are those of the whole run, and is stopped where enough is known. The cost is the time of its thread on a
// processor, so that other runs at the same time do not count.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/simulation/small_motions/linear_motion.h"
#include "core/studies/advice/tail_estimate.h"
#include "core/work/parallel.h"

namespace touchdown {

/// Time of the calling thread on a processor [s].
double threadSeconds();

struct PilotRun {
    SpacingSamples samples;
    std::string problem;                           // why it ended before, in a sentence; "" where it did not
    bool stopped = false;                          // by goOn
    double lowest = 0.0;                           // spacing at all samples [m]
    bool contactActs = false;                      // at any sample, be it contact or adhesion
    std::vector<std::pair<double, double>> course; // time reached [s], thread's time [s]

    bool valid() const { return problem.empty() && !stopped; }
    /// What the run took to a time [s]; beyond what was reached at the rate of the last half of that.
    double secondsTo(double time) const;
};

/// At which a pilot of this case is sampled [s]: as the case is, or often enough to tell its end.
double pilotInterval(const Case& c);

/// Asked as the run goes, with the samples so far; true: enough is known.
using PilotEnough = std::function<bool(const SpacingSamples&)>;

/// Runs a valid case of model "film" or "springs".
PilotRun pilotRun(const Case& c, const PilotEnough& enough, const GoOn& goOn);

/// The linear film before any run: static state, rates of its motions and of their excitation.
struct SceneMotion {
    LinearMotion motion;            // its static state, too, where there is one
    double seconds = 0.0;           // time of a processor
    std::vector<RingingRate> rates; // of modes, of air that creeps, of waves; none where modes are not known
    double growth = 0.0;            // e-folds of a mode that grows, over the run; zero: none does, or it is not known
    std::string growthProblem;      // why it is not known, in a sentence
    bool roughPasses = false;       // a rough disk moves under the slider
    /// A first part of a run predicts the rest: no mode grows too much, and no new surface comes under the slider.
    bool predicts() const;
};

/// Of a valid case of model "film".
SceneMotion sceneMotion(const Case& c, const GoOn& goOn);

} // namespace touchdown
