// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown steady`: the static state of a film case, or of each of its series.
#pragma once

#include <string>

#include "app/terminal/console.h"

namespace touchdown {

struct SteadyArguments {
    CaseArguments caseArguments;
    std::string out; // HDF5; "" for none
    bool fixedAttitude = false;
    bool json = false;
    bool progress = false;
};

int steadyCommand(SteadyArguments arguments);

} // namespace touchdown
