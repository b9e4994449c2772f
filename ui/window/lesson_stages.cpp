// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/lesson_stages.h"

#include <algorithm>

#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/runs/side_view.h"

namespace touchdown {

namespace {

std::optional<PlotRange> rangeOf(double low, double high)
{
    return high > low ? std::optional(PlotRange{low, high}) : std::nullopt;
}

} // namespace

LessonStages::LessonStages(RunView& view, RunsModel& runs, QObject* parent) : QObject(parent), view_(view), runs_(runs)
{
    // Whatever runs while a step is shown belongs to it, also what the reader changed.
    connect(&runs_, &RunsModel::added, this, [this](int number) {
        if (step_) numbers_[*step_].insert(number);
    });
}

void LessonStages::tick(int row, bool shown)
{
    if (runs_.record(row).shown != shown)
        runs_.setData(runs_.index(row), shown ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
}

bool LessonStages::hasRuns(const LessonStep& step) const
{
    const auto found = numbers_.find(step.title);
    return found != numbers_.end() &&
           std::ranges::any_of(found->second, [this](int number) { return runs_.find(number) != nullptr; });
}

void LessonStages::show(const LessonStep& step)
{
    const LessonStage& stage = step.stage;
    const std::set<int>& own = numbers_[step.title];
    int newest = -1;
    for (int row = 0; row < runs_.count(); ++row) {
        const int number = runs_.record(row).number;
        const bool ofLesson =
            std::ranges::any_of(numbers_, [number](const auto& s) { return s.second.contains(number); });
        if (!step_ && runs_.record(row).shown && !ofLesson) before_.insert(number);
        tick(row, own.contains(number));
        if (own.contains(number)) newest = number;
    }
    step_ = step.title;
    for (SideView* side : view_.sides()) side->showRun(newest);
    view_.setPage(RunView::Page::Plots);
    PlotStage plots;
    for (const std::string& name : stage.plots) plots.plots << QString::fromStdString(name);
    plots.side = stage.side;
    plots.spectrum = stage.spectrum;
    plots.time = rangeOf(stage.from, stage.until);
    plots.spacing = rangeOf(stage.lowest, stage.highest);
    view_.setStage(plots);
}

void LessonStages::end()
{
    if (!step_) return;
    step_.reset();
    const auto isThere = [this](int number) { return runs_.find(number) != nullptr; };
    if (std::ranges::any_of(before_, isThere))
        for (int row = 0; row < runs_.count(); ++row) tick(row, before_.contains(runs_.record(row).number));
    before_.clear();
    view_.setStage(std::nullopt);
}

} // namespace touchdown
