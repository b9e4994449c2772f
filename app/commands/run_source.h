// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `touchdown run` runs: a case, or the case of a results file, which it repeats or continues.
#pragma once

#include <string>
#include <vector>

#include "app/commands/command_arguments.h"
#include "core/case/case_document.h"
#include "core/results/continued_run.h"

namespace touchdown {

struct RunSource {
    CaseDocument document;
    bool isStored = false; // the case is that of a results file
    bool resumes = false;
    ContinuedRun continued;
    SampleBatch samples;               // before it continues
    std::vector<FieldSnapshot> fields; // before it continues
    double heldUntil = 0.0;            // the last sample of its file [s]
    std::string out;                   // "" for none; of a run that continues, by default the file itself
};

/// Problems are those of the document.
RunSource openRunSource(const CommandArguments& arguments);

} // namespace touchdown
