// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_window.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QThread>

#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study/study_file_reader.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/parameter_text.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/save_dialog.h"

namespace touchdown {

namespace {

constexpr int pilotDelay = 500; // after the last change of the study [ms]

int threads() { return std::max(1, QThread::idealThreadCount()); }

/// Whether two plans perform the same.
bool alike(const StudyPlan& a, const StudyPlan& b)
{
    return a.kind == b.kind && a.text == b.text && a.options == b.options &&
           caseDifference(a.start.value, b.start.value).isEmpty();
}

bool showsNothing(const StudyReport& report)
{
    return report.charts.empty() && report.tables.empty() && report.findings.empty() && report.items.empty();
}

QString writeOutcome(const StudyOutcome& outcome, const QString& file)
{
    const StudyPlan& plan = outcome.plan;
    return QString::fromStdString(writeStudy(file.toStdString(), *outcome.report, plan.start.value,
                                             updateCaseText(plan.start.text, plan.start.value), plan.text,
                                             plan.options));
}

/// The folder of whole runs beside a study.
QString runsBeside(const QString& folder) { return QDir(folder).filePath(QStringLiteral("runs")); }

/// What the engine tells meanwhile stands beside its progress.
StudyPerformance onEngine(const StudyPlan& plan, const EngineTask& engine)
{
    return [plan, engine](int, const StudyCallback& callback) {
        std::string told;
        const StudyCallback both = [&](const StudyProgress& progress) {
            StudyProgress now = progress;
            if (!told.empty()) now.doing += "; " + told;
            return callback(now);
        };
        return performByEngine(plan, engine, both, [&](const std::string& text) { told = text; });
    };
}

} // namespace

StudyWindow::StudyWindow(StudyCatalogue catalogue, QWidget* parent)
    : QObject(parent),
      editor_(new StudyEditor(std::move(catalogue), parent)),
      results_(new StudyResults(parent)),
      progress_(new ProgressStrip(controller_, tr("study"), tr("Running"), parent))
{
    connect(&controller_, &StudyController::stateChanged, editor_,
            [this] { editor_->setRunning(controller_.active(), underWay(shown_)); });
    connect(&controller_, &StudyController::partial, this, [this](int, const StudyReport& report) {
        outcomes_[performing_].report = report;
        if (shown_ == performing_) results_->setReport(report, true);
    });
    connect(&controller_, &StudyController::finished, this,
            [this](int, const StudyReport& report) { onFinished(report); });
    connect(editor_->kinds(), &QComboBox::currentIndexChanged, this, &StudyWindow::show);
    connect(editor_, &StudyEditor::planned, this, &StudyWindow::updateStale);
    connect(editor_, &StudyEditor::stopRequested, &controller_, &StudyController::stop);
    connect(editor_, &StudyEditor::succeeded, this, &StudyWindow::succeeded);
    connect(editor_, &StudyEditor::failed, this, &StudyWindow::failed);
    connect(results_, &StudyResults::succeeded, this, &StudyWindow::succeeded);
    connect(results_, &StudyResults::saveRequested, this, &StudyWindow::chooseSave);
    connect(results_, &StudyResults::applyRequested, this, [this] {
        if (results_->report() && results_->report()->found)
            emit applyRequested(*results_->report()->found, QString::fromStdString(results_->report()->title));
    });
    results_->setOpening([this](int row) {
        return !runOf(row).isEmpty() ? tr("Open the run") : hasCase(row) ? tr("Open the case") : QString();
    });
    connect(results_, &StudyResults::openRequested, this, [this](int row) {
        if (const QString file = runOf(row); !file.isEmpty()) return emit runRequested(file);
        const StudyOutcome* of = outcome(shown_);
        if (hasCase(row))
            emit caseRequested(of->plan.caseOf(std::size_t(row)),
                               tr("row %1 of %2").arg(QString::number(row + 1), readable(of->report->title)));
    });
    pilotSoon_.setSingleShot(true);
    pilotSoon_.setInterval(pilotDelay);
    connect(&pilotSoon_, &QTimer::timeout, this, &StudyWindow::startPilot);
    connect(editor_, &StudyEditor::planned, this, &StudyWindow::updateDuration);
    connect(editor_, &StudyEditor::hidden, &pilot_, &StudyPilot::stop);
    connect(&pilot_, &StudyPilot::failed, this, [this] { editor_->setDuration({}); });
    connect(&pilot_, &StudyPilot::estimated, this, [this](std::optional<double> seconds) {
        duration_ = seconds ? tr("Takes %1.").arg(roughTime(*seconds))
                            : tr("How long it takes cannot be told: no part of it is done within seconds.");
        editor_->setDuration(duration_);
    });
    shown_ = editor_->kind().toStdString();
}

bool StudyWindow::perform(const std::optional<EngineTask>& engine)
{
    const StudyPlan& plan = editor_->plan();
    if (!plan.valid() || !plan.perform) return false;
    const QString folder = engine ? QString::fromStdString(engine->folder.string()) : editor_->folder();
    const QString runs = plan.keepsFiles && !folder.isEmpty() ? runsBeside(folder) : QString();
    if (plan.keepsFiles && runs.isEmpty()) {
        emit failed(tr("This study keeps the results of its runs in a folder beside its file: save the study first."));
        return false;
    }
    controller_.stopAndWait();
    pilotSoon_.stop();
    pilot_.stopAndWait();
    performing_ = plan.kind;
    StudyPerformance work = plan.perform;
    taken_ = std::make_shared<std::size_t>(0);
    byEngine_ = engine.has_value();
    if (engine) {
        work = onEngine(plan, *engine);
    } else if (plan.performList) {
        const auto kept = std::make_shared<KeptRows>();
        // Rows of a file that was opened count only where the study goes on.
        if (const StudyOutcome* before = outcome(performing_);
            before != nullptr && before->report && (before->number > 0 || goesOn()))
            for (const StudyItem& item : before->report->items) kept->emplace(item.key, item.row);
        work = [list = plan.performList, kept, taken = taken_,
                files = runs.toStdString()](int jobs, const StudyCallback& callback) {
            return list({.jobs = jobs, .files = files, .kept = kept.get(), .addsUnused = false, .taken = taken.get()},
                        callback);
        };
    }
    StudyOutcome& outcome = outcomes_[performing_] = {plan, {}, {}, 0, runs};
    outcome.number = controller_.start(std::move(work), threads());
    updateDuration();
    show();
    emit started();
    return true;
}

bool StudyWindow::hasCase(int row) const
{
    const StudyOutcome* of = outcome(shown_);
    if (of == nullptr || !of->plan.caseOf || !of->report || of->report->tables.empty()) return false;
    // Where rows are missing, it is not known whose case a row is.
    return row >= 0 && std::size_t(row) < of->plan.items && of->report->tables.front().rows.size() == of->plan.items;
}

QString StudyWindow::runOf(int row) const
{
    const StudyOutcome* of = outcome(shown_);
    if (of == nullptr || !of->report || of->report->tables.empty() || row < 0) return {};
    const StudyTable& table = of->report->tables.front();
    const auto column = std::ranges::find(table.columns, "file", &StudyColumn::name) - table.columns.begin();
    if (std::size_t(column) == table.columns.size() || std::size_t(row) >= table.rows.size()) return {};
    const auto* name = std::get_if<std::string>(&table.rows[std::size_t(row)][std::size_t(column)]);
    // A report may come from a stranger: a name of ours, never a way to another folder.
    if (name == nullptr || !isItemFile(*name)) return {};
    const QString folder =
        of->runs.isEmpty() && !editor_->folder().isEmpty() ? runsBeside(editor_->folder()) : of->runs;
    const QString file = QDir(folder).filePath(QString::fromStdString(*name));
    return !folder.isEmpty() && QFileInfo(file).isFile() ? file : QString();
}

bool StudyWindow::goesOn() const
{
    const StudyOutcome* last = outcome(editor_->kind().toStdString());
    if (last == nullptr || !last->report || last->report->items.empty()) return false;
    const StudyPlan& plan = editor_->plan();
    return plan.performList && last->report->items.size() < plan.items && alike(last->plan, plan);
}

void StudyWindow::onFinished(StudyReport report)
{
    // What stopped with an error has told what it had before.
    if (const auto before = outcomes_.find(performing_);
        report.status == StudyStatus::Failed && showsNothing(report) && before->second.report) {
        StudyReport known = *before->second.report;
        known.status = report.status;
        known.message = report.message;
        report = std::move(known);
    }
    QString text = tr("%1 · %2").arg(readable(report.title), timeText(report.wallSeconds));
    outcomes_[performing_].isContinued = *taken_ > 0;
    if (*taken_ > 0)
        text += tr(" · %1 of %2 rows were there already").arg(*taken_).arg(outcomes_[performing_].plan.items);
    progress_->conclude(name(report.status), text);
    if (report.status == StudyStatus::Cancelled && showsNothing(report)) {
        if (byEngine_) emit succeeded(sentence(report.message));
        outcomes_.erase(performing_);
    } else {
        outcomes_[performing_].report = report;
    }
    if (shown_ == performing_) show();
    updateDuration();
    emit ended(report);
}

void StudyWindow::updateDuration()
{
    const StudyPlan& plan = editor_->plan();
    pilotSoon_.stop();
    const auto say = [&](const QString& sentence) {
        pilot_.stop();
        editor_->setDuration(sentence);
    };
    if (!plan.valid() || controller_.active()) return say({}); // its own progress tells the time left
    const StudyOutcome* last = outcome(plan.kind);
    if (goesOn()) return say({}); // an estimate is of all rows
    if (last != nullptr && last->report && last->report->status == StudyStatus::Completed && alike(last->plan, plan))
        return say(last->isContinued ? QString() : tr("Took %1.").arg(timeText(last->report->wallSeconds)));
    if (!plan.openEnd.empty()) return say(tr("How long it takes cannot be told: %1.").arg(readable(plan.openEnd)));
    if (alike(estimated_, plan)) {
        if (pilot_.state() == StudyPilot::State::Running) return editor_->setDuration(tr("Estimating the time…"));
        if (!duration_.isEmpty()) return editor_->setDuration(duration_);
    }
    estimated_ = plan;
    duration_.clear();
    say({});
    pilotSoon_.start();
}

void StudyWindow::setOthersBusy(bool busy)
{
    if (busy == std::exchange(othersBusy_, busy)) return;
    if (!busy && editor_->isVisible()) updateDuration();
    if (!busy || !pilot_.active()) return;
    pilot_.stop();
    editor_->setDuration({});
}

void StudyWindow::startPilot()
{
    if (!editor_->isVisible() || othersBusy_ || controller_.active() || !estimated_.perform) return;
    editor_->setDuration(tr("Estimating the time…"));
    pilot_.start(estimated_.perform, threads());
}

void StudyWindow::show()
{
    shown_ = editor_->kind().toStdString();
    editor_->setRunning(controller_.active(), underWay(shown_));
    const auto outcome = outcomes_.find(shown_);
    if (outcome == outcomes_.end() || !outcome->second.report)
        results_->clear(underWay(shown_));
    else
        results_->setReport(*outcome->second.report, underWay(shown_));
    updateStale();
}

void StudyWindow::updateStale()
{
    editor_->setContinues(!underWay(shown_) && goesOn());
    const auto outcome = outcomes_.find(shown_);
    if (outcome == outcomes_.end() || underWay(shown_)) return;
    results_->setStale(!alike(outcome->second.plan, editor_->plan()));
}

const StudyOutcome* StudyWindow::outcome(const std::string& kind) const
{
    const auto found = outcomes_.find(kind);
    return found == outcomes_.end() ? nullptr : &found->second;
}

const StudyReport* StudyWindow::unsaved(const std::string& kind) const
{
    const StudyOutcome* latest = outcome(kind);
    const bool lost = latest && latest->report && !latest->file.holds() && !showsNothing(*latest->report);
    return lost ? &*latest->report : nullptr;
}

void StudyWindow::restore(StoredStudy stored, const QString& file)
{
    const std::string kind = stored.report.kind;
    StudyPlan plan = reopenStudy(stored);
    if (!plan.valid()) { // its case names files that are not here
        plan = {};
        plan.kind = kind;
        plan.text = std::move(stored.studyText);
        plan.start = parseCase(std::move(stored.caseText), stored.report.title);
    }
    plan.title = stored.report.title;
    if (plan.valid() && plan.options.empty()) editor_->showTextOf(kind, plan.text);
    const QString runs = file.isEmpty() ? QString() : runsBeside(QFileInfo(file).absolutePath());
    outcomes_[kind] = {std::move(plan), std::move(stored.report), SavedFile(file), 0, runs};
    show();
}

QString StudyWindow::save(const std::string& kind, const QString& file)
{
    StudyOutcome& outcome = outcomes_.at(kind);
    const QString problem = writeOutcome(outcome, file);
    if (problem.isEmpty()) outcome.file = SavedFile(file);
    return problem;
}

void StudyWindow::chooseSave()
{
    askAndSave(results_, tr("Save the report"), {tr("HDF5, all of the report (*.h5)")},
               QString::fromStdString(shown_) + QStringLiteral(".h5"),
               [this, kind = shown_, outcome = outcomes_.at(shown_)](const QString& file) {
                   const QString problem = writeOutcome(outcome, file);
                   if (!problem.isEmpty()) return problem;
                   // A newer study of the kind may have begun while the dialog was open.
                   if (const auto now = outcomes_.find(kind);
                       now != outcomes_.end() && now->second.number == outcome.number)
                       now->second.file = SavedFile(file);
                   emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(file)));
                   return problem;
               });
}

} // namespace touchdown
