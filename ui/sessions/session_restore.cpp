// SPDX-License-Identifier: GPL-3.0-or-later
//
// Taking over the work of an earlier session, one result after the other. The state of this session names all of them,
// with their notes, before the first file is moved. So a kill in between loses nothing: the next start moves the rest
// (finishRestoring).
#include "ui/sessions/session.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <QDir>

#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/sessions/session_offer.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

/// Empty, or a sentence.
QString moveFile(const QString& there, const QString& here)
{
    if (moveOwnFile(there, here)) return {};
    return Session::tr("%1 could not be moved to the folder of this session and stays there.")
        .arg(QDir::toNativeSeparators(there));
}

void annotate(SolutionsModel& solutions, int number, const ListedState& entry)
{
    const QModelIndex index = solutions.index(solutions.rowOf(number));
    solutions.setData(index, entry.note, RecordList::NoteRole);
    if (!entry.shown) solutions.setData(index, Qt::Unchecked, Qt::CheckStateRole);
}

} // namespace

void Session::restore(std::unique_ptr<SessionFolder> from)
{
    if (!folder_ || from_) return;
    finishRestoring(*from);
    const SessionState state = readSession(from->path());
    const auto held = std::make_shared<std::unique_ptr<SessionFolder>>(std::move(from));
    bench_.files().askBeforeRestoring(state.edited, [this, held, state] {
        if (folder_ && !from_ && *held) restore(std::move(*held), state);
    });
}

void Session::restore(std::unique_ptr<SessionFolder> from, const SessionState& state)
{
    refused_.clear();
    if (!state.notUnderstood.isEmpty()) refused_ << from->setStateAside(state.notUnderstood);
    what_ = describe(state);
    from_ = std::move(from);
    left_ = {};
    left_.written = state.written;
    left_.closed = state.closed;
    if (const CaseState& edited = state.edited; edited.modified || !edited.savedText.isEmpty())
        if (const QString problem = bench_.files().restore(edited); !problem.isEmpty() && edited.modified) {
            left_.edited = edited;
            refused_ << tr("The edited case %1 cannot be read again and stays in File, Sessions, Restore: %2")
                            .arg(inOneLine(edited.name), problem);
        }
    StudyEditor& editor = *bench_.studies().editor();
    for (const StudyDraft& draft : state.drafts)
        if (!editor.restore(draft)) {
            left_.drafts.push_back(draft);
            refused_ << tr("The window has another edited text of the study %1; that of the earlier session stays in "
                           "File, Sessions, Restore.")
                            .arg(draft.kind);
        }
    editor.setKind(state.study);
    if (ModesPage& page = *bench_.film().view()->modes(); state.modes && (page.known() || page.controller().active())) {
        left_.modes = state.modes;
        refused_ << tr(
            "The window has modes; those of the earlier session stay in File, Sessions, Restore for a window "
            "without them.");
    } else if (state.modes) {
        page.restore(*state.modes);
    }
    arriving_ = {};
    arriving_.page = std::clamp(state.page, 0, 2);
    arriving_.restoring = QFileInfo(from_->path()).fileName();
    waiting_ = resultsOf(state);
    if (keptState()) { // before the first file is moved
        reader_.start(waiting_);
        return;
    }
    waiting_.clear();
    arriving_ = {};
    from_.reset();
    refused_ << tr("The results stay in File, Sessions, Restore, because the state of this session cannot be written.");
    emit restored(what_, refused_, true);
}

std::vector<std::shared_ptr<LeftResult>> Session::resultsOf(const SessionState& state)
{
    using Kind = LeftResult::Kind;
    std::vector<std::shared_ptr<LeftResult>> results;
    const auto add = [&results](Kind kind, const QString& file) {
        results.push_back(std::make_shared<LeftResult>());
        results.back()->kind = kind;
        results.back()->file = file;
        return results.back().get();
    };
    const auto addList = [&](Kind kind, const std::vector<ListedState>& entries, RecordList& list,
                             std::vector<ListedState>& arriving, QString (SessionFolder::*fileOf)(int) const) {
        std::map<QString, LeftResult*> opened; // one file has several solutions, but one run
        for (const ListedState& entry : entries) {
            const QString kept = (from_.get()->*fileOf)(entry.number);
            const bool inFolder = liesAt(kept);
            LeftResult*& result = opened[inFolder ? kept : entry.file];
            if (result == nullptr || kind == Kind::Run) result = add(kind, inFolder ? kept : entry.file);
            result->inFolder = inFolder;
            const int number = std::max(entry.number, list.nextNumber());
            list.keepFree(number);
            result->entries.push_back(entry);
            result->numbers.push_back(number);
            arriving.push_back(entry);
            arriving.back().number = number;
            arriving.back().from = inFolder ? entry.number : 0;
        }
    };
    addList(Kind::Run, state.runs, bench_.runWindow().runs(), arriving_.runs, &SessionFolder::runFile);
    addList(Kind::Solutions, state.solutions, bench_.film().solutions(), arriving_.solutions,
            &SessionFolder::solutionFile);
    if (state.series) add(Kind::Series, from_->seriesFile());
    for (const QString& kind : state.reports) add(Kind::Study, from_->studyFile(kind))->study = kind;
    return results;
}

