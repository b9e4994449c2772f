// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown run`: a case to its end, with results on disk, progress, and a way to stop it.
#pragma once

#include <string>

#include "app/terminal/console.h"

namespace touchdown {

struct RunArguments {
    CaseArguments caseArguments;
    std::string out; // HDF5; "" for none
    std::string csv; // "" for none
    bool json = false;
    bool progress = false;
};

int runCommand(const RunArguments& arguments);

} // namespace touchdown
