// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/case/integrator_kind.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/precision/precision_runs.h"
#include "core/studies/precision/precision_task.h"

namespace touchdown {

namespace {

constexpr std::size_t mostTold = 5; // in a sentence

std::string endText(const PrecisionPoint& point)
{
    if (!point.ran) return "not run";
    return std::string(point.summary.status == RunStatus::Completed ? name(point.end.kind)
                                                                    : name(point.summary.failure));
}

std::string verdictText(const PrecisionPoint& point, const ProvenReference& reference)
{
    if (!point.ran) return "not run";
    if (point.kind == PointKind::Failed) return "failed";
    if (!reference.endKnown) return "not determined";
    return point.kind == PointKind::WrongState ? "other end" : "same end";
}

StudyValue valueOf(const std::vector<TrajectoryError>& errors, std::size_t quantity, ErrorMeasure measure)
{
    if (quantity >= errors.size()) return {};
    return known(errors[quantity].at(measure));
}

StudyTable runsTable(const PrecisionTask& task, const PrecisionRuns& runs)
{
    StudyTable table{"runs", {{.name = "method", .longName = "Method"}, {.name = "setting", .longName = "Setting"}}};
    const std::size_t shown = task.inTime ? errorMeasures : 1;
    for (std::size_t i = 0; i < shown; ++i) {
        const auto measure = static_cast<ErrorMeasure>(i);
        const ErrorUnit unit = unitOf(task, measure);
        StudyColumn column{"error_" + std::string(name(measure)), unit.si, unit.displayed, std::string(title(measure))};
        std::ranges::replace(column.name, '-', '_');
        column.secondary = task.inTime && measure != task.measure;
        table.columns.push_back(std::move(column));
    }
    for (const Quantity& also : task.also)
        table.columns.push_back(
            {"error_" + also.name, also.unit, also.displayUnit, "Largest error: " + also.longName, true});
    const std::string work = task.start.model == ModelKind::Springs ? "Right-hand sides" : "Film solves";
    const std::vector<StudyColumn> more{
        {"time", "s", "ms", "Shortest time of the solver"},
        {"time_median", "s", "ms", "Median time of the solver", true},
        {"timed", "", "", "Timed runs", true},
        {"work", "", "", work},
        {"steps", "", "", task.inTime ? "Accepted steps" : "Iterations on the finest grid", true},
        {"verdict", "", "", "Against the reference"},
        {"end", "", "", "End"},
        {"end_spacing", "m", "nm", "Mean spacing over the last tenth"},
        {"chosen", "", "", "The case's own", true},
        {"message", "", "", "Reason of the end"}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const PrecisionPoint& point : runs.points) {
        const MethodSetting& setting = task.methods[point.method].settings[point.setting];
        std::vector<StudyValue> row{task.methods[point.method].name, setting.label};
        for (std::size_t i = 0; i < shown; ++i) row.push_back(valueOf(point.errors, 0, static_cast<ErrorMeasure>(i)));
        for (std::size_t i = 0; i < task.also.size(); ++i)
            row.push_back(valueOf(point.errors, i + 1, ErrorMeasure::Worst));
        row.insert(row.end(),
                   {known(point.ran, point.fastest()), known(point.ran, point.median()),
                    known(point.ran, static_cast<double>(point.seconds.size())), known(point.ran, point.work),
                    known(point.ran, static_cast<double>(point.summary.steps)), verdictText(point, runs.reference),
                    endText(point), known(point.ran && point.end.kind != EndKind::Failed, point.end.spacing),
                    std::string(setting.chosen ? "yes" : ""), point.summary.message});
        table.rows.push_back(std::move(row));
    }
    return table;
}

StudyTable frontTable(const PrecisionTask& task, const PrecisionRuns& runs)
{
    const ErrorUnit unit = unitOf(task, task.measure);
    StudyTable table{"front",
                     {{.name = "method", .longName = "Method"},
                      {.name = "setting", .longName = "Setting"},
                      {"worth", unit.si, unit.displayed,
                       std::string(title(task.measure)) + ", no less than those of finer settings"},
                      {"time", "s", "ms", "Time of the solver"}}};
    for (const PrecisionPoint* point : paretoFront(task, runs, &PrecisionPoint::fastest)) {
        const SweptMethod& method = task.methods[point->method];
        table.rows.push_back(
            {method.name, method.settings[point->setting].label, *worthOf(task, runs, *point), point->fastest()});
    }
    return table;
}

const PrecisionPoint* findPoint(const PrecisionTask& task, const PrecisionRuns& runs,
                                const std::function<bool(const MethodSetting&)>& is)
{
    for (const PrecisionPoint& point : runs.points)
        if (point.ran && is(task.methods[point.method].settings[point.setting])) return &point;
    return nullptr;
}

std::string timesAs(double ratio, const std::string& more, const std::string& less, const std::string& same)
{
    if (fewDigits(ratio, "") == "1") return same;
    return ratio >= 1.0 ? fewDigits(ratio, "") + " times " + more : fewDigits(1.0 / ratio, "") + " times " + less;
}

/// "largest error is 8.2 nm"
std::string errorText(const PrecisionTask& task, double error)
{
    return uncapitalized(std::string(title(task.measure))) + " is " +
           fewDigits(error, unitOf(task, task.measure).displayed);
}

std::string costOf(const PrecisionTask& task, const PrecisionPoint& point)
{
    const std::optional<double> error = errorOf(task, point);
    std::string text = nameOf(task, point) + ", takes " + fewDigitsOfTime(point.fastest());
    if (point.kind == PointKind::Failed)
        text += " and has no valid end";
    else if (error)
        text += "; its " + errorText(task, *error);
    if (point.kind == PointKind::WrongState) text += ", and ends in another state than the reference";
    return text + ".";
}

/// The case's own setting beside the paper's method, and among all.
void tellChosen(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    const PrecisionPoint* chosen = findPoint(task, runs, [](const MethodSetting& setting) { return setting.chosen; });
    if (chosen == nullptr) return;
    const PrecisionPoint* paper =
        task.start.model != ModelKind::Springs ? nullptr : findPoint(task, runs, [](const MethodSetting& setting) {
            return setting.c.run.integrator == IntegratorKind::Rk4 && std::abs(setting.c.run.step - 10e-9) < 1e-15;
        });
    const double uncertainty = uncertaintyOf(task, runs);
    const std::optional<double> error = errorOf(task, *chosen);
    std::string text = "The case's own setting, " + costOf(task, *chosen);
    if (paper != nullptr && paper != chosen) {
        text += " The paper's method, " + costOf(task, *paper);
        if (const auto its = errorOf(task, *paper); its && error && *error > 0.0 && *its > 0.0)
            text += " So the case's own setting is " +
                    timesAs(paper->fastest() / chosen->fastest(), "faster", "slower", "as fast") + " and " +
                    timesAs(std::max(*its, uncertainty) / std::max(*error, uncertainty), "more accurate",
                            "less accurate", "as accurate") +
                    ".";
    }
    report.findings.push_back(text);
}

/// A few of a front of many, its ends among them.
void tellFront(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    std::vector<const PrecisionPoint*> front = paretoFront(task, runs, &PrecisionPoint::fastest);
    if (front.empty()) return;
    std::ranges::reverse(front); // from the fastest on
    const std::size_t all = front.size(), told = std::min(all, mostTold);
    std::string text;
    for (std::size_t i = 0; i < told; ++i) {
        const PrecisionPoint* point = front[told == 1 ? 0 : i * (all - 1) / (told - 1)];
        text += (i == 0 ? "" : "; ") + nameOf(task, *point) + ", " +
                fewDigits(*worthOf(task, runs, *point), unitOf(task, task.measure).displayed) + " in " +
                fewDigitsOfTime(point->fastest());
    }
    const bool own = std::ranges::any_of(front, [&](const PrecisionPoint* point) {
        return task.methods[point->method].settings[point->setting].chosen;
    });
    report.findings.push_back(
        "No setting is both faster and more accurate than " +
        (all == 1      ? std::string("this")
         : all == told ? std::string("these")
                       : "these " + std::to_string(all) + ", of which " + std::to_string(told) + " are listed") +
        ": " + text + ". The case's own setting is " + (own ? "" : "not ") + "among them.");
}

void tellReference(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    const ProvenReference& reference = runs.reference;
    const std::string distance = fewDigits(reference.apart, task.quantity.displayUnit);
    std::string text = "Errors are distances from a reference, " + reference.label + ", which " + reference.other +
                       " confirms to " + distance + "; smaller errors are not resolved.";
    if (reference.horizon) {
        text = "The trajectory is not determined: " + reference.label + " and " + reference.other +
               " differ by more than " + fewDigits(task.agreement, task.quantity.displayUnit) + " at " +
               fewDigitsOfTime(*reference.horizon, 3) + " and by up to " + distance +
               " later. Errors are those before that time. ";
        if (reference.endKnown)
            text += "The end is determined: it " + outcomeText(reference.run) + ", with both.";
        else
            text +=
                "The end is not determined either: " +
                std::string(sameOutcome(reference.run, reference.check) ? "starts that hardly differ end differently"
                                                                        : "the two end differently") +
                "; only the shares of an ensemble of starts are meaningful.";
    }
    if (!reference.horizon && !reference.endKnown)
        text += " The end is not determined: starts that hardly differ end differently; only the shares of an ensemble "
                "of starts are meaningful.";
    report.findings.push_back(text);
    if (!reference.run.valid())
        report.findings.push_back("The case itself has no valid end: " + reference.run.summary.message +
                                  ". Runs that fail in the same way agree with the reference.");
    if (reference.horizon && task.measure >= ErrorMeasure::Mean)
        report.warnings.push_back("Without a determined trajectory no run has an error of the kind \"" +
                                  std::string(name(task.measure)) +
                                  "\", which needs the whole trajectory: take error = \"worst\".");
    if (runs.referencesLate)
        report.warnings.push_back("Some reference runs were stopped: they took more than "
                                  "their share of the budget of " +
                                  fewDigitsOfTime(task.budget) + ".");
}

/// "rk4 (2 us, 1 us); newmark (2 us)", a few of many.
std::string listOf(const PrecisionTask& task, const std::vector<const PrecisionPoint*>& points)
{
    std::string list;
    std::size_t methods = 0, settings = 0, left = 0, last = task.methods.size();
    for (const PrecisionPoint* point : points) {
        const SweptMethod& method = task.methods[point->method];
        const std::string& label = method.settings[point->setting].label;
        const bool another = point->method != last;
        if (another) ++methods, settings = 0;
        last = point->method;
        if (methods > mostTold || ++settings > mostTold) {
            ++left;
            continue;
        }
        if (another)
            list += (list.empty() ? "" : "; ") + nameOf(method.name, label);
        else
            list.insert(list.size() - 1, ", " + label);
    }
    return left > 0 ? list + "; and " + std::to_string(left) + " more" : list;
}

void tellOthers(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    std::vector<const PrecisionPoint*> wrong, failed, missing;
    for (const PrecisionPoint& point : runs.points) {
        if (!point.ran)
            missing.push_back(&point);
        else if (point.kind == PointKind::WrongState)
            wrong.push_back(&point);
        else if (point.kind == PointKind::Failed)
            failed.push_back(&point);
    }
    if (!wrong.empty())
        report.findings.push_back("These end in another state than the reference: " + listOf(task, wrong) + ".");
    if (!failed.empty()) report.findings.push_back("These have no valid end: " + listOf(task, failed) + ".");
    if (!missing.empty() && runs.late)
        report.warnings.push_back("The budget of " + fewDigitsOfTime(task.budget) +
                                  " was spent before these were run: " + listOf(task, missing) + ".");
}

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
    return {std::string(title(task.measure)) +
                (task.measure >= ErrorMeasure::PeakFrequency ? "" : ", " + uncapitalized(task.quantity.longName)),
            unit.si, unit.displayed, true};
}

ChartAxis workAxis(const PrecisionTask& task)
{
    if (!task.inTime) return {"Linear solves", "", "", true};
    return {task.start.model == ModelKind::Film ? "Attitudes at which the film is solved" : "Right-hand sides", "", "",
            true};
}

ChartPanel panelOf(const PrecisionTask& task, const PrecisionRuns& runs, const ErrorScale& scale, ChartAxis y,
                   const std::function<double(const PrecisionPoint&)>& height)
{
    ChartPanel panel{errorAxis(task), std::move(y)};
    for (const SweptMethod& method : task.methods) panel.series.push_back({method.name});
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
        &PrecisionPoint::fastest));
    chart.panels.push_back(panelOf(task, runs, scale, workAxis(task), &PrecisionPoint::work));
    return chart;
}

StudyReport precisionReport(const PrecisionTask& task, const PrecisionRuns& runs)
{
    StudyReport report;
    report.charts = {precisionChart(task, runs)};
    report.tables = {runsTable(task, runs), frontTable(task, runs)};
    // That errors mean little comes before them.
    if (runs.reference.horizon) tellReference(task, runs, report);
    tellChosen(task, runs, report);
    tellFront(task, runs, report);
    if (!runs.reference.horizon) tellReference(task, runs, report);
    tellOthers(task, runs, report);
    return report;
}

} // namespace touchdown
