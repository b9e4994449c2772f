// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision_report.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/simulation/units.h"
#include "core/studies/few_digits.h"

namespace touchdown {

namespace {

std::string unitOf(const PrecisionTask& task)
{
    if (task.measure == ErrorMeasure::PeakFrequency) return "kHz";
    return task.measure == ErrorMeasure::PeakAmplitude ? "nm" : task.quantity.displayUnit;
}

/// The fastest run that reached the reference's end with an error of no more than `error`; null: none did.
const PrecisionPoint* fastestWithin(const PrecisionTask& task, const PrecisionRuns& runs, double error)
{
    const PrecisionPoint* best = nullptr;
    for (const PrecisionPoint& point : runs.points) {
        const std::optional<double> its = worthOf(task, runs, point);
        if (point.kind != PointKind::Good || !its || *its > error) continue;
        if (best == nullptr || point.fastest() < best->fastest()) best = &point;
    }
    return best;
}

/// An error and the fastest run within it.
struct Within {
    double error = 0.0; // [unit]
    const PrecisionPoint* point = nullptr;
};

/// For the powers of ten, in the display unit, from the largest error of a run down to what the reference knows.
std::vector<Within> fastestRuns(const PrecisionTask& task, const PrecisionRuns& runs)
{
    double least = INFINITY, largest = 0.0;
    for (const PrecisionPoint& point : runs.points)
        if (const auto error = worthOf(task, runs, point); error && point.kind == PointKind::Good) {
            least = std::min(least, *error);
            largest = std::max(largest, *error);
        }
    std::vector<Within> all;
    if (largest == 0.0) return all;
    const double factor = unitFactor(unitOf(task));
    least = std::max(least, 1e-12 * largest);
    const int first = static_cast<int>(std::ceil(std::log10(largest / factor)));
    for (int exponent = first; factor * std::pow(10.0, exponent) >= least; --exponent) {
        const double error = factor * std::pow(10.0, exponent);
        if (const PrecisionPoint* point = fastestWithin(task, runs, error)) all.push_back({error, point});
    }
    return all;
}

std::string endText(const PrecisionPoint& point)
{
    if (!point.ran) return "not run";
    return std::string(name(point.summary.status == RunStatus::Completed ? point.end.kind : EndKind::Failed));
}

std::string verdictText(const PrecisionPoint& point)
{
    if (!point.ran) return "not run";
    if (point.kind == PointKind::Failed) return "failed";
    return point.kind == PointKind::WrongState ? "other end" : "agrees";
}

StudyValue valueOf(const std::vector<TrajectoryError>& errors, std::size_t quantity, ErrorMeasure measure)
{
    if (quantity >= errors.size()) return {};
    const std::optional<double> value = errors[quantity].at(measure);
    return value ? StudyValue(*value) : StudyValue();
}

constexpr std::array measures{ErrorMeasure::Final,     ErrorMeasure::L2,            ErrorMeasure::Worst,        ErrorMeasure::Mean,
                              ErrorMeasure::Deviation, ErrorMeasure::PeakFrequency, ErrorMeasure::PeakAmplitude};

StudyTable runsTable(const PrecisionTask& task, const PrecisionRuns& runs)
{
    StudyTable table{"runs", {{.name = "method", .longName = "Method"}, {.name = "setting", .longName = "Setting"}}, {}};
    const Quantity& q = task.quantity;
    const std::size_t shown = task.inTime ? measures.size() : 1;
    for (std::size_t i = 0; i < shown; ++i) {
        StudyColumn column{"error_" + std::string(name(measures[i])), q.unit, q.displayUnit, std::string(title(measures[i]))};
        std::ranges::replace(column.name, '-', '_');
        if (measures[i] == ErrorMeasure::PeakFrequency) column.unit = "Hz", column.displayUnit = "kHz";
        if (measures[i] == ErrorMeasure::PeakAmplitude) column.unit = "m", column.displayUnit = "nm";
        column.secondary = task.inTime && measures[i] != task.measure;
        table.columns.push_back(std::move(column));
    }
    for (const Quantity& also : task.also)
        table.columns.push_back({"error_" + also.name, also.unit, also.displayUnit, "Largest error: " + also.longName, true});
    for (const StudyColumn& column : std::vector<StudyColumn>{
             {.name = "time", .unit = "s", .displayUnit = "ms", .longName = "Time of the solver, the least"},
             {.name = "time_median", .unit = "s", .displayUnit = "ms", .longName = "Its median", .secondary = true},
             {.name = "timed", .longName = "Timed runs", .secondary = true},
             {.name = "work", .longName = task.start.model == ModelKind::Springs ? "Right-hand sides" : "Film solves"},
             {.name = "steps", .longName = task.inTime ? "Accepted steps" : "Iterations on the finest grid", .secondary = true},
             {.name = "verdict", .longName = "Against the reference"},
             {.name = "end", .longName = "End"},
             {.name = "end_spacing", .unit = "m", .displayUnit = "nm", .longName = "Mean spacing over the last tenth"},
             {.name = "chosen", .longName = "The case's own", .secondary = true},
             {.name = "message", .longName = "Why it ended so"}})
        table.columns.push_back(column);
    for (const PrecisionPoint& point : runs.points) {
        const PrecisionSetting& setting = task.methods[point.method].settings[point.setting];
        std::vector<StudyValue> row{task.methods[point.method].name, setting.label};
        for (std::size_t i = 0; i < shown; ++i) row.push_back(valueOf(point.errors, 0, measures[i]));
        for (std::size_t i = 0; i < task.also.size(); ++i) row.push_back(valueOf(point.errors, i + 1, ErrorMeasure::Worst));
        const auto number = [&](double value) { return point.ran ? StudyValue(value) : StudyValue(); };
        row.insert(row.end(), {number(point.fastest()), number(point.median()), number(static_cast<double>(point.seconds.size())),
                               number(point.work), number(static_cast<double>(point.summary.steps)), verdictText(point), endText(point),
                               point.ran && point.end.kind != EndKind::Failed ? StudyValue(point.end.spacing) : StudyValue(),
                               std::string(setting.chosen ? "yes" : ""), point.summary.message});
        table.rows.push_back(std::move(row));
    }
    return table;
}

StudyTable fastestTable(const PrecisionTask& task, const PrecisionRuns& runs)
{
    const bool frequency = task.measure == ErrorMeasure::PeakFrequency;
    StudyTable table{"fastest",
                     {{"within", frequency ? "Hz" : task.quantity.unit, unitOf(task), std::string(title(task.measure)) + " of no more than"},
                      {.name = "method", .longName = "Fastest method"},
                      {.name = "setting", .longName = "Setting"},
                      {"time", "s", "ms", "Time of the solver"}},
                     {}};
    for (const Within& within : fastestRuns(task, runs))
        table.rows.push_back({within.error, task.methods[within.point->method].name,
                              task.methods[within.point->method].settings[within.point->setting].label, within.point->fastest()});
    return table;
}

const PrecisionPoint* findPoint(const PrecisionTask& task, const PrecisionRuns& runs, const std::function<bool(const PrecisionSetting&)>& is)
{
    for (const PrecisionPoint& point : runs.points)
        if (point.ran && is(task.methods[point.method].settings[point.setting])) return &point;
    return nullptr;
}

std::string timesAs(double ratio, const std::string& more, const std::string& less)
{
    return ratio >= 1.0 ? fewDigits(ratio, "") + " times " + more : fewDigits(1.0 / ratio, "") + " times " + less;
}

std::string costOf(const PrecisionTask& task, const PrecisionPoint& point, const std::string& remark = {})
{
    const std::optional<double> error = errorOf(task, point);
    return nameOf(task, point) + remark + " takes " + fewDigitsOfTime(point.fastest()) +
           (point.kind == PointKind::Failed ? std::string(" and has no valid end")
                                            : " and errs by " + fewDigits(error.value_or(0.0), unitOf(task))) +
           (point.kind == PointKind::WrongState ? ", in another end state than the reference" : "");
}

/// The case's own setting beside the paper's method, and among all.
void tellChosen(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    const PrecisionPoint* chosen = findPoint(task, runs, [](const PrecisionSetting& setting) { return setting.chosen; });
    if (chosen == nullptr || !errorOf(task, *chosen)) return;
    const PrecisionPoint* paper = task.start.model != ModelKind::Springs ? nullptr : findPoint(task, runs, [](const PrecisionSetting& setting) {
        return setting.c.run.integrator == IntegratorKind::Rk4 && std::abs(setting.c.run.step - 10e-9) < 1e-15;
    });
    const double uncertainty = uncertaintyOf(task, runs), error = std::max(*errorOf(task, *chosen), uncertainty);
    const double worth = *worthOf(task, runs, *chosen);
    if (paper != nullptr && paper != chosen) {
        std::string text = costOf(task, *chosen) + "; " + costOf(task, *paper, ", the paper's method,");
        if (const auto its = errorOf(task, *paper); its && error > 0.0 && *its > 0.0)
            text += ": the case's own setting is " + timesAs(paper->fastest() / chosen->fastest(), "faster", "slower") + " and " +
                    timesAs(std::max(*its, uncertainty) / error, "more accurate", "less accurate");
        report.findings.push_back(text + ".");
    }
    const PrecisionPoint* best = fastestWithin(task, runs, worth);
    if (best == nullptr) return;
    const bool isBest = best == chosen || best->fastest() >= chosen->fastest();
    report.findings.push_back("Of the runs that err by no more than the case's own setting, " + nameOf(task, *chosen) +
                              (isBest ? ", it is the fastest." : ", " + nameOf(task, *best) + " is the fastest: " +
                                                                     fewDigitsOfTime(best->fastest()) + " against " + fewDigitsOfTime(chosen->fastest()) + "."));
}

void tellReference(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    const ProvenReference& reference = runs.reference;
    const std::string distance = fewDigits(reference.apart, task.quantity.displayUnit);
    std::string text = "The reference is " + reference.label + "; " + reference.other + " lies within " + distance + " of it";
    if (reference.horizon)
        text = "The trajectory is not determined: " + reference.label + " and " + reference.other + " part by " +
               fewDigits(task.agreement, task.quantity.displayUnit) + " at " + fewDigitsOfTime(*reference.horizon, 3) + " and by up to " + distance +
               " later. Errors are those of the time before; " +
               (task.start.model == ModelKind::Film ? "what comes later needs finer references or, where it is chaotic, an [ensemble]"
                                                    : "after it only the shares of an ensemble have a meaning");
    report.findings.push_back(text + ".");
    if (!reference.run.valid())
        report.findings.push_back("The case itself has no valid end: " + reference.run.summary.message + ". Runs that fail alike agree with the reference.");
}

void tellFastest(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    std::string text;
    const std::vector<Within> all = fastestRuns(task, runs);
    for (std::size_t i = 0; i < all.size(); ++i) {
        // One clause for several powers of ten with the same answer: the smallest of them.
        if (i + 1 < all.size() && all[i + 1].point == all[i].point) continue;
        text += (text.empty() ? "The fastest within " : ", within ") + fewDigits(all[i].error, unitOf(task)) + ": " + nameOf(task, *all[i].point) + " (" +
                fewDigitsOfTime(all[i].point->fastest()) + ")";
    }
    if (!text.empty()) report.findings.push_back(text + ".");
}

/// All of a few, some of many.
std::string listOf(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) list += (i == 0 ? "" : "; ") + names[i];
    return names.size() > most ? list + "; and " + std::to_string(names.size() - most) + " more" : list;
}

void tellOthers(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    std::vector<std::string> wrong, failed, missing;
    for (const PrecisionPoint& point : runs.points) {
        const std::string its = nameOf(task, point);
        if (!point.ran) missing.push_back(its);
        else if (point.kind == PointKind::WrongState) wrong.push_back(its);
        else if (point.kind == PointKind::Failed) failed.push_back(its);
    }
    if (!wrong.empty()) report.findings.push_back("In another state than the reference ends " + listOf(wrong) + ".");
    if (!failed.empty()) report.findings.push_back("No valid end has " + listOf(failed) + ".");
    if (!missing.empty() && runs.late) report.warnings.push_back("The budget of " + fewDigitsOfTime(task.budget) + " was spent before these were run: " + listOf(missing) + ".");
}

} // namespace

