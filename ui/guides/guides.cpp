// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/guides.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QSettings>

#include "core/studies/study/sample_study.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/guides/guide_strip.h"
#include "ui/guides/lesson_stages.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/live_values.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/message_strip.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

namespace {

using Kind = LessonPane::Kind;

/// Of the pane, and of the setting with its last step.
QString nameOf(Kind kind) { return kind == Kind::Lesson ? QStringLiteral("lesson") : QStringLiteral("demonstrations"); }

QString settingOf(Kind kind) { return nameOf(kind) + QStringLiteral("/step"); }

} // namespace

Guides::Guides(Workbench& bench, QWidget& window)
    : QObject(&window),
      bench_(bench),
      window_(window),
      stages_(new LessonStages(*bench.runWindow().view(), bench.runWindow().runs(), this)),
      live_(new LiveRuns(bench, this)),
      strip_(new GuideStrip(&window))
{
    follow(strip_->live());
    connect(&bench_.files(), &CaseFiles::opened, this, &Guides::leave);
    connect(&bench_.edits(), &CaseEdits::edited, this, &Guides::showLive);
    connect(&bench_.edits(), &CaseEdits::undoneOrRedone, this, &Guides::followUndo);
    connect(&bench_.runWindow(), &RunWindow::ended, this, &Guides::showResults);
    connect(&bench_.runWindow().runs(), &RunsModel::rowsRemoved, this, &Guides::showResults);
}

void Guides::follow(const LiveValues& values)
{
    connect(&values, &LiveValues::moved, live_, &LiveRuns::move);
    connect(&values, &LiveValues::settled, live_, &LiveRuns::settle);
}

void Guides::toggle(QWidget* pane, bool open)
{
    if (open) {
        shown_ = static_cast<LessonPane*>(pane);
        if (shown_->kind() == Kind::Lesson || ownCase_) stage(); // else once the case of the figure is open
    } else if (pane == shown_) {
        shown_ = nullptr;
        ownCase_ = false;
        showWords();
        stages_->end();
    }
}

bool Guides::staged() const { return stages_->active(); }

bool Guides::openedCase() const { return !opens_.isEmpty() && bench_.files().sample() == opens_; }

void Guides::leave()
{
    ownCase_ = false;
    stages_->end();
    bench_.runWindow().view()->plots()->setWords({});
    showLive();
}

/// Values are moved of the case of the step alone, not of the reader's own.
void Guides::showLive()
{
    for (LessonPane* pane : panes_) {
        if (!pane) continue;
        pane->live().setEnabled(ownCase_ && pane == shown_);
        pane->live().setToolTip(
            plainTip(ownCase_ ? QString() : tr("The case of this figure is not open. Shift+F2 opens it.")));
        pane->live().showCase(bench_.edits().value());
    }
    strip_->live().setEnabled(ownCase_);
    strip_->live().showCase(bench_.edits().value());
}

/// Undo moves the sliders of a demonstration, too: the plots follow. What runs already is not stopped.
void Guides::followUndo()
{
    if (!onlyTried() || shown_->kind() != Kind::Demonstrations || bench_.runWindow().runUnderWay()) return;
    if (const RunRecord* run = stages_->newestOf(shown_->shown(), &bench_.edits().value())) {
        const int number = run->number;
        live_->leave(); // what is undone
        bench_.runWindow().runs().raise(number);
    } else if (stages_->newestOf(shown_->shown()))
        live_->runAnew();
}

void Guides::present(bool on)
{
    presented_ = on;
    showStrip();
}

void Guides::showStrip()
{
    strip_->follow(presented_ ? shown_ : nullptr);
    bench_.messages().keepPlace(strip_->isHidden());
    bench_.runWindow().view()->spectrum()->view()->showControls(strip_->isHidden());
}

/// Whether another case would take more from the reader than values that were tried in a step: a shape that was drawn.
bool Guides::maybeLost() const
{
    const CaseEdits& edits = bench_.edits();
    return !ownCase_ || !bench_.files().file().isEmpty() || edits.value().surface != edits.opened().surface;
}

bool Guides::onlyTried() const
{
    if (!ownCase_ || !shown_ || !bench_.files().file().isEmpty()) return false;
    const Case& now = bench_.edits().value();
    Case moved = bench_.edits().opened();
    for (const LiveValue& value : shown_->shown().live)
        for (const std::string& key : value.keys)
            setFromText(moved, *findParameter(key), toText(now, *findParameter(key)));
    return moved == now;
}

void Guides::go(int steps)
{
    if (!shown_) return;
    const auto step = static_cast<int>(shown_->step()) + steps;
    if (step >= 0 && step < static_cast<int>(shown_->count())) shown_->go(static_cast<std::size_t>(step));
}

void Guides::stage()
{
    if (shown_) stages_->show(shown_->shown());
}

LessonPane* Guides::build(Kind kind)
{
    const bool lesson = kind == Kind::Lesson;
    auto* pane = new LessonPane(kind, lesson ? lessonSteps() : demonstrationSteps(), &window_);
    connect(pane, &LessonPane::runRequested, this, &Guides::perform);
    connect(pane, &LessonPane::stepShown, this, [this, kind] { onStep(kind); });
    connect(pane, &LessonPane::keyChosen, this, &Guides::keyChosen);
    follow(pane->live());
    return pane;
}

