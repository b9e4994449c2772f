// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/unsaved_work.h"

#include <algorithm>

#include <QFileInfo>

#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/readable.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr std::size_t mostNames = 4; // in a line
constexpr int mostLetters = 40;      // of a name

std::vector<int> unsavedOf(const RecordList& list)
{
    std::vector<int> numbers;
    for (int row = 0; row < list.count(); ++row)
        if (list.isUnsaved(row)) numbers.push_back(list.listed(row).number);
    return numbers;
}

QString names(QStringList all)
{
    const qsizetype more = all.size() - qsizetype(mostNames);
    if (more > 0) all = all.first(mostNames) << tr("and %1 more").arg(more);
    return all.join(QStringLiteral(", "));
}

QString namesIn(const RecordList& list, const std::vector<int>& numbers)
{
    QStringList all;
    for (const int number : numbers) {
        // As the list has it, without the number before it.
        const QString name = list.index(list.rowOf(number)).data(Qt::DisplayRole).toString().section("  ", 1);
        all << QStringLiteral("%1 “%2”").arg(number).arg(
            name.size() > mostLetters ? name.first(mostLetters - 1) + QStringLiteral("…") : name);
    }
    return names(all);
}

/// A file of this name that does not exist yet.
QString freeName(const QDir& folder, const QString& base, const char* ending)
{
    QString name = base + QLatin1String(ending);
    for (int copy = 2; folder.exists(name); ++copy)
        name = QStringLiteral("%1-%2%3").arg(base).arg(copy).arg(QLatin1String(ending));
    return folder.filePath(name);
}

QStringList filmUnderWay(Workbench& bench)
{
    QStringList list;
    if (bench.film().controller().active()) list << tr("a static solution, which is under way");
    if (bench.film().view()->busy()) list << tr("a series or modes, which are under way");
    return list;
}

} // namespace

bool hasNotesOnFiles(Workbench& bench)
{
    const auto noted = [](const RecordList& list) {
        for (int row = 0; row < list.count(); ++row)
            if (const ListedRecord& each = list.listed(row); !each.note.isEmpty() && each.isInFile()) return true;
        return false;
    };
    return noted(bench.runWindow().runs()) || noted(bench.film().solutions());
}

bool isInResults(Workbench& bench, const Case& c)
{
    const auto holds = [&c](const RecordList& list) {
        for (int row = 0; row < list.count(); ++row)
            if (list.listed(row).value == c) return true;
        return false;
    };
    return holds(bench.runWindow().runs()) || holds(bench.film().solutions());
}

UnsavedWork unsavedWork(Workbench& bench)
{
    UnsavedWork work;
    if (bench.files().hasChangesToSave()) work.editedCase = bench.files().shortName();
    work.ofSample = !bench.files().sample().isEmpty();
    const RunRecord* underWay = bench.runWindow().runUnderWay();
    if (underWay) work.underWay << tr("run %1, which is under way").arg(underWay->number);
    work.underWay << filmUnderWay(bench);
    if (bench.studies().controller().active()) work.underWay << tr("a study, which is under way");
    work.runs = unsavedOf(bench.runWindow().runs());
    if (underWay) std::erase(work.runs, underWay->number);
    work.solutions = unsavedOf(bench.film().solutions());
    for (const auto& [kind, outcome] : bench.studies().outcomes())
        if (bench.studies().unsaved(kind) && !bench.studies().underWay(kind)) work.studies.push_back(kind);
    work.series = bench.film().view()->series()->unsaved();
    work.modes = bench.film().view()->modes()->unsaved();
    work.drafts = bench.studies().editor()->unsaved();
    return work;
}

UnsavedWork workOfCase(Workbench& bench)
{
    const UnsavedWork all = unsavedWork(bench);
    UnsavedWork work;
    work.editedCase = all.editedCase;
    work.underWay = filmUnderWay(bench);
    work.series = all.series;
    work.modes = all.modes;
    return work;
}

QStringList linesOf(const UnsavedWork& work, Workbench& bench)
{
    QStringList lines;
    if (!work.editedCase.isEmpty()) lines << tr("the changes of the case “%1”").arg(work.editedCase);
    lines << work.underWay;
    const auto add = [&](const char* one, const char* several, const std::size_t count, const QString& listed) {
        if (count == 1) lines << tr(one).arg(listed);
        if (count > 1) lines << tr(several).arg(count).arg(listed);
    };
    add("1 run that is not saved: %1", "%1 runs that are not saved: %2", work.runs.size(),
        namesIn(bench.runWindow().runs(), work.runs));
    add("1 static solution that is not saved: %1", "%1 static solutions that are not saved: %2", work.solutions.size(),
        namesIn(bench.film().solutions(), work.solutions));
    if (work.series > 0) lines << tr("a series of %1 static states that is not saved").arg(work.series);
    if (work.modes) lines << tr("modes that are not saved");
    QStringList titles;
    for (const std::string& kind : work.studies)
        titles << QStringLiteral("“%1”").arg(readable(bench.studies().outcome(kind)->report->title));
    QStringList edited;
    for (const StudyDraft& draft : work.drafts)
        edited << QStringLiteral("“%1”").arg(readable(bench.studies().editor()->titleOf(draft.kind).toStdString()));
    add("the changes of the study %1", "the changes of %1 studies: %2", work.drafts.size(), names(edited));
    add("1 study report that is not saved: %1", "%1 study reports that are not saved: %2", work.studies.size(),
        names(titles));
    return lines;
}

QStringList saveWork(const UnsavedWork& work, Workbench& bench, const QDir& folder)
{
    QStringList problems;
    const auto saved = [&problems](const QString& what, const QString& problem) {
        if (!problem.isEmpty()) problems << QStringLiteral("%1: %2").arg(what, problem);
        return problem.isEmpty();
    };
    if (!work.editedCase.isEmpty()) {
        const QString file = bench.files().file();
        const QString base = QFileInfo(bench.files().shortName()).completeBaseName();
        saved(tr("The case"), bench.files().write(file.isEmpty() ? freeName(folder, base, ".toml") : file));
    }
    RunsModel& runs = bench.runWindow().runs();
    for (const int number : work.runs) {
        RunRecord& run = *runs.find(number);
        const QString file = freeName(folder, suggestedName(run), ".h5");
        if (saved(tr("Run %1").arg(number), saveHdf5(run, file))) runs.setFile(number, file);
    }
    SolutionsModel& solutions = bench.film().solutions();
    for (const int number : work.solutions) {
        const QString file = freeName(folder, QStringLiteral("solution%1").arg(number), ".h5");
        if (saved(tr("Solution %1").arg(number), saveSolution(*solutions.find(number), file)))
            solutions.setFile(number, file);
    }
    const FilmView* film = bench.film().view();
    if (work.series > 0) problems << film->series()->save(freeName(folder, QStringLiteral("series"), ".csv"));
    if (work.modes) problems << film->modes()->save(freeName(folder, QStringLiteral("modes"), ".csv"));
    problems.removeAll(QString());
    for (const std::string& kind : work.studies) {
        const QString name = QString::fromStdString(kind);
        saved(tr("Study %1").arg(name), bench.studies().save(kind, freeName(folder, name, ".h5")));
    }
    for (const StudyDraft& draft : work.drafts)
        saved(tr("Study %1").arg(draft.kind),
              bench.studies().editor()->save(draft.kind, draft.file.isEmpty() ? freeName(folder, draft.kind, ".toml")
                                                                              : draft.file));
    return problems;
}

} // namespace touchdown
