// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown modes`: air bearing frequencies, damping ratios and mode shapes of a film case.
#pragma once

#include "app/terminal/console.h"

namespace touchdown {

struct ModesArguments {
    CaseArguments caseArguments;
    bool json = false;
    bool progress = false;
};

int modesCommand(const ModesArguments& arguments);

} // namespace touchdown
