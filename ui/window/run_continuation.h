// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run of the list continues: from its last state to the end of its case, or to a later one.
#pragma once

#include <functional>

#include <QString>

#include "ui/runs/run_controller.h"

class QAction;

namespace touchdown {

class CaseEdits;
class MessageStrip;
class Recording;
class RunWindow;
struct RunRecord;

struct RunContinuation {
    QString problem;     // why it does not continue, in a sentence; empty if it does
    RunRequest request;  // else
    QString startsAgain; // why it does so from its beginning, in a part of a sentence; empty if it does not
};
/// As `edited` where that is the run's case with a longer run.duration, else as its own case.
RunContinuation continuationOf(const RunRecord& run, const Case& edited);

/// An action, and an entry in the menu of the list, continue the chosen run, recorded as the next run would be. Before,
/// `show` brings its page. All must last.
struct ContinuationParts {
    RunWindow& runs;
    CaseEdits& edits;
    Recording& recording;
    MessageStrip& messages;
    QAction& action;
};
void offerToContinue(const ContinuationParts& parts, const std::function<void()>& show);

} // namespace touchdown
