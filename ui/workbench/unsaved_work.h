// SPDX-License-Identifier: GPL-3.0-or-later
//
// What closing the window, or opening another case, would lose: edits, calculations under way, results in the lists
// that no file of the user has.
#pragma once

#include <string>
#include <vector>

#include <QDir>
#include <QStringList>

#include "ui/studies/study_draft.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

struct Case;

struct UnsavedWork {
    QString editedCase;               // its name; empty: there is nothing to save of it
    bool ofSample = false;            // the case
    QStringList underWay;             // calculations, as parts of a sentence
    std::vector<int> runs, solutions; // numbers
    std::vector<std::string> studies; // kinds
    std::vector<StudyDraft> drafts;   // edited texts of studies
    std::size_t series = 0;           // states of the series
    bool modes = false;

    bool empty() const { return editedCase.isEmpty() && drafts.empty() && underWay.isEmpty() && !anyResult(); }
    bool onlyChangesOfSample() const
    {
        UnsavedWork rest = *this;
        rest.editedCase.clear();
        return ofSample && rest.empty();
    }
    bool anyResult() const { return !runs.empty() || !solutions.empty() || !studies.empty() || series > 0 || modes; }
};

UnsavedWork unsavedWork(Workbench& bench);
/// The part of it that is lost when another case is opened: changes, series, modes, and what the film calculates.
UnsavedWork workOfCase(Workbench& bench);
/// Whether a run or a solution in the lists has these values.
bool isInResults(Workbench& bench, const Case& c);
/// Whether a result that lies in a file of the user has a note: only a session keeps notes.
bool hasNotesOnFiles(Workbench& bench);
/// One line for each kind of work, with count and names.
QStringList linesOf(const UnsavedWork& work, Workbench& bench);
/// Writes all results, and a case and texts of studies without a file, into a folder; files there are not replaced. A
/// case or a text with a file is saved to it. Returns a sentence for each thing that was not saved.
QStringList saveWork(const UnsavedWork& work, Workbench& bench, const QDir& folder);

} // namespace touchdown
