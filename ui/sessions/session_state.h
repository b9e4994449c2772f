// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a session's folder says about the window beside the results themselves: the case that is edited, the lists, the
// page, the texts of studies. As JSON, so that a person can read it.
//
// A state that is not understood (cut off, of a newer version, no regular file, too large) is never taken for an empty
// one: its results are found by their files, and its file is kept (SessionFolder::setStateAside).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include "ui/case/case_files.h"
#include "ui/film/modes_text.h"
#include "ui/studies/study_draft.h"

namespace touchdown {

class RecordList;

/// One entry of a list of results.
struct ListedState {
    int number = 0;
    QString note;
    QString file;     // that the user saved it to, or opened; empty: only the session has it
    QString identity; // of that file then (core/formats/file_identity.h); empty: not known
    bool shown = true;
    bool underWay = false; // a run that had not ended
    int place = 0;         // in `file`
    int from = 0;          // its number in the session that it is restored from; 0: none
};

struct SessionState {
    QString notUnderstood; // why its file cannot be read; empty: it was read, or there is none
    bool newer = false;    // of a newer version of the program, which alone may take it
    QDateTime written;
    bool closed = false; // by the user, who left the work behind
    CaseState edited;
    int page = 0; // Workbench::Page
    std::vector<ListedState> runs, solutions;
    std::vector<StudyDraft> drafts; // texts of studies that are not saved
    std::optional<FoundModes> modes;
    bool series = false;   // its file is in the folder
    QStringList reports;   // kinds of study of which the folder has one
    QString study;         // the kind that is shown
    QString studyUnderWay; // the kind of the study that had not ended; empty: none
    QString restoring;     // the folder of the session that is being restored; empty: none

    /// Nothing that only the session has.
    bool empty() const;
};

/// The entries of a list. `underWay`: the number of the record that is calculated, -1: none.
std::vector<ListedState> statesOf(const RecordList& list, int underWay);

constexpr std::uintmax_t largestState = std::uintmax_t(4) << 20; // file of a state [byte]

QByteArray toJson(const SessionState& state);
/// What the folder of a session holds; results that its session.json does not name are found by their files.
SessionState readSession(const QString& folder);
struct EndedSession {
    QString path;
    SessionState state;
};
/// Those that no window uses, the newest first: by the time at which its state was written. A time that is still to
/// come, of a clock that was wrong, is not believed; then that of the file counts.
std::vector<EndedSession> endedSessions();
/// The folder of the session that a session restores, beside its own; `name`: SessionState::restoring.
QString earlierFolder(const QString& folder, const QString& name);
/// "case fig10a with its edits, 3 runs (1 was interrupted), 2 static solutions"; empty when nothing is worth restoring.
QString describe(const SessionState& state);

} // namespace touchdown
