// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of stability is to do, read and checked: see core/studies/stability.h.
#pragma once

#include <string>
#include <vector>

#include "core/simulation/fields.h"
#include "core/studies/precision_methods.h"
#include "core/studies/run_class.h"

namespace touchdown {

/// One value of the parameter.
struct StabilityRow {
    std::string label;   // "5 N/um", as it was given; "" where there is no parameter
    double value = 0.0;  // [unit of the parameter]; its number in the list where it is no number
    ReferenceCases references;
    std::vector<PrecisionMethod> methods; // as many as MethodSpecs, with as many settings
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

} // namespace touchdown
