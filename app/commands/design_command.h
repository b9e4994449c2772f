// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown study design`: values with which a slider flies as wanted.
#pragma once

#include <string>

#include "app/terminal/console.h"

namespace touchdown {

struct DesignArguments {
    CaseArguments study;     // a study's file or name, and settings for its case
    std::string out;         // the case with what was found; "" for none
    std::string csv;         // "" for none
    bool asTemplate = false; // print the study instead
    bool progress = false;
    bool json = false;
};

int designCommand(const DesignArguments& arguments);

} // namespace touchdown
