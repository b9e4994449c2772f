// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run of the list continues: from its last state to the end of its case, or to a later one.
#pragma once

#include <QString>

#include "ui/runs/run_controller.h"

namespace touchdown {

struct RunRecord;

struct RunContinuation {
    QString problem;    // why it does not continue, in a sentence; empty if it does
    RunRequest request; // else
};
/// As `edited` where that is the run's case with a longer run.duration, else as its own case.
RunContinuation continuationOf(const RunRecord& run, const Case& edited);

} // namespace touchdown
