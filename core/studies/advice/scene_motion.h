// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the linear film tells of a scene before it is run: where it rests, at which rates it rings and is driven, and
// whether a first part of its run can tell the rest at all.
#pragma once

#include <string>
#include <vector>

#include "core/simulation/small_motions/linear_motion.h"
#include "core/studies/advice/ringing_fit.h"
#include "core/studies/runs/parallel.h"

namespace touchdown {

struct SceneMotion {
    LinearMotion motion;            // its static state, too, where there is one
    double seconds = 0.0;           // of a processor, that it took
    std::vector<RingingRate> rates; // of modes, of air that creeps, of waves; none where modes are not known
    double growth = 0.0;            // e-folds of a mode that grows, over the run; zero: none does, or it is not known
    std::string growthProblem;      // why it is not known, in a sentence
    bool roughPasses = false;       // a surface without an order of its own moves by
    /// Nothing grows by more than the motion that it is hidden in, nor comes that has not been there.
    bool foretells() const;
};

/// Of a valid case of model "film".
SceneMotion sceneMotion(const Case& c, const GoOn& goOn);

} // namespace touchdown
