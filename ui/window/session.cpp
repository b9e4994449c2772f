// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include <QCoreApplication>
#include <QFile>
#include <QSettings>

#include "core/case_files/case_text.h"
#include "core/results/results_writer.h"
#include "core/studies/study/study_file.h"
#include "ui/case/case_edits.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_window.h"
#include "ui/style/quantity_format.h"
#include "ui/style/whole_file.h"
#include "ui/window/session_budget.h"
#include "ui/window/unsaved_work.h"
#include "ui/window/window_pages.h"

namespace touchdown {

namespace {

constexpr int restBeforeState = 100; // from an edit to its writing [ms]
// A run that ends within this time has the processor to itself: its file is written afterwards.
constexpr auto restBeforeFile = std::chrono::milliseconds(100);
constexpr std::size_t mostPending = std::size_t(256) << 20; // that may wait for the disk [byte]
constexpr auto budgetKey = "session/budget";

std::size_t bytesOf(const SampleBatch& samples)
{
    return samples.size() * (samples.columns.size() + 1) * sizeof(double);
}

std::size_t bytesOf(const std::vector<FieldSnapshot>& fields)
{
    std::size_t count = 0;
    for (const FieldSnapshot& snapshot : fields)
        for (const std::vector<double>& values : snapshot.values) count += values.size();
    return count * sizeof(double);
}

std::size_t bytesOf(const SteadyResult& state)
{
    return (state.pressure.size() + state.gap.size() + state.recess.size()) * sizeof(double);
}

} // namespace

struct Session::Stream {
    int number = 0;
    bool opened = false; // or waits for it on the writer's thread
    ResultsWriter writer;
    bool whole = true;   // no samples or snapshots from before it are missing
    bool broken = false; // on the writer's thread
};

qint64 Session::budget() { return QSettings().value(budgetKey, defaultBudget).toLongLong(); }

void Session::setBudget(qint64 bytes) { QSettings().setValue(budgetKey, bytes); }

Session::Session(const SessionParts& parts, std::unique_ptr<SessionFolder> folder, QObject* parent)
    : QObject(parent), parts_(parts), folder_(std::move(folder))
{
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &Session::keepState);
    connectRuns();
    connectSolutions();
    connect(&parts_.studies, &StudyWindow::ended, this, &Session::onStudied);
    connectState();
    keepWithinBudget();
    schedule();
}

Session::~Session()
{
    if (folder_) keepState();
}

void Session::connectRuns()
{
    connect(&parts_.runs, &RunWindow::started, this, &Session::onRunStarted);
    connect(&parts_.runs.controller(), &RunController::delivered, this, &Session::onDelivered);
    connect(&parts_.runs, &RunWindow::ended, this, &Session::onRunEnded);
    connect(&parts_.runs.controller(), &RunController::recordingFailed, this, [this] {
        // The file that the user wanted has failed: the session keeps the run instead.
        if (RunRecord* run = parts_.runs.runUnderWay()) beginStream(*run);
    });
    connect(&parts_.runs.runs(), &RecordList::aboutToRemove, this,
            [this](int number) { removeFile(folder_->runFile(number)); });
}

void Session::connectSolutions()
{
    SolutionsModel& solutions = parts_.film.solutions();
    connect(&solutions, &RecordList::added, this, &Session::onSolutionAdded);
    connect(&solutions, &RecordList::aboutToRemove, this,
            [this](int number) { removeFile(folder_->solutionFile(number)); });
}

void Session::connectState()
{
    connect(&parts_.edits, &CaseEdits::edited, this, &Session::schedule);
    connect(&parts_.files, &CaseFiles::saved, this, &Session::schedule);
    connect(&parts_.pages, &WindowPages::shown, this, &Session::schedule);
    for (const RecordList* list :
         {static_cast<RecordList*>(&parts_.runs.runs()), static_cast<RecordList*>(&parts_.film.solutions())}) {
        connect(list, &RecordList::rowsInserted, this, &Session::schedule);
        connect(list, &RecordList::rowsRemoved, this, &Session::schedule);
        connect(list, &RecordList::dataChanged, this, &Session::schedule);
    }
    for (const auto signal : {&CaseFiles::opened, &CaseFiles::saved})
        connect(&parts_.files, signal, this, [this] { // also the next start after a kill opens it
            const QString file = parts_.files.file();
            QSettings().setValue(QStringLiteral("files/last"), file.isEmpty() ? parts_.files.sample() : file);
        });
}

