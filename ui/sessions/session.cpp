// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QSettings>

#include "core/case_files/case_text.h"
#include "core/studies/study/study_file.h"
#include "ui/case/case_edits.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/sessions/session_offer.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/quantity_format.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

constexpr int restBeforeState = 100;     // from an edit to its writing [ms]
constexpr int restBetweenReports = 2000; // of a study under way [ms]
constexpr int restBetweenLooks = 2000;   // at the folder [ms]
constexpr int longestRest = 256'000;     // of these, while something is not kept [ms]
constexpr auto budgetKey = "session/budget";

std::size_t bytesOf(const SteadyResult& state)
{
    return (state.pressure.size() + state.gap.size() + state.recess.size()) * sizeof(double);
}

} // namespace

qint64 Session::budget()
{
    const qint64 bytes = QSettings().value(budgetKey).toLongLong(); // 0: no number
    return bytes > 0 ? bytes : defaultBudget;
}

void Session::setBudget(qint64 bytes) { QSettings().setValue(budgetKey, bytes); }

Session::Session(Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench), folder_(SessionFolder::create(problem_))
{
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &Session::keepState);
    studySoon_.setSingleShot(true);
    studySoon_.setInterval(restBetweenReports);
    watch_.setInterval(restBetweenLooks);
    connect(&watch_, &QTimer::timeout, this, &Session::look);
    watch_.start();
    connectRuns();
    connectSolutions();
    connectStudies();
    connectState();
    connect(&reader_, &SessionReader::read, this,
            [this](const std::shared_ptr<LeftResult>& result) { onRead(*result); });
    connect(&reader_, &SessionReader::finished, this, &Session::onRestored);
    keepWithinBudget();
    schedule();
}

Session::~Session()
{
    reader_.disconnect();
    if (folder_) keepState();
}

void Session::connectSolutions()
{
    SolutionsModel& solutions = bench_.film().solutions();
    connect(&solutions, &RecordList::added, this, &Session::onSolutionAdded);
    connect(&solutions, &RecordList::aboutToRemove, this, [this](int number) {
        if (folder_) removeFile(folder_->solutionFile(number));
    });
    connect(bench_.film().view()->series(), &SeriesPage::changed, this, &Session::keepSeries);
    connect(bench_.film().view()->modes(), &ModesPage::changed, this, &Session::schedule);
}

void Session::connectStudies()
{
    StudyWindow& studies = bench_.studies();
    connect(&studies, &StudyWindow::ended, this, [this](const StudyReport& report) {
        studySoon_.stop();
        schedule();
        keepStudy(report.kind);
    });
    connect(&studies.controller(), &StudyController::partial, this, [this] {
        if (!studySoon_.isActive()) studySoon_.start();
    });
    connect(&studySoon_, &QTimer::timeout, this, [this] { keepStudy(bench_.studies().kindUnderWay().toStdString()); });
    connect(&studies, &StudyWindow::started, this, &Session::schedule);
    connect(studies.editor(), &StudyEditor::edited, this, &Session::schedule);
    connect(studies.editor()->kinds(), &QComboBox::currentIndexChanged, this, &Session::schedule);
}

void Session::connectState()
{
    connect(&bench_.edits(), &CaseEdits::edited, this, &Session::schedule);
    connect(&bench_.edits(), &CaseEdits::typedChanged, this, &Session::schedule);
    connect(&bench_.files(), &CaseFiles::saved, this, &Session::schedule);
    for (const RecordList* list :
         {static_cast<RecordList*>(&bench_.runWindow().runs()), static_cast<RecordList*>(&bench_.film().solutions())}) {
        connect(list, &RecordList::rowsInserted, this, &Session::schedule);
        connect(list, &RecordList::rowsRemoved, this, &Session::schedule);
        connect(list, &RecordList::dataChanged, this, &Session::schedule);
    }
    for (const auto signal : {&CaseFiles::opened, &CaseFiles::saved})
        connect(&bench_.files(), signal, this, [this] { // also the next start after a kill opens it
            QSettings().setValue(QStringLiteral("files/last"), bench_.files().origin());
        });
}

