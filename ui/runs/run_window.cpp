// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_window.h"

#include <utility>

#include "core/simulation/run.h"
#include "ui/calculation/progress_strip.h"
#include "ui/lists/record_panel.h"
#include "ui/plot/cursor_table.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_maps.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/side_view.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

RunWindow::RunWindow(QWidget* parent)
    : QObject(parent),
      view_(new RunView(runs_, parent)),
      panel_(new RecordPanel(runs_, RecordPanel::wordsOfRuns(), parent)),
      values_(new CursorTable(view_->plots()->group(), parent)),
      progress_(new ProgressStrip(controller_, tr("run"), tr("Running"), parent))
{
    connect(&controller_, &RunController::delivered, this, &RunWindow::onDelivered);
    connect(&controller_, &RunController::finished, this, [this](int, const Summary& summary) { onFinished(summary); });
    connect(&controller_, &RunController::recordingFailed, this, [this] { runs_.setRecording(number_, {}); });
    values_->add(view_->spectrum()->view()->group());
    connect(view_->plots(), &LivePlots::differencesMade, &memory_, &RunMemory::schedule);
    connect(view_->plots(), &LivePlots::curvesChanged, values_, &CursorTable::scheduleUpdate);
    connect(view_->spectrum()->view(), &SpectrumView::curvesChanged, values_, &CursorTable::scheduleUpdate);
    connect(panel_, &RecordPanel::recordChosen, view_->maps(), &RunMaps::showRun);
    connect(panel_, &RecordPanel::recordHovered, &runs_, &RunsModel::raise);
    for (SideView* side : view_->sides()) connect(panel_, &RecordPanel::recordChosen, side, &SideView::showRun);
}

RunWindow::~RunWindow()
{
    runs_.disconnect();
    memory_.disconnect();
    controller_.disconnect();
}

void RunWindow::start(RunRequest request)
{
    controller_.stopAndWait();
    add(request);
    if (restOf_) request.options.rest = restOf_(request.value);
    controller_.start(std::move(request));
}

void RunWindow::announce(int number)
{
    if (number_ >= 0) {
        announced_ = number;
        return;
    }
    const RunRecord* run = runs_.find(number);
    if (!run || !run->summary) return;
    emit started(number);
    conclude(*run->summary);
    emit ended(number, *run->summary);
}

void RunWindow::conclude(const Summary& summary)
{
    QString text = tr("%1 simulated · %L2 steps · solver %3")
                       .arg(timeText(summary.endTime))
                       .arg(summary.steps)
                       .arg(timeText(summary.solverSeconds));
    if (summary.threads > 1) text += tr(" · %1 threads").arg(summary.threads);
    progress_->conclude(name(summary.status), text);
}

void RunWindow::add(const RunRequest& request)
{
    // Another model has other quantities over another time.
    for (int row = 0; row < runs_.count(); ++row)
        if (runs_.record(row).shown && runs_.record(row).value.model != request.value.model)
            runs_.setData(runs_.index(row), Qt::Unchecked, Qt::CheckStateRole);
    auto record = std::make_unique<RunRecord>(runs_.nextNumber(), request.value, request.caseText,
                                              recordedQuantities(request.value));
    number_ = runs_.add(std::move(record)).number;
    runs_.setRecording(number_, QString::fromStdString(request.recordTo.string()));
    panel_->setActive(number_);
    view_->spectrum()->setOptionsOf(request.value);
    emit started(number_);
}

void RunWindow::onDelivered(const RunDelivery& delivery)
{
    if (RunRecord* run = runUnderWay(); run && delivery.sets) run->setFields(*delivery.sets);
    runs_.append(number_, delivery.samples, delivery.events, delivery.fields);
    if (RunRecord* run = runUnderWay()) run->keep(delivery.checkpoints);
    view_->plots()->dataArrived(number_);
    view_->spectrum()->dataArrived(number_);
    for (SideView* side : view_->sides()) side->dataArrived(number_);
    if (!delivery.fields.empty()) view_->maps()->dataArrived(number_);
    memory_.schedule();
}

void RunWindow::onFinished(const Summary& summary)
{
    const int number = std::exchange(number_, -1);
    runs_.finish(number, summary);
    if (const QString& file = runs_.find(number)->file; !file.isEmpty()) runs_.setFile(number, QString(file));
    panel_->setActive(-1);
    view_->plots()->runFinished(number);
    view_->spectrum()->runFinished(number);
    view_->maps()->dataArrived(number);
    memory_.schedule();
    conclude(summary);
    emit ended(number, summary);
    if (announced_ >= 0) announce(std::exchange(announced_, -1));
}

} // namespace touchdown