void Guides::open(Kind kind)
{
    LessonPane*& pane = panes_[static_cast<std::size_t>(kind)];
    const bool first = pane == nullptr;
    if (first) pane = build(kind);
    const QString title = kind == Kind::Lesson ? tr("Lesson") : tr("Demonstrations");
    for (LessonPane* other : panes_)
        if (other && other != pane) emit paneLeft(other);
    shown_ = pane;
    emit paneWanted(pane, nameOf(kind), title);
    if (first)
        pane->go(QSettings().value(settingOf(kind), 0).toUInt());
    else if (!stages_->active() || (kind == Kind::Demonstrations && !ownCase_))
        onStep(kind);
    if (presented_) showStrip();
}

void Guides::onStep(Kind kind)
{
    LessonPane* pane = this->pane(kind);
    QSettings().setValue(settingOf(kind), static_cast<int>(pane->step()));
    shown_ = pane;
    if (presented_) showStrip();
    showLive();
    emit stepShown();
    const LessonStep& step = pane->shown();
    if (kind == Kind::Lesson || step.runs.empty() || !step.runs.front().kind.empty()) return showStep();
    // A demonstration on springs is there at once; a film takes its time, and waits for the button. The page stays as
    // it is where the reader keeps the case that is edited.
    const bool quick = followsHand(caseOf(step.runs.front()));
    openCaseOf(step.runs.front(), quick && !stages_->newestOf(step));
    if (opens_.isEmpty()) return;
    ownCase_ = false; // at least until the question about the other case is answered
    showLive();
}

void Guides::showStep()
{
    bench_.setPage(Workbench::Page::Run);
    stage();
    showResults();
    showLive();
    bench_.messages().clear(); // of another step
}

/// Of the runs of the step that are in the list and have ended.
void Guides::showResults()
{
    if (!shown_) return;
    for (const auto& [index, number] : numbers_[shown_->shown().title]) {
        const RunRecord* run = bench_.runWindow().runs().find(number);
        if (run && run->summary)
            shown_->showResult(index, lessonResult(*run, shown_->shown().stage.from),
                               run->summary->status == RunStatus::Completed);
        else
            shown_->showResult(index, {});
    }
    showWords();
}

/// At the curves of the step's runs that have ended.
void Guides::showWords()
{
    std::vector<LivePlots::Word> words;
    if (shown_) words = lessonWords(shown_->shown(), numbers_[shown_->shown().title], bench_.runWindow().runs());
    bench_.runWindow().view()->plots()->setWords(std::move(words));
}

void Guides::perform(const LessonRun& run)
{
    if (!run.kind.empty()) {
        bench_.studies().editor()->openSample(*findSampleStudy(run.kind, run.name));
        bench_.performStudy();
        return;
    }
    openCaseOf(run, true);
}

/// The same run again takes the place of the former one, unless the reader has worked with that.
void Guides::dropReplaced(int number)
{
    const RunRecord* run = bench_.runWindow().runs().find(number);
    if (run && run->finished() && run->note.isEmpty() && bench_.runWindow().runs().baseline() != number)
        bench_.runWindow().runs().remove(bench_.runWindow().runs().rowOf(number));
}

/// A demonstration that comes back shows the run of the values that the reader moved last: the values stand there, too.
void Guides::takeValuesOfNewestRun()
{
    const RunRecord* run = shown_ ? stages_->newestOf(shown_->shown()) : nullptr;
    if (!run) return;
    Case moved = bench_.edits().value();
    for (const LiveValue& value : shown_->shown().live)
        for (const std::string& key : value.keys) {
            const Parameter& parameter = *findParameter(key);
            parameter.set(moved, parameter.get(run->value));
        }
    if (moved == run->value && moved != bench_.edits().value())
        bench_.edits().setAll(moved, tr("values of run %1").arg(run->number));
}

void Guides::openCaseOf(const LessonRun& run, bool start)
{
    CaseFiles& files = bench_.files();
    if (!maybeLost()) files.leaveUnsaved();
    opens_ = QString::fromStdString(run.name);
    files.openChanged(QString::fromStdString(run.name), run.settings, [this, start, run] {
        opens_.clear();
        ownCase_ = true;
        showStep();
        if (!start) return takeValuesOfNewestRun();
        bench_.startRun();
        RunRecord* started = bench_.runWindow().runUnderWay();
        if (!started || !shown_) return;
        started->ofGuide = true;
        const std::vector<LessonRun>& runs = shown_->shown().runs;
        const auto found = std::ranges::find(runs, run);
        if (found != runs.end()) {
            const auto index = static_cast<std::size_t>(found - runs.begin());
            const auto [number, first] = numbers_[shown_->shown().title].try_emplace(index, started->number);
            if (!first) dropReplaced(std::exchange(number->second, started->number));
        }
        showResults();
    });
}

} // namespace touchdown