void Session::schedule()
{
    if (folder_ && !soon_.isActive()) soon_.start(restBeforeState);
}

SessionState Session::state() const
{
    const RunRecord* underWay = bench_.runWindow().runUnderWay();
    SessionState state = arriving_;
    state.edited = bench_.files().state();
    if (!from_) state.page = static_cast<int>(bench_.shownPage());
    std::ranges::move(statesOf(bench_.runWindow().runs(), underWay ? underWay->number : -1),
                      std::back_inserter(state.runs));
    std::ranges::move(statesOf(bench_.film().solutions(), -1), std::back_inserter(state.solutions));
    state.drafts = bench_.studies().editor()->unsaved();
    state.modes = bench_.film().view()->modes()->known();
    state.study = bench_.studies().editor()->kind();
    state.studyUnderWay = bench_.studies().kindUnderWay();
    state.closed = closed_;
    return state;
}

void Session::keepState()
{
    if (!folder_) return;
    soon_.stop();
    SessionState now = state();
    if (const QByteArray text = toJson(now); std::exchange(written_, text) == text) return;
    now.written = QDateTime::currentDateTimeUtc();
    const QByteArray text = toJson(now);
    if (text.size() > qsizetype(largestState)) return report(tr("Its texts and notes take more than 4 MiB."));
    states_.post([file = folder_->stateFile(), text] { return writeWholeFile(file, text); },
                 [this](const QString& problem) { report(problem); });
}

bool Session::keptState()
{
    const int before = failures_;
    keepState();
    wait();
    QCoreApplication::sendPostedEvents(&states_, QEvent::MetaCall); // delivers the result of the writer
    return failures_ == before;
}

bool Session::refuses(std::size_t bytes)
{
    QString reason = overBudget_;
    if (reason.isEmpty() && results_.pending() + bytes > mostPending)
        reason = tr("The disk is slower than the results come.");
    report(reason);
    return !reason.isEmpty();
}

void Session::onSolutionAdded(int number)
{
    const SolutionRecord* solution = bench_.film().solutions().find(number);
    if (!folder_ || adding_ || !solution || !solution->file.isEmpty()) return;
    const std::size_t bytes = bytesOf(solution->result);
    if (refuses(bytes)) return;
    const QString file = folder_->solutionFile(number);
    write([record = *solution, file] { return saveSolution(record, file); },
          [this, number, file] { bench_.film().solutions().setKept(number, file); }, bytes);
}

void Session::keepStudy(const std::string& kind)
{
    const StudyOutcome* outcome = bench_.studies().outcome(kind);
    if (!folder_ || !outcome || !outcome->report) return;
    StudyReport kept = bench_.studies().underWay(kind) ? interruptedReport(*outcome->report) : *outcome->report;
    write([file = folder_->studyFile(QString::fromStdString(kind)).toStdString(), kept = std::move(kept),
           c = outcome->plan.start.value, caseText = outcome->plan.start.text, text = outcome->plan.text,
           options = outcome->plan.options] {
        return QString::fromStdString(writeStudy(file, kept, c, updateCaseText(caseText, c), text, options));
    });
}

void Session::keepSeries()
{
    schedule();
    if (!folder_ || adding_) return;
    const SeriesPage& page = *bench_.film().view()->series();
    if (page.states().empty()) return removeFile(folder_->seriesFile());
    write([file = folder_->seriesFile(), series = page.series()] { return writeSeries(file, series); });
}

void Session::write(TaskQueue::Task task, std::function<void()> then, std::size_t bytes)
{
    const auto ended = [this, then = std::move(then)](const QString& problem) {
        if (problem.isEmpty() && then) then();
        report(problem);
    };
    results_.post(std::move(task), ended, bytes);
}

void Session::removeFile(const QString& file)
{
    results_.post([file] {
        QFile::remove(file);
        return QString();
    });
}

