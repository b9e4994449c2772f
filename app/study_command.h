// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown study`: a table from many solutions of one case.
#pragma once

#include <string>

#include "app/command_line.h"
#include "core/studies/convergence.h"

namespace touchdown {

struct StudyArguments {
    CaseArguments caseArguments;
    std::string out; // HDF5; "" for none
    std::string csv; // "" for none
    ConvergenceOptions options;
    bool json = false;
};

int convergenceCommand(const StudyArguments& arguments);

} // namespace touchdown
