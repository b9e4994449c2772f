// SPDX-License-Identifier: GPL-3.0-or-later
//
// The linear film before any run: static state, rates of its motions and of their excitation, and whether a first part
// of a run can predict the rest.
#pragma once

#include <string>
#include <vector>

#include "core/simulation/small_motions/linear_motion.h"
#include "core/studies/advice/ringing_fit.h"
#include "core/studies/runs/parallel.h"

namespace touchdown {

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
