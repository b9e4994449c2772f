// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a session's folder says about the window beside the results themselves: the case that is edited, the lists, the
// page. As JSON, so that a person can read it.
#pragma once

#include <optional>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include "ui/case/case_files.h"

namespace touchdown {

class RecordList;

/// One entry of a list of results.
struct ListedState {
    int number = 0;
    QString note;
    QString file; // that the user saved it to, or opened; empty: only the session has it
    bool shown = true;
    bool underWay = false; // a run that had not ended
    int place = 0;         // in `file`
};

struct SessionState {
    QDateTime written;
    bool closed = false; // by the user, who left the work behind
    CaseState edited;
    int page = 0; // WindowPages::Page
    std::vector<ListedState> runs, solutions;

    /// Results in the folder that only the session has.
    bool empty() const;
};

/// The entries of a list. `underWay`: the number of the record that is calculated, -1: none.
std::vector<ListedState> statesOf(const RecordList& list, int underWay);

QByteArray toJson(const SessionState& state);
/// What the folder of a session holds; results that its session.json does not name are found by their files. Nothing
/// when there is neither.
std::optional<SessionState> readSession(const QString& folder);
/// Kinds of study of which the folder has a report.
QStringList studiesIn(const QString& folder);
/// "case fig10a with its edits, 3 runs (1 was interrupted), 2 static solutions"; empty when nothing is worth restoring.
QString describe(const SessionState& state, const QStringList& studies);

} // namespace touchdown
