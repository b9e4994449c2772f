// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown study KIND` and `touchdown advise`: what many solutions of one case show.
#pragma once

#include <string>
#include <vector>

#include "app/terminal/console.h"
#include "core/studies/study_plan.h"

namespace touchdown {

struct StudyArguments {
    std::string kind;                 // of studyKinds()
    CaseArguments study;              // a study or a case, and settings for the case
    std::vector<std::string> options; // of the study itself
    std::string out;                  // HDF5; "" for none
    std::string csv;                  // "" for none
    std::string apply;                // the case that the study found; "" for none
    int jobs = 0;                     // 0: as many as there are cores
    bool asTemplate = false;          // print a study of the case instead
    bool progress = false;
    bool json = false;
};

/// Writes warnings and problems of a study and its case to standard error.
void complainOf(const StudyPlan& plan);

int studyCommand(const StudyArguments& arguments);

} // namespace touchdown
