// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_stages.h"

#include <algorithm>
#include <cmath>

#include <QStringList>

#include "core/formats/units.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/runs/side_view.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr double leastSwing = 1e-11; // that is said [m]

std::optional<PlotRange> rangeOf(double low, double high)
{
    return high > low ? std::optional(PlotRange{low, high}) : std::nullopt;
}

/// Standard deviation of the minimum spacing from a time on [m].
double deviationFrom(const RunRecord& run, double from)
{
    const MinMaxPyramid* spacing = run.pyramid("minimum_spacing");
    if (!spacing || spacing->empty()) return 0.0;
    double count = 0.0, mean = 0.0, squares = 0.0; // West (1979)
    for (std::size_t i = 0; i < spacing->size(); ++i) {
        if (spacing->time(i) < from) continue;
        const double before = spacing->value(i) - mean;
        mean += before / ++count;
        squares += before * (spacing->value(i) - mean);
    }
    return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

} // namespace

QString lessonResult(const RunRecord& run, double from)
{
    const Summary& summary = *run.summary;
    QStringList parts;
    if (summary.status == RunStatus::Cancelled) return LessonStages::tr("stopped");
    if (summary.status != RunStatus::Completed) parts << LessonStages::tr("fails");
    if (const QString end = endText(run); !end.isEmpty()) parts << end;
    for (const RunFigure& figure : summary.figures)
        if (figure.quantity.name == "touch_downs")
            parts << (figure.value == 1.0 ? LessonStages::tr("1 touch")
                                          : LessonStages::tr("%L1 touches").arg(figure.value));
    const bool touched = std::ranges::any_of(summary.figures, [](const RunFigure& figure) {
        return figure.quantity.name == "touch_downs" && figure.value > 0.0;
    });
    for (const RunFigure& figure : summary.figures)
        if (touched && figure.quantity.name == "cycle_work")
            parts << QStringLiteral("W = %1").arg(trueMinus(QString::fromStdString(fewDigits(figure.value, "pJ", 3))));
    for (const auto& [quantity, tail] : summary.tail)
        if (quantity == "minimum_spacing" && summary.status == RunStatus::Completed &&
            tail.max - tail.min >= leastSwing) {
            if (!lasts(summary.verdict.motion))
                parts << LessonStages::tr("swings by %1").arg(lengthText(endSwing(summary), 3));
            parts << (from > 0.0 ? LessonStages::tr("standard deviation %1 from %2 on")
                                       .arg(lengthText(deviationFrom(run, from), 4), timeText(from))
                                 : LessonStages::tr("standard deviation %1").arg(lengthText(tail.std, 4)));
            if (const double frequency = summary.verdict.frequency; frequency > 0.0)
                parts << LessonStages::tr("at %1").arg(frequencyText(frequency));
        }
    return parts.join(QStringLiteral(" · "));
}

std::vector<LivePlots::Word> lessonWords(const LessonStep& step, const std::map<std::size_t, int>& numbers,
                                         const RunsModel& runs)
{
    std::vector<LivePlots::Word> words;
    for (const LessonMark& mark : step.marks)
        if (const auto found = numbers.find(mark.run); found != numbers.end()) {
            const RunRecord* run = runs.find(found->second);
            if (!run || !run->summary || run->summary->status == RunStatus::Cancelled) continue;
            words.push_back({found->second, QString::fromStdString(mark.plot), mark.at, readable(mark.text)});
        }
    return words;
}

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

const RunRecord* LessonStages::newestOf(const LessonStep& step, const Case* value) const
{
    const auto found = numbers_.find(step.title);
    for (int row = runs_.count() - 1; found != numbers_.end() && row >= 0; --row)
        if (const RunRecord& run = runs_.record(row);
            found->second.contains(run.number) && (!value || run.value == *value))
            return &run;
    return nullptr;
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
