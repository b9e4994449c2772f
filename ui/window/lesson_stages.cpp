// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/lesson_stages.h"

#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"

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

void LessonStages::show(std::size_t step, const LessonStage& stage)
{
    step_ = step;
    const std::set<int>& own = numbers_[step];
    for (int row = 0; row < runs_.count(); ++row) {
        const bool shown = own.contains(runs_.record(row).number);
        if (runs_.record(row).shown != shown)
            runs_.setData(runs_.index(row), shown ? Qt::Checked : Qt::Unchecked, Qt::CheckStateRole);
    }
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
    step_.reset();
    view_.setStage(std::nullopt);
}

} // namespace touchdown