void Session::schedule()
{
    if (folder_ && !soon_.isActive()) soon_.start(restBeforeState);
}

SessionState Session::state() const
{
    const RunRecord* underWay = parts_.runs.runUnderWay();
    SessionState state;
    state.edited = parts_.files.state();
    state.page = static_cast<int>(parts_.pages.page());
    state.runs = statesOf(parts_.runs.runs(), underWay ? underWay->number : -1);
    state.solutions = statesOf(parts_.film.solutions(), -1);
    return state;
}

void Session::keepState()
{
    if (!folder_) return;
    soon_.stop();
    SessionState now = state();
    if (const QByteArray text = toJson(now); std::exchange(written_, text) == text) return;
    now.written = QDateTime::currentDateTimeUtc();
    states_.post([file = folder_->stateFile(), text = toJson(now)] { return writeWholeFile(file, text); },
                 [this](const QString& problem) { report(problem); });
}

void Session::onRunStarted(int number)
{
    keepWithinBudget();
    // A run that the user records is in that file.
    if (RunRecord* run = parts_.runs.runs().find(number); run && run->file.isEmpty()) beginStream(*run);
}

void Session::beginStream(RunRecord& run)
{
    if (!folder_) return;
    if (overBudget_) {
        report(tr("The files of the sessions take more than the %1 that File > Sessions allows.")
                   .arg(QLocale().formattedDataSize(budget())));
        return;
    }
    stream_ = std::make_shared<Stream>();
    stream_->number = run.number;
    if (!run.finished() && fieldsKnownOf_ != run.number) return; // its first delivery says which fields it records
    std::vector<RecordedFields> sets;
    for (const FieldHistory& history : run.fields) sets.push_back(history.fields);
    openStream(run, sets);
    RunDelivery whole;
    stream_->whole = run.fieldsComplete();
    for (std::size_t part = 0; part < run.parts(); ++part) {
        whole.samples = run.samples(part);
        onDelivered(whole);
    }
    whole.samples = {};
    for (const FieldHistory& history : run.fields)
        for (std::size_t i = 0; i < history.snapshots.size(); ++i) whole.fields.push_back(history.snapshot(i));
    onDelivered(whole);
}

void Session::openStream(const RunRecord& run, const std::vector<RecordedFields>& sets)
{
    stream_->opened = true;
    results_.post(
        [stream = stream_, file = folder_->runFile(run.number).toStdString(), c = run.value, text = run.caseText,
         quantities = run.quantities, sets] {
            std::this_thread::sleep_for(restBeforeFile);
            const std::string problem = stream->writer.open(file, c, text, quantities, sets);
            stream->broken = !problem.empty();
            return QString::fromStdString(problem);
        },
        [this](const QString& problem) { report(problem); });
}

void Session::onDelivered(const RunDelivery& delivery)
{
    if (const RunRecord* run = parts_.runs.runUnderWay(); run && delivery.sets) {
        fieldsKnownOf_ = run->number;
        if (stream_) openStream(*run, *delivery.sets);
    }
    const std::size_t bytes = bytesOf(delivery.samples) + bytesOf(delivery.fields);
    if (!stream_ || bytes == 0) return;
    if (results_.pending() + bytes > mostPending) {
        results_.post([stream = std::exchange(stream_, nullptr)] {
            stream->broken = true;
            return QString();
        });
        report(tr("The disk is slower than the run."));
        return;
    }
    results_.post(
        [stream = stream_, samples = delivery.samples, fields = delivery.fields] {
            if (stream->broken) return QString();
            const std::string problem = stream->writer.append(samples, fields);
            stream->broken = !problem.empty();
            return QString::fromStdString(problem);
        },
        [this](const QString& problem) { report(problem); }, bytes);
}