std::string nameOf(const PrecisionTask& task, const PrecisionPoint& point)
{
    const PrecisionMethod& method = task.methods[point.method];
    const std::string& label = method.settings[point.setting].label;
    return label.empty() ? method.name : method.name + ", " + label;
}

std::optional<double> errorOf(const PrecisionTask& task, const PrecisionPoint& point)
{
    if (!point.ran || point.kind == PointKind::Failed || point.errors.empty()) return {};
    return point.errors[0].at(task.measure);
}

double uncertaintyOf(const PrecisionTask& task, const PrecisionRuns& runs)
{
    return runs.reference.uncertainty.empty() ? 0.0 : runs.reference.uncertainty[0].at(task.measure).value_or(0.0);
}

std::optional<double> worthOf(const PrecisionTask& task, const PrecisionRuns& runs, const PrecisionPoint& point)
{
    std::optional<double> worth = errorOf(task, point);
    if (!worth) return worth;
    *worth = std::max(*worth, uncertaintyOf(task, runs));
    if (!task.methods[point.method].ordered) return worth;
    for (const PrecisionPoint& finer : runs.points)
        if (finer.method == point.method && finer.setting > point.setting) *worth = std::max(*worth, errorOf(task, finer).value_or(0.0));
    return worth;
}

std::vector<const PrecisionPoint*> paretoFront(const PrecisionTask& task, const PrecisionRuns& runs,
                                               const std::function<double(const PrecisionPoint&)>& cost)
{
    std::vector<const PrecisionPoint*> order, front;
    const auto error = [&](const PrecisionPoint* point) { return *worthOf(task, runs, *point); };
    for (const PrecisionPoint& point : runs.points)
        if (point.kind == PointKind::Good && errorOf(task, point) && cost(point) > 0.0) order.push_back(&point);
    std::ranges::stable_sort(order, {}, [&](const PrecisionPoint* point) { return std::tuple(cost(*point), error(point)); });
    for (const PrecisionPoint* point : order)
        if (front.empty() || error(point) < error(front.back())) front.push_back(point);
    std::ranges::reverse(front);
    return front;
}

std::vector<StudyTable> precisionTables(const PrecisionTask& task, const PrecisionRuns& runs)
{
    return {runsTable(task, runs), fastestTable(task, runs)};
}

void tellPrecision(const PrecisionTask& task, const PrecisionRuns& runs, StudyReport& report)
{
    // That errors mean little comes before them.
    if (runs.reference.horizon) tellReference(task, runs, report);
    tellChosen(task, runs, report);
    if (!runs.reference.horizon) tellReference(task, runs, report);
    tellFastest(task, runs, report);
    tellOthers(task, runs, report);
}

} // namespace touchdown
