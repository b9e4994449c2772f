// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stability where methods fail, in two pictures.
//
// The linear picture (stability_picture.h) shows where each method damps small motions and where it amplifies them,
// with the case's own eigenvalues times its step, and the largest stable step of each method.
//
// The map (stability_map.h) shows runs of several methods over their settings and the values of one parameter of the
// case. Each run is compared with a reference for that value, which two independent methods prove, and put into a
// class (run_class.h): agrees, wrong end state, drifting energy, chatter, lost spring, diverged ... Beside the class
// stands the result of the paper's own criterion, which is the same run with a tenth of the step. This shows where
// the criterion misses an error and where it raises a false alarm.
#pragma once

#include <string>
#include <vector>

#include "core/studies/study/item_study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyWork planStability(StudyReader& reader);
StudyForm stabilityForm(const Case& c);

/// The parameter that a study of this case varies by default, with its values; an empty key: nothing.
struct DefaultParameter {
    std::string key;
    std::vector<std::string> values;
};
DefaultParameter defaultParameter(const Case& c);

struct StabilityTask;
/// Adds what is wrong to the reader's problems; the task is complete where there is none.
StabilityTask readStabilityTask(StudyReader& reader);

} // namespace touchdown