void Session::onRunEnded(int number, const Summary& summary)
{
    schedule();
    if (!stream_ || stream_->number != number) return;
    if (!stream_->opened) return stream_.reset(); // it failed before it began
    results_.post(
        [stream = std::exchange(stream_, nullptr), summary] {
            if (stream->broken || !stream->whole) return tr("The file of the run is not complete.");
            return QString::fromStdString(stream->writer.finish(summary));
        },
        [this, number, file = folder_->runFile(number)](const QString& problem) {
            if (problem.isEmpty())
                parts_.runs.runs().setKept(number, file);
            else
                report(problem);
        });
}

void Session::onSolutionAdded(int number)
{
    const SolutionRecord* solution = parts_.film.solutions().find(number);
    if (!folder_ || restoring_ || !solution || !solution->file.isEmpty()) return;
    const std::size_t bytes = bytesOf(solution->result);
    if (overBudget_ || results_.pending() + bytes > mostPending) return;
    const QString file = folder_->solutionFile(number);
    results_.post([record = *solution, file] { return saveSolution(record, file); },
                  [this, number, file](const QString& problem) {
                      if (problem.isEmpty())
                          parts_.film.solutions().setKept(number, file);
                      else
                          report(problem);
                  },
                  bytes);
}

void Session::onStudied(const StudyReport& report)
{
    const StudyOutcome* outcome = parts_.studies.outcome(report.kind);
    if (!folder_ || !outcome || !outcome->report) return;
    results_.post(
        [file = folder_->studyFile(QString::fromStdString(report.kind)).toStdString(), kept = *outcome->report,
         c = outcome->plan.start.value, caseText = outcome->plan.start.text, text = outcome->plan.text] {
            return QString::fromStdString(writeStudy(file, kept, c, updateCaseText(caseText, c), text));
        },
        [this](const QString& problem) { this->report(problem); });
}

void Session::removeFile(const QString& file)
{
    if (!folder_) return;
    results_.post([file] {
        QFile::remove(file);
        return QString();
    });
}

void Session::keepWithinBudget()
{
    if (!folder_) return;
    auto bytes = std::make_shared<qint64>(0);
    results_.post(
        [bytes, most = budget()] {
            *bytes = keepSessionsWithin(most);
            return QString();
        },
        [this, bytes](const QString&) { overBudget_ = *bytes > budget(); });
}

void Session::report(const QString& problem)
{
    if (problem.isEmpty() || std::exchange(reported_, true)) return;
    emit failed(tr("Not all of the work is kept against a crash: %1 Runs go on in memory; save the results that you "
                   "need.")
                    .arg(sentence(problem.toStdString())));
}

void Session::wait()
{
    results_.wait();
    states_.wait();
}

bool Session::keepsAll()
{
    if (!folder_) return false;
    const UnsavedWork work = unsavedWork(parts_);
    if (work.empty()) return true;
    wait();
    QCoreApplication::sendPostedEvents(&results_, QEvent::MetaCall); // what the writers say
    QCoreApplication::sendPostedEvents(&states_, QEvent::MetaCall);
    const RunRecord* underWay = parts_.runs.runUnderWay();
    const bool recorded = !underWay || !underWay->file.isEmpty() || (stream_ && stream_->whole);
    const auto in = [](const RecordList& list) {
        return [&list](int number) { return !list.listed(list.rowOf(number)).kept.isEmpty(); };
    };
    return !reported_ && recorded && std::ranges::all_of(work.runs, in(parts_.runs.runs())) &&
           std::ranges::all_of(work.solutions, in(parts_.film.solutions())) &&
           std::ranges::all_of(work.studies, [this](const std::string& kind) {
               return QFile::exists(folder_->studyFile(QString::fromStdString(kind)));
           });
}

void Session::close(bool keep)
{
    if (!folder_) return;
    soon_.stop();
    wait();
    if (keep) {
        SessionState last = state();
        last.written = QDateTime::currentDateTimeUtc();
        last.closed = true;
        states_.post([file = folder_->stateFile(), text = toJson(last)] { return writeWholeFile(file, text); });
        states_.wait();
        folder_.reset();
    } else {
        SessionFolder::remove(std::move(folder_));
    }
}

} // namespace touchdown
