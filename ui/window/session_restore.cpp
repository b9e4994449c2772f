// SPDX-License-Identifier: GPL-3.0-or-later
//
// Taking over the work of an earlier session.
#include "ui/window/session.h"

#include <algorithm>

#include <QFile>

#include "core/studies/study/study_file_reader.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_window.h"
#include "ui/window/window_pages.h"

namespace touchdown {

QStringList Session::restore(std::unique_ptr<SessionFolder> from)
{
    const std::optional<SessionState> state = readSession(from->path());
    if (!folder_ || !state) return {};
    QStringList problems;
    restoring_ = true;
    for (const ListedState& run : state->runs) problems << restoreRun(*from, run);
    for (const ListedState& solution : state->solutions) problems << restoreSolution(*from, solution);
    for (const QString& kind : studiesIn(from->path())) problems << restoreStudy(*from, kind);
    restoring_ = false;
    if (!state->edited.savedText.isEmpty()) parts_.files.restore(state->edited);
    parts_.pages.setPage(static_cast<WindowPages::Page>(std::clamp(state->page, 0, 2)));
    keepState();
    wait();
    SessionFolder::remove(std::move(from));
    problems.removeAll(QString());
    return problems;
}

QString Session::restoreRun(const SessionFolder& from, const ListedState& entry)
{
    RunsModel& runs = parts_.runs.runs();
    const int number = std::max(entry.number, runs.nextNumber());
    const QString kept = folder_->runFile(number);
    const bool moved = QFile::rename(from.runFile(entry.number), kept);
    QString problem;
    std::unique_ptr<RunRecord> record = recordFromFile(number, moved ? kept : entry.file, problem);
    if (!record) return problem;
    record->file = entry.file;
    record->kept = moved ? kept : QString();
    record->note = entry.note;
    record->shown = entry.shown;
    runs.add(std::move(record));
    return {};
}

QString Session::restoreSolution(const SessionFolder& from, const ListedState& entry)
{
    SolutionsModel& solutions = parts_.film.solutions();
    const QString kept = folder_->solutionFile(solutions.nextNumber());
    const bool moved = QFile::rename(from.solutionFile(entry.number), kept);
    QString problem;
    for (const int number : addSolutions(solutions, moved ? kept : entry.file, problem)) {
        if (moved) solutions.setFile(number, entry.file);
        if (moved) solutions.setKept(number, kept);
        const QModelIndex index = solutions.index(solutions.rowOf(number));
        solutions.setData(index, entry.note, RecordList::NoteRole);
        if (!entry.shown) solutions.setData(index, Qt::Unchecked, Qt::CheckStateRole);
    }
    return problem;
}

QString Session::restoreStudy(const SessionFolder& from, const QString& kind)
{
    const QString kept = folder_->studyFile(kind);
    if (!QFile::rename(from.studyFile(kind), kept)) return {}; // a newer report of the kind is in the window
    StoredStudy stored = readStudy(kept.toStdString());
    if (!stored.problem.empty()) return QString::fromStdString(stored.problem);
    parts_.studies.restore(std::move(stored));
    return {};
}

} // namespace touchdown
