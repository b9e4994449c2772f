// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown study convergence`: how far the cells of a contact decide.
#pragma once

#include <string>

#include "app/terminal/console.h"
#include "core/studies/convergence/convergence.h"

namespace touchdown {

struct ConvergenceArguments {
    CaseArguments caseArguments;
    std::string out; // HDF5; "" for none
    std::string csv; // "" for none
    ConvergenceOptions options;
    bool json = false;
};

int convergenceCommand(const ConvergenceArguments& arguments);

} // namespace touchdown
