// SPDX-License-Identifier: GPL-3.0-or-later
//
// Taking over the work of an earlier session.
#include "ui/window/session.h"

#include <algorithm>
#include <map>

#include <QDir>
#include <QFile>

#include "core/studies/study/study_file_reader.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_window.h"
#include "ui/style/whole_file.h"
#include "ui/window/window_pages.h"

namespace touchdown {

namespace {

QString notMoved(const QString& file)
{
    return Session::tr("%1 could not be moved to the folder of this session and stays there.")
        .arg(QDir::toNativeSeparators(file));
}

void annotate(SolutionsModel& solutions, int number, const ListedState& entry)
{
    const QModelIndex index = solutions.index(solutions.rowOf(number));
    solutions.setData(index, entry.note, RecordList::NoteRole);
    if (!entry.shown) solutions.setData(index, Qt::Unchecked, Qt::CheckStateRole);
}

} // namespace

QStringList Session::restore(std::unique_ptr<SessionFolder> from)
{
    const std::optional<SessionState> state = readSession(from->path());
    if (!folder_ || !state) return {};
    QStringList problems;
    SessionState left; // what stays in its folder
    left.written = state->written;
    left.closed = state->closed;
    restoring_ = true;
    for (const ListedState& run : state->runs) {
        problems << restoreRun(*from, run);
        if (QFile::exists(from->runFile(run.number))) left.runs.push_back(run);
    }
    std::map<QString, std::vector<ListedState>> opened; // solutions of the same file
    for (const ListedState& solution : state->solutions) {
        if (!QFile::exists(from->solutionFile(solution.number))) {
            opened[solution.file].push_back(solution);
            continue;
        }
        problems << restoreSolution(*from, solution);
        if (QFile::exists(from->solutionFile(solution.number))) left.solutions.push_back(solution);
    }
    for (const auto& [file, entries] : opened) problems << restoreOpened(file, entries);
    for (const QString& kind : studiesIn(from->path())) problems << restoreStudy(*from, kind);
    restoring_ = false;
    if (!state->edited.savedText.isEmpty()) parts_.files.restore(state->edited);
    parts_.pages.setPage(static_cast<WindowPages::Page>(std::clamp(state->page, 0, 2)));
    keepState();
    wait();
    if (left.empty() && studiesIn(from->path()).isEmpty())
        SessionFolder::remove(std::move(from));
    else
        problems << writeWholeFile(from->stateFile(), toJson(left));
    problems.removeAll(QString());
    return problems;
}

QString Session::restoreRun(const SessionFolder& from, const ListedState& entry)
{
    RunsModel& runs = parts_.runs.runs();
    const int number = std::max(entry.number, runs.nextNumber());
    const QString there = from.runFile(entry.number), kept = folder_->runFile(number);
    const bool inFolder = QFile::exists(there);
    QString problem;
    std::unique_ptr<RunRecord> record = recordFromFile(number, inFolder ? there : entry.file, problem);
    if (!record) return problem;
    if (inFolder && !QFile::rename(there, kept)) return notMoved(there);
    record->file = entry.file;
    record->kept = inFolder ? kept : QString();
    record->note = entry.note;
    record->shown = entry.shown;
    runs.add(std::move(record));
    return {};
}

QString Session::restoreSolution(const SessionFolder& from, const ListedState& entry)
{
    SolutionsModel& solutions = parts_.film.solutions();
    const QString there = from.solutionFile(entry.number), kept = folder_->solutionFile(solutions.nextNumber());
    QString problem;
    const std::vector<int> numbers = addSolutions(solutions, there, problem, std::vector<int>{0});
    if (numbers.empty()) return problem;
    const int number = numbers.front();
    if (!QFile::rename(there, kept)) {
        solutions.remove(solutions.rowOf(number));
        return notMoved(there);
    }
    solutions.setFile(number, entry.file);
    solutions.setKept(number, kept);
    annotate(solutions, number, entry);
    return {};
}

QString Session::restoreOpened(const QString& file, const std::vector<ListedState>& entries)
{
    SolutionsModel& solutions = parts_.film.solutions();
    std::vector<int> places;
    for (const ListedState& entry : entries) places.push_back(entry.place);
    QString problem;
    const std::vector<int> numbers = addSolutions(solutions, file, problem, places);
    if (numbers.size() == entries.size())
        for (std::size_t i = 0; i < numbers.size(); ++i) annotate(solutions, numbers[i], entries[i]);
    else if (problem.isEmpty())
        problem = tr("%1 has fewer states than in the earlier session.").arg(QDir::toNativeSeparators(file));
    return problem;
}

QString Session::restoreStudy(const SessionFolder& from, const QString& kind)
{
    const QString there = from.studyFile(kind), kept = folder_->studyFile(kind);
    const StudyOutcome* outcome = parts_.studies.outcome(kind.toStdString());
    if ((outcome && outcome->report) || QFile::exists(kept))
        return tr("The window has a report of the study %1; that of the earlier session stays in File, Sessions, "
                  "Restore "
                  "for a window without one.")
            .arg(kind);
    StoredStudy stored = readStudy(there.toStdString());
    if (!stored.problem.empty()) return QString::fromStdString(stored.problem);
    if (!QFile::rename(there, kept)) return notMoved(there);
    parts_.studies.restore(std::move(stored));
    return {};
}

} // namespace touchdown