void Session::onRead(LeftResult& result)
{
    const Workbench::Page page = bench_.shownPage();
    adding_ = true;
    QString problem = result.problem;
    if (problem.isEmpty()) switch (result.kind) {
        case LeftResult::Kind::Run: problem = takeRun(result); break;
        case LeftResult::Kind::Solutions: problem = takeSolutions(result); break;
        case LeftResult::Kind::Study: problem = takeStudy(result); break;
        case LeftResult::Kind::Series: problem = takeSeries(result); break;
        }
    adding_ = false;
    bench_.setPage(page); // a run that is added shows its own
    if (!problem.isEmpty()) {
        refused_ << problem;
        return;
    }
    std::erase_if(waiting_, [&](const auto& each) { return each.get() == &result; });
    std::erase_if(result.kind == LeftResult::Kind::Run ? arriving_.runs : arriving_.solutions,
                  [&](const ListedState& each) { return std::ranges::count(result.numbers, each.number) > 0; });
}

QString Session::takeRun(LeftResult& result)
{
    const ListedState& entry = result.entries.front();
    const QString kept = folder_->runFile(result.numbers.front());
    if (result.inFolder)
        if (QString problem = moveFile(result.file, kept); !problem.isEmpty()) return problem;
    RunRecord& record = *result.run;
    // A file of the user that is another one by now does not have the run.
    if (result.inFolder) record.identity = result.identity;
    record.file = !result.inFolder || result.identity ? entry.file : QString();
    record.kept = result.inFolder ? kept : QString();
    record.note = entry.note;
    record.shown = entry.shown;
    bench_.runWindow().runs().add(std::move(result.run));
    return {};
}

QString Session::takeSolutions(LeftResult& result)
{
    SolutionsModel& solutions = bench_.film().solutions();
    const auto count = static_cast<int>(result.solutions.states.size());
    std::vector<int> places;
    for (const ListedState& entry : result.entries) places.push_back(result.inFolder ? 0 : entry.place);
    if (std::ranges::any_of(places, [count](int place) { return place >= count; }))
        return tr("%1 has fewer states than in the earlier session.").arg(QDir::toNativeSeparators(result.file));
    const QString kept = result.inFolder ? folder_->solutionFile(result.numbers.front()) : QString();
    if (result.inFolder)
        if (QString problem = moveFile(result.file, kept); !problem.isEmpty()) return problem;
    addSolutions(solutions, result.solutions, places, result.numbers);
    for (std::size_t i = 0; i < places.size(); ++i) {
        annotate(solutions, result.numbers[i], result.entries[i]);
        if (!result.inFolder) continue;
        solutions.setFile(result.numbers[i], result.identity ? result.entries[i].file : QString());
        solutions.setKept(result.numbers[i], kept);
    }
    return {};
}

QString Session::takeStudy(LeftResult& result)
{
    const QString kept = folder_->studyFile(result.study);
    const StudyOutcome* outcome = bench_.studies().outcome(result.study.toStdString());
    if (outcome || QFileInfo::exists(kept))
        return tr("The window has a report of the study %1; that of the earlier session stays in File, Sessions, "
                  "Restore for a window without one.")
            .arg(result.study);
    if (QString problem = moveFile(result.file, kept); !problem.isEmpty()) return problem;
    bench_.studies().restore(std::move(result.report));
    return {};
}

QString Session::takeSeries(LeftResult& result)
{
    SeriesPage& page = *bench_.film().view()->series();
    if (!page.states().empty() || page.controller().active())
        return tr("The window has a series of static states; that of the earlier session stays in File, Sessions, "
                  "Restore for a window without one.");
    if (QString problem = moveFile(result.file, folder_->seriesFile()); !problem.isEmpty()) return problem;
    page.restore(result.series);
    return {};
}

void Session::onRestored(bool stopped)
{
    bench_.setPage(static_cast<Workbench::Page>(arriving_.page));
    bench_.film().edit(bench_.edits().value()); // shows its solution, if that is among them
    for (const std::shared_ptr<LeftResult>& result : std::exchange(waiting_, {}))
        if (result->kind == LeftResult::Kind::Series)
            left_.series = true;
        else if (result->kind == LeftResult::Kind::Study)
            left_.reports << result->study;
        else
            for (const ListedState& entry : result->entries)
                (result->kind == LeftResult::Kind::Run ? left_.runs : left_.solutions).push_back(entry);
    // The person is told which results stay; only edits of the case are offered again at the next start.
    left_.closed = left_.closed || (!stopped && !left_.edited.modified);
    arriving_ = {};
    std::unique_ptr<SessionFolder> from = std::move(from_);
    // The results that were taken are in the state of this session. Else the next start ends what was begun here.
    if (keptState()) refused_ << leaveRest(std::move(from), left_);
    refused_.removeAll(QString());
    emit restored(what_, refused_, stopped);
}

} // namespace touchdown
