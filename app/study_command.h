// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown study`: what many solutions of one case show.
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

struct DesignArguments {
    CaseArguments study; // a study file, and settings for its case
    std::string out;     // the case with what was found; "" for none
    std::string csv;     // "" for none
    bool progress = false;
    bool json = false;
};

int convergenceCommand(const StudyArguments& arguments);
int designCommand(const DesignArguments& arguments);

} // namespace touchdown
