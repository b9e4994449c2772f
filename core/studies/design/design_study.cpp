// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "core/formats/units.h"
#include "core/studies/design/design_task.h"
#include "core/studies/study/growing_report.h"
#include "core/studies/study/study_reader.h"
#include "core/work/parallel.h"

namespace touchdown {

namespace {

/// The grid's error where it is estimated.
double gridError(const DiscretisationError& error, const std::string& quantity)
{
    if (quantity == "minimum_spacing") return error.minimumSpacing;
    if (quantity == "pitch") return error.pitch;
    if (quantity == "roll") return error.roll;
    return 0.0;
}

void addFindings(const DesignTask& task, const DesignStudy& study, StudyReport& report)
{
    const DesignPoint& best = study.steps.back();
    const std::string states = std::to_string(study.solves) + " static states.";
    report.findings.push_back((study.status == StudyStatus::Completed ? "All targets are reached after "
                                                                      : "Not all targets are reached after ") +
                              states);
    for (std::size_t i = 0; i < best.parameters.size(); ++i) {
        const DesignParameter& parameter = task.parameters[i];
        const Parameter& key = parameter.keys.front();
        report.findings.push_back(key.key + ": " + fewDigits(best.parameters[i], key.displayUnit, 8) + ", from " +
                                  fewDigits(parameter.start, key.displayUnit, 8) + ".");
    }
    for (std::size_t i = 0; i < best.quantities.size(); ++i) {
        const DesignTarget& target = task.targets[i];
        const std::string& unit = target.quantity.displayUnit;
        const double error = gridError(study.state.discretisationError, target.quantity.name);
        report.findings.push_back(target.quantity.name + ": " + fewDigits(best.quantities[i], unit, 5) +
                                  (error > 0.0 ? " (grid error about " + fewDigits(error, unit, 2) + ")" : "") +
                                  ", wanted " + fewDigits(target.value, unit, 5) + " within " +
                                  fewDigits(target.tolerance, unit, 3) + ".");
    }
    for (std::size_t i = 0; i < best.quantities.size(); ++i) {
        const DesignTarget& target = task.targets[i];
        const double error = gridError(study.state.discretisationError, target.quantity.name);
        if (error > target.tolerance)
            report.warnings.push_back(target.quantity.name + " is compared with its target on this grid: the error " +
                                      "of the grid, about " + fewDigits(error, target.quantity.displayUnit, 2) +
                                      ", is larger than the tolerance of " +
                                      fewDigits(target.tolerance, target.quantity.displayUnit, 3) +
                                      ". A finer grid or a wider tolerance is needed to rely on it.");
    }
    if (!study.state.message.empty()) report.warnings.push_back("static state: " + study.state.message);
}

StudyChart chartOf(const DesignStudy& study)
{
    ChartSeries best{.name = "best set", .line = ChartLine::Steps};
    for (const DesignPoint& point : study.steps)
        if (point.problem.empty() && point.misfit > 0.0)
            best.points.push_back({.x = double(point.iteration), .y = point.misfit});
    if (!best.points.empty()) best.points.back().chosen = true;
    ChartPanel panel;
    panel.x = {.label = "Iteration"};
    panel.y = {.label = "Largest misfit, in tolerances", .logarithmic = true};
    panel.series = {best};
    panel.bands = {{.alongX = false,
                    .lower = -std::numeric_limits<double>::infinity(),
                    .upper = 1.0,
                    .label = "all targets are reached"}};
    return {.title = "Misfit over the iterations",
            .caption = "Each point is a better set of values; where the targets are reached, the last one has as few "
                       "digits as reach them. The misfit is the largest distance of a quantity from its target, "
                       "divided by the tolerance of the target.",
            .panels = {panel}};
}

StudyTable stepsOf(const DesignTask& task, const DesignStudy& study)
{
    StudyTable table{.name = "steps", .columns = {{"iteration", "", "", "Iteration"}}};
    for (const DesignParameter& parameter : task.parameters) {
        const Parameter& key = parameter.keys.front();
        table.columns.push_back({key.key, key.unit, key.displayUnit, "Parameter " + key.key});
    }
    for (const DesignTarget& target : task.targets) {
        const Quantity& quantity = target.quantity;
        table.columns.push_back({quantity.name, quantity.unit, quantity.displayUnit, quantity.longName});
    }
    table.columns.push_back({"misfit", "", "", "Largest misfit, in tolerances"});
    for (const DesignPoint& point : study.steps) {
        std::vector<StudyValue>& row = table.rows.emplace_back();
        row.emplace_back(double(point.iteration));
        for (const double value : point.parameters) row.emplace_back(value);
        for (const double value : point.quantities) row.emplace_back(value);
        row.resize(table.columns.size() - 1);
        row.push_back(known(point.problem.empty(), point.misfit));
    }
    return table;
}

/// Numbers in the SI unit that stands in their row.
StudyTable targetsOf(const DesignTask& task, const DesignStudy& study)
{
    StudyTable table{.name = "targets",
                     .columns = {{"quantity", "", "", "Quantity"},
                                 {"unit", "", "", "SI unit of the numbers of this row"},
                                 {"value", "", "", "Wanted value"},
                                 {"tolerance", "", "", "Tolerance"},
                                 {"found", "", "", "Value of the best set"},
                                 {"grid_error", "", "", "Estimated error of the grid"}}};
    const std::vector<double>& found = study.steps.back().quantities;
    for (std::size_t i = 0; i < task.targets.size(); ++i) {
        const DesignTarget& target = task.targets[i];
        const double error = gridError(study.state.discretisationError, target.quantity.name);
        table.rows.push_back({target.quantity.name, target.quantity.unit, target.value, target.tolerance,
                              i < found.size() ? StudyValue(found[i]) : StudyValue(), known(error > 0.0, error)});
    }
    return table;
}

/// What the search says of itself, for the thread of the study.
class SearchProgress {
public:
    void take(const DesignProgress& progress)
    {
        const std::lock_guard lock(mutex_);
        last_ = progress;
        first_ = std::max(first_, progress.misfit);
        if (progress.better) better_ = *progress.better;
    }
    /// The best set so far, once.
    std::optional<DesignStudy> better()
    {
        const std::lock_guard lock(mutex_);
        return std::exchange(better_, std::nullopt);
    }
    StudyProgress now() const
    {
        const std::lock_guard lock(mutex_);
        const double share = first_ > 1.0 ? 1.0 - std::log(std::max(last_.misfit, 1.0)) / std::log(first_) : 0.0;
        return {.share = share,
                .doing = "iteration " + std::to_string(last_.iteration) + ", " + std::to_string(last_.solves) +
                         " static states, largest misfit " + fewDigits(last_.misfit, "", 3) + " tolerances"};
    }

private:
    mutable std::mutex mutex_;
    DesignProgress last_;
    std::optional<DesignStudy> better_;
    double first_ = 0.0; // the largest misfit so far: that of the start
};

StudyReport perform(const Case& start, const DesignTask& task, const StudyCallback& callback)
{
    SearchProgress progress;
    DesignStudy study;
    const auto search = [&](std::size_t, const GoOn& goOn) {
        study = studyDesign(start, task, [&](const DesignProgress& now) {
            progress.take(now);
            return goOn();
        });
    };
    // Also where the search ended by itself before it was told to stop.
    const bool whole = runParallel(1, 1, search, [&](std::size_t) {
        const std::optional<DesignStudy> better = progress.better();
        return tellProgress(callback, progress.now(), better.has_value(), [&] { return designReport(task, *better); });
    });
    if (!whole && study.status != StudyStatus::Completed) study.status = StudyStatus::Cancelled;
    return designReport(task, study);
}

} // namespace

StudyReport designReport(const DesignTask& task, const DesignStudy& study)
{
    StudyReport report;
    report.status = study.status;
    report.message = study.message;
    if (study.steps.empty()) return report;
    addFindings(task, study, report);
    report.charts = {chartOf(study)};
    report.tables = {stepsOf(task, study), targetsOf(task, study)};
    if (study.status == StudyStatus::Completed) report.found = study.found;
    return report;
}

StudyPerformance planDesign(StudyReader& reader)
{
    return [start = reader.start(), task = readDesignTask(reader)](int, const StudyCallback& callback) {
        return perform(start, task, callback);
    };
}

} // namespace touchdown
