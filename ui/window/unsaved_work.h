// SPDX-License-Identifier: GPL-3.0-or-later
//
// What closing the window would lose: edits, calculations under way, results in the lists that no file of the user has.
#pragma once

#include <string>
#include <vector>

#include <QDir>
#include <QStringList>

#include "ui/window/session.h"

namespace touchdown {

struct UnsavedWork {
    QString editedCase;               // its name; empty: there is nothing to save of it
    QStringList underWay;             // calculations, as parts of a sentence
    std::vector<int> runs, solutions; // numbers
    std::vector<std::string> studies; // kinds

    bool empty() const { return editedCase.isEmpty() && underWay.isEmpty() && !anyResult(); }
    bool anyResult() const { return !runs.empty() || !solutions.empty() || !studies.empty(); }
};

UnsavedWork unsavedWork(const SessionParts& parts);
/// One line for each kind of work, with count and names.
QStringList linesOf(const UnsavedWork& work, const SessionParts& parts);
/// Writes all results, and a case without a file, into a folder; files there are not replaced. A case with a file is
/// saved to it. Returns a sentence for each thing that was not saved.
QStringList saveWork(const UnsavedWork& work, const SessionParts& parts, const QDir& folder);

} // namespace touchdown