void Session::keepWithinBudget()
{
    if (!folder_) return;
    results_.post(
        [most = budget()] {
            if (keepSessionsWithin(most) <= most) return QString();
            return tr("The files of the sessions take more than the %1 that File > Sessions allows.")
                .arg(QLocale().formattedDataSize(most));
        },
        [this](const QString& problem) { overBudget_ = problem; });
}

void Session::report(const QString& problem)
{
    if (problem.isEmpty() || closed_) return;
    ++failures_;
    setProblem(
        tr("Not all of the work is kept against a crash: %1 Runs continue in memory; save the results that you need.")
            .arg(sentence(problem.toStdString())));
    if (!std::exchange(reported_, true)) emit failed(problem_);
}

void Session::setProblem(const QString& problem)
{
    if (std::exchange(problem_, problem) != problem) emit problemChanged();
    // A full disk is asked less and less often.
    watch_.setInterval(problem.isEmpty() ? restBetweenLooks : std::min(2 * watch_.interval(), longestRest));
}

void Session::look()
{
    if (from_) return; // its results come to this folder
    if (folder_ && !folder_->stands()) {
        folder_.reset();
        stream_.reset();
        report(tr("its folder was removed."));
    }
    if (!problem_.isEmpty()) keepAgain();
}

void Session::keepAgain()
{
    if (closed_ || from_) return;
    if (!folder_) {
        QString problem;
        folder_ = SessionFolder::create(problem);
        if (!folder_) return setProblem(problem);
    }
    keepWithinBudget();
    written_.clear();
    keepState();
    const UnsavedWork work = notKept();
    for (const int number : work.runs) {
        RunRecord& run = *bench_.runWindow().runs().find(number);
        if (bench_.runWindow().runUnderWay() || !run.fieldsComplete() || !run.summary) continue;
        beginStream(run);
        onRunEnded(number, *run.summary);
    }
    for (const int number : work.solutions) onSolutionAdded(number);
    for (const std::string& kind : work.studies) keepStudy(kind);
    if (work.series > 0) keepSeries();
    // Behind all of that, and behind what it reports.
    results_.post([] { return QString(); },
                  [this, before = failures_](const QString&) {
                      states_.post([] { return QString(); },
                                   [this, before](const QString&) {
                                       if (failures_ == before && !notKept().anyResult()) setProblem({});
                                   });
                  });
}

void Session::wait()
{
    results_.wait();
    states_.wait();
}

UnsavedWork Session::notKept() const
{
    UnsavedWork work = unsavedWork(bench_);
    const auto in = [](const RecordList& list) {
        return [&list](int number) { return isOwnFile(list.listed(list.rowOf(number)).kept); };
    };
    std::erase_if(work.runs, in(bench_.runWindow().runs()));
    std::erase_if(work.solutions, in(bench_.film().solutions()));
    std::erase_if(work.studies, [this](const std::string& kind) {
        return folder_ && isOwnFile(folder_->studyFile(QString::fromStdString(kind)));
    });
    if (folder_ && isOwnFile(folder_->seriesFile())) work.series = 0;
    if (folder_) work.modes = false; // the state has them
    return work;
}

bool Session::keepsAll()
{
    if (!folder_) return false;
    if (unsavedWork(bench_).empty()) return true;
    wait();
    QCoreApplication::sendPostedEvents(&results_, QEvent::MetaCall); // delivers the results of the writers
    QCoreApplication::sendPostedEvents(&states_, QEvent::MetaCall);
    return problem_.isEmpty() && recordsWholeRun() && !notKept().anyResult();
}

void Session::close(bool keep)
{
    closed_ = true;
    watch_.stop();
    if (!folder_) return;
    soon_.stop();
    wait();
    if (keep) {
        keepState();
        states_.wait();
        folder_.reset();
    } else {
        SessionFolder::remove(std::move(folder_));
    }
}

} // namespace touchdown
