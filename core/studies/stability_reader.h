// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a study of stability: see core/studies/stability.h.
#pragma once

#include <string>
#include <vector>

#include "core/studies/stability_task.h"
#include "core/studies/study_reader.h"

namespace touchdown {

/// Adds what is wrong to the reader's problems; of use only where there is none.
StabilityTask readStabilityTask(StudyReader& reader);

/// What is varied where nobody says otherwise, with its values; an empty key: nothing.
struct DefaultParameter {
    std::string key;
    std::vector<std::string> values;
};
DefaultParameter defaultParameter(const Case& c);
std::vector<MethodSpec> defaultStabilityMethods(const Case& c);

} // namespace touchdown
