// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_report.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/precision/precision_runs.h"
#include "core/studies/precision/precision_task.h"

namespace touchdown {

namespace {

constexpr std::size_t mostTold = 5; // in a sentence

double timeOf(const PrecisionPoint& point) { return point.fastest(); }

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

constexpr std::array measures{ErrorMeasure::Final,        ErrorMeasure::L2,        ErrorMeasure::Worst,
                              ErrorMeasure::Mean,         ErrorMeasure::Deviation, ErrorMeasure::PeakFrequency,
                              ErrorMeasure::PeakAmplitude};

StudyTable runsTable(const PrecisionTask& task, const PrecisionRuns& runs)
{
    StudyTable table{"runs", {{.name = "method", .longName = "Method"}, {.name = "setting", .longName = "Setting"}}};
    const std::size_t shown = task.inTime ? measures.size() : 1;
    for (std::size_t i = 0; i < shown; ++i) {
        const ErrorUnit unit = unitOf(task, measures[i]);
        StudyColumn column{"error_" + std::string(name(measures[i])), unit.si, unit.displayed,
                           std::string(title(measures[i]))};
        std::ranges::replace(column.name, '-', '_');
        column.secondary = task.inTime && measures[i] != task.measure;
        table.columns.push_back(std::move(column));
    }
    for (const Quantity& also : task.also)
        table.columns.push_back(
            {"error_" + also.name, also.unit, also.displayUnit, "Largest error: " + also.longName, true});
    for (const StudyColumn& column : std::vector<StudyColumn>{
             {.name = "time", .unit = "s", .displayUnit = "ms", .longName = "Shortest time of the solver"},
             {.name = "time_median",
             .unit = "s",
             .displayUnit = "ms",
             .longName = "Median time of the solver",
             .secondary = true},
             {.name = "timed", .longName = "Timed runs", .secondary = true},
             {.name = "work", .longName = task.start.model == ModelKind::Springs ? "Right-hand sides" : "Film solves"},
             {.name = "steps",
             .longName = task.inTime ? "Accepted steps" : "Iterations on the finest grid",
             .secondary = true},
             {.name = "verdict", .longName = "Against the reference"},
             {.name = "end", .longName = "End"},
             {.name = "end_spacing", .unit = "m", .displayUnit = "nm", .longName = "Mean spacing over the last tenth"},
             {.name = "chosen", .longName = "The case's own", .secondary = true},
             {.name = "message", .longName = "Reason of the end"}})
        table.columns.push_back(column);
    for (const PrecisionPoint& point : runs.points) {
        const MethodSetting& setting = task.methods[point.method].settings[point.setting];
        std::vector<StudyValue> row{task.methods[point.method].name, setting.label};
        for (std::size_t i = 0; i < shown; ++i) row.push_back(valueOf(point.errors, 0, measures[i]));
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
    for (const PrecisionPoint* point : paretoFront(task, runs, timeOf)) {
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
    std::vector<const PrecisionPoint*> front = paretoFront(task, runs, timeOf);
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

} // namespace

ErrorUnit unitOf(const PrecisionTask& task, ErrorMeasure measure)
{
    if (measure == ErrorMeasure::PeakFrequency) return {"Hz", "kHz"};
    if (measure == ErrorMeasure::PeakAmplitude) return {"m", "nm"};
    return {task.quantity.unit, task.quantity.displayUnit};
}

std::optional<double> errorOf(const PrecisionTask& task, const PrecisionPoint& point)
{
    if (!point.ran || point.kind == PointKind::Failed || point.errors.empty()) return {};
    return point.errors[0].at(task.measure);
}

double uncertaintyOf(const PrecisionTask& task, const PrecisionRuns& runs)
{
    return runs.uncertainty.empty() ? 0.0 : runs.uncertainty[0].at(task.measure).value_or(0.0);
}

std::optional<double> worthOf(const PrecisionTask& task, const PrecisionRuns& runs, const PrecisionPoint& point)
{
    std::optional<double> worth = errorOf(task, point);
    if (!worth) return worth;
    *worth = std::max(*worth, uncertaintyOf(task, runs));
    if (!task.methods[point.method].ordered) return worth;
    for (const PrecisionPoint& finer : runs.points)
        if (finer.method == point.method && finer.setting > point.setting)
            *worth = std::max(*worth, errorOf(task, finer).value_or(0.0));
    return worth;
}

std::vector<const PrecisionPoint*> paretoFront(const PrecisionTask& task, const PrecisionRuns& runs,
                                               const std::function<double(const PrecisionPoint&)>& cost)
{
    std::vector<const PrecisionPoint*> order, front;
    const auto error = [&](const PrecisionPoint* point) { return *worthOf(task, runs, *point); };
    for (const PrecisionPoint& point : runs.points)
        if (point.kind == PointKind::Good && errorOf(task, point) && cost(point) > 0.0) order.push_back(&point);
    std::ranges::stable_sort(order, {},
                             [&](const PrecisionPoint* point) { return std::tuple(cost(*point), error(point)); });
    for (const PrecisionPoint* point : order)
        if (front.empty() || error(point) < error(front.back())) front.push_back(point);
    std::ranges::reverse(front);
    return front;
}

std::vector<StudyTable> precisionTables(const PrecisionTask& task, const PrecisionRuns& runs)
{
    return {runsTable(task, runs), frontTable(task, runs)};
}

void tellPrecision(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    // That errors mean little comes before them.
    if (runs.reference.horizon) tellReference(task, runs, report);
    tellChosen(task, runs, report);
    tellFront(task, runs, report);
    if (!runs.reference.horizon) tellReference(task, runs, report);
    tellOthers(task, runs, report);
}

} // namespace touchdown
