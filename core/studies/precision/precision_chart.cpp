// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_report.h"

#include <algorithm>
#include <cmath>

#include "core/studies/precision/precision_runs.h"
#include "core/studies/precision/precision_task.h"
#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

/// An error below this share of what the reference does not know is drawn there.
constexpr double lowestShare = 0.01;
/// Runs without a valid end stand so far beyond the largest error, behind a border at its root [-].
constexpr double failedBeyond = 10.0;

/// Where on the axis of errors things stand.
struct ErrorScale {
    double uncertainty = 0.0; // of the reference
    double lowest = 0.0;      // > 0: a logarithmic axis has no zero
    double failed = 0.0, border = 0.0;
};

ErrorScale scaleOf(const PrecisionTask& task, const PrecisionRuns& runs)
{
    ErrorScale scale;
    scale.uncertainty = uncertaintyOf(task, runs);
    double least = INFINITY, largest = 0.0;
    for (const PrecisionPoint& point : runs.points)
        if (const auto error = errorOf(task, point); error && *error > 0.0) {
            least = std::min(least, *error);
            largest = std::max(largest, *error);
        }
    constexpr double some = 1e-15; // [unit of the quantity]
    if (largest == 0.0)
        least = largest = scale.uncertainty > 0.0         ? scale.uncertainty
                          : std::isfinite(task.agreement) ? task.agreement
                                                          : some;
    scale.lowest = scale.uncertainty > 0.0 ? lowestShare * scale.uncertainty : least;
    scale.failed = failedBeyond * std::max(largest, scale.uncertainty);
    scale.border = scale.failed / std::sqrt(failedBeyond);
    return scale;
}

ChartAxis errorAxis(const PrecisionTask& task)
{
    const ErrorUnit unit = unitOf(task, task.measure);
    return {std::string(title(task.measure)) + (task.measure >= ErrorMeasure::PeakFrequency ? "" : ", " + uncapitalized(task.quantity.longName)),
            unit.si, unit.displayed, true};
}

ChartAxis workAxis(const PrecisionTask& task)
{
    if (!task.inTime) return {"Linear solves", "", "", true};
    return {task.start.model == ModelKind::Film ? "Attitudes at which the film is solved" : "Right-hand sides", "", "",
            true};
}

template <class Height>
ChartPanel panelOf(const PrecisionTask& task, const PrecisionRuns& runs, const ErrorScale& scale, ChartAxis y,
                   Height height)
{
    ChartPanel panel{errorAxis(task), std::move(y), {}, {}, {}, false};
    for (const SweptMethod& method : task.methods)
        panel.series.push_back({method.name, {}, ChartLine::Solid, true, false});
    bool failed = false, elsewhere = false;
    for (const PrecisionPoint& point : runs.points) {
        const std::optional<double> error = errorOf(task, point);
        if (!point.ran || !(height(point) > 0.0) || (!error && point.kind == PointKind::Good)) continue;
        const MethodSetting& setting = task.methods[point.method].settings[point.setting];
        const double x = error ? std::max(*error, scale.lowest) : scale.failed;
        panel.series[point.method].points.push_back({x, height(point), setting.label, point.kind, setting.chosen});
        failed = failed || point.kind == PointKind::Failed;
        elsewhere = elsewhere || (!error && point.kind == PointKind::WrongState);
    }
    std::erase_if(panel.series, [](const ChartSeries& series) { return series.points.empty(); });
    ChartSeries front{"best of all", {}, ChartLine::Steps, false, true};
    for (const PrecisionPoint* point : paretoFront(task, runs, height))
        front.points.push_back({std::max(*worthOf(task, runs, *point), scale.lowest), height(*point)});
    if (!front.points.empty()) panel.series.push_back(std::move(front));
    if (scale.uncertainty > 0.0)
        panel.bands.push_back({true, -INFINITY, scale.uncertainty, "unknown to the reference"});
    if (failed || elsewhere)
        panel.bands.push_back({true, scale.border, INFINITY, elsewhere ? "without an error" : "no valid end"});
    return panel;
}

std::string captionOf(const PrecisionTask& task, const PrecisionRuns& runs, const ErrorScale& scale)
{
    const ProvenReference& reference = runs.reference;
    std::string caption =
        "Left is more accurate, down is faster. Time: the least of " + std::to_string(task.repeats) +
        " repeats after a warm-up; of one run where that takes longer than " + fewDigitsOfTime(task.timeLimit) +
        ". Ringed: the case's own setting. Grey line: settings that no other beats in both; for it the "
        "largest error of a setting and of all "
        "finer ones of its method counts, as a smaller one is by chance.";
    if (scale.uncertainty > 0.0)
        caption += " Shaded at the left: the reference and the run that proves it differ by " +
                   fewDigits(scale.uncertainty, errorAxis(task).displayUnit) +
                   "; smaller errors cannot be distinguished.";
    const auto isAny = [&](PointKind kind) {
        return std::ranges::any_of(runs.points,
                                   [&](const PrecisionPoint& point) { return point.ran && point.kind == kind; });
    };
    if (isAny(PointKind::WrongState))
        caption += " Hollow: ends in another state than the reference; at the right edge where that leaves it without "
                   "an error.";
    if (isAny(PointKind::Failed))
        caption += " Crosses at the right edge: no valid end, and the time after which they failed.";
    if (reference.horizon)
        caption += " From " + fewDigitsOfTime(*reference.horizon, 3) +
                   " of simulated time on the trajectory is not determined; errors are those before that time.";
    return caption;
}

} // namespace

StudyChart precisionChart(const PrecisionTask& task, const PrecisionRuns& runs)
{
    const ErrorScale scale = scaleOf(task, runs);
    StudyChart chart{"Accuracy against speed", captionOf(task, runs, scale), {}};
    chart.panels.push_back(panelOf(
        task, runs, scale, {"Time of the solver", "s", task.start.model == ModelKind::Springs ? "ms" : "s", true},
        [](const PrecisionPoint& point) { return point.fastest(); }));
    chart.panels.push_back(
        panelOf(task, runs, scale, workAxis(task), [](const PrecisionPoint& point) { return point.work; }));
    return chart;
}

} // namespace touchdown
