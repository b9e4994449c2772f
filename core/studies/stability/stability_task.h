// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of stability is to do, read and checked: see core/studies/stability/stability.h.
#pragma once

#include <string>
#include <vector>

#include "core/case/fields.h"
#include "core/studies/runs/run_class.h"
#include "core/studies/runs/swept_method.h"

namespace touchdown {

/// One value of the parameter.
struct StabilityRow {
    std::string label;  // "5 N/um", as it was given; "" where there is no parameter
    double value = 0.0; // [unit of the parameter]; its number in the list where it is no number
    std::vector<ReferenceCase> references;
    std::vector<SweptMethod> methods; // as many as MethodSpecs, with as many settings
};

struct StabilityTask {
    Case start;
    bool picture = true;
    bool map = true;
    const Field* parameter = nullptr; // null: none is varied
    bool parameterIsNumber = false;
    std::vector<MethodSpec> methods;
    std::vector<StabilityRow> rows;
    ClassRule rule;
};

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
