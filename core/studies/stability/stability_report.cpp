// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/stability/stability_map.h"

namespace touchdown {

namespace {

constexpr double paperStep = 1e-8;      // the coarser one [s]
constexpr double logarithmicFrom = 9.0; // largest of an axis against its smallest

/// An axis of a key's numbers.
ChartAxis axisOf(const Parameter& parameter, const std::vector<double>& values)
{
    ChartAxis axis{.label = capitalized(parameter.label.empty() ? parameter.key : parameter.label),
                   .unit = parameter.unit,
                   .displayUnit = parameter.displayUnit};
    if (axis.unit.empty() || axis.unit == "1") axis.unit = axis.displayUnit = "";
    const auto [least, most] = std::ranges::minmax(values);
    axis.logarithmic = least > 0.0 && most >= logarithmicFrom * least;
    return axis;
}

/// By rising value.
std::vector<std::size_t> orderOf(const std::vector<double>& values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
    return order;
}

std::string placeOf(const StabilityTask& task, const StabilityCell& cell)
{
    const StabilityRow& row = task.rows[cell.row];
    const SweptMethod& method = row.methods[cell.method];
    return nameOf(method.name, method.settings[cell.setting].label) + (row.label.empty() ? "" : " at " + row.label);
}

/// The cells stand row by row, method by method; all rows have the same settings.
const StabilityCell& cellAt(const StabilityTask& task, const StabilityMap& map, std::size_t row, std::size_t method,
                            std::size_t setting)
{
    std::size_t before = 0, all = 0;
    for (std::size_t k = 0; k < task.methods.size(); ++k) {
        const std::size_t settings = task.rows.front().methods[k].settings.size();
        if (k < method) before += settings;
        all += settings;
    }
    return map.cells[row * all + before + setting];
}

ChartPanel panelOf(const StabilityTask& task, const StabilityMap& map, std::size_t method)
{
    std::vector<double> xs, ys;
    const SweptMethod& first = task.rows.front().methods[method];
    const bool numbered =
        std::ranges::any_of(first.settings, [](const MethodSetting& each) { return !std::isfinite(each.value); });
    for (std::size_t k = 0; k < first.settings.size(); ++k)
        xs.push_back(numbered ? double(k + 1) : first.settings[k].value);
    for (const StabilityRow& row : task.rows) ys.push_back(row.value);

    ChartPanel panel;
    panel.x =
        numbered ? ChartAxis{.label = first.key.empty() ? "run" : first.key} : axisOf(*findParameter(first.key), xs);
    panel.x.label = first.name + ": " + panel.x.label;
    panel.y = task.parameter != nullptr && task.parameterIsNumber
                  ? axisOf(*task.parameter, ys)
                  : ChartAxis{.label = task.parameter ? task.parameter->key : ""};
    ChartMap& chart = panel.map.emplace();
    chart.x = xs;
    chart.y = ys;
    std::ranges::sort(chart.x);
    std::ranges::sort(chart.y);
    // All classes, so that each keeps its pattern and letter while the map grows.
    for (int k = 0; k < runClasses; ++k) {
        const auto kind = static_cast<RunClass>(k);
        chart.classes.push_back({std::string(name(kind)), severity(kind)});
    }
    for (const std::size_t row : orderOf(ys))
        for (const std::size_t setting : orderOf(xs)) {
            const StabilityCell& cell = cellAt(task, map, row, method, setting);
            if (!cell.done) {
                chart.cells.push_back(-1);
                chart.details.emplace_back();
                continue;
            }
            chart.cells.push_back(static_cast<int>(cell.verdict.kind));
            chart.details.push_back(placeOf(task, cell) + ": " + cell.verdict.sentence);
        }
    return panel;
}

StudyTable runsTable(const StabilityTask& task, const StabilityMap& map)
{
    const std::string unit = task.parameter && task.parameterIsNumber ? task.parameter->unit : "";
    const std::string display = task.parameter && task.parameterIsNumber ? task.parameter->displayUnit : "";
    StudyTable table{"runs",
                     {{"method"},
                      {"setting"},
                      {"parameter", unit, display, task.parameter ? task.parameter->key : "Parameter"},
                      {"class"},
                      {.name = "end", .secondary = true},
                      {"largest_error", "m", "nm", "Largest distance of the spacing from the reference"},
                      {"energy_balance", "", "", "Energy imbalance relative to the largest change of a part"},
                      {.name = "steps", .secondary = true},
                      {.name = "evaluations", .secondary = true},
                      {.name = "switches", .secondary = true},
                      {"finer_setting", "", "", "Paper's criterion: compared with", true},
                      {"end_changes", "", "", "Paper's criterion: the end changes", true},
                      {"trajectory_change", "m", "nm", "Paper's criterion: largest change of the spacing", true},
                      {"criterion", "", "", "Paper's criterion is"},
                      {.name = "detail", .secondary = true}}};
    for (const StabilityCell& cell : map.cells) {
        if (!cell.done) continue;
        const StabilityRow& row = task.rows[cell.row];
        const SweptMethod& method = row.methods[cell.method];
        const StudyValue parameter = task.parameterIsNumber ? StudyValue(row.value) : StudyValue(row.label);
        std::vector<StudyValue> values{method.name,
                                       method.settings[cell.setting].label,
                                       parameter,
                                       std::string(name(cell.verdict.kind)),
                                       cell.end,
                                       cell.verdict.apart,
                                       cell.verdict.imbalance,
                                       cell.steps,
                                       cell.evaluations,
                                       cell.switches};
        if (cell.criterion) {
            values.insert(values.end(), {cell.criterion->finer, std::string(cell.criterion->endChanges ? "yes" : "no"),
                                         cell.criterion->trajectoryChange, std::string(name(cell.criterion->verdict))});
        } else {
            values.resize(values.size() + 4);
        }
        values.emplace_back(cell.verdict.sentence);
        for (StudyValue& value : values)
            if (const auto* number = std::get_if<double>(&value); number != nullptr && !std::isfinite(*number))
                value = {};
        table.rows.push_back(std::move(values));
    }
    return table;
}

StudyTable referenceTable(const StabilityTask& task, const StabilityMap& map)
{
    StudyTable table{"references",
                     {{"parameter", "", "", task.parameter ? task.parameter->key : "Parameter"},
                      {"reference"},
                      {"checked_by"},
                      {"apart", "m", "nm", "Largest distance of the two"},
                      {"horizon", "s", "us", "Time from which on the trajectory is not determined"},
                      {"end_is_known"},
                      {"detail"}}};
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        const StabilityReference& reference = map.references[row];
        if (!reference.done) continue;
        table.rows.push_back({task.rows[row].label, reference.label, reference.other, ifFinite(reference.apart),
                              known(reference.horizon), std::string(reference.endKnown ? "yes" : "no"),
                              reference.knowledge});
    }
    return table;
}

bool isRight(const StabilityCell& cell)
{
    return cell.verdict.kind == RunClass::Agrees || cell.verdict.kind == RunClass::AsReference;
}

/// "rk4, 54 runs: 31 agree with the reference; 5 ...".
std::string countsOf(const StabilityTask& task, const StabilityMap& map, std::size_t method)
{
    std::array<std::size_t, runClasses> count{};
    std::size_t all = 0, right = 0, from = 0; // the first setting from which on all are right
    for (const StabilityCell& cell : map.cells)
        if (cell.method == method) {
            ++count[static_cast<std::size_t>(cell.verdict.kind)];
            ++all;
            right += isRight(cell) ? 1 : 0;
            if (!isRight(cell) && cell.verdict.kind != RunClass::NotDetermined) from = std::max(from, cell.setting + 1);
        }
    std::string text = task.methods[method].name + ", " + counted(all, "run") + ": ";
    for (std::size_t k = 0; k < count.size(); ++k)
        if (count[k] > 0)
            text += (text.ends_with(": ") ? "" : "; ") + std::to_string(count[k]) + ' ' +
                    std::string(k == 0 && count[k] > 1 ? "agree with the reference" : name(static_cast<RunClass>(k)));
    const SweptMethod& first = task.rows.front().methods[method];
    if (!first.ordered || right == 0) return text + ".";
    const bool some = count[static_cast<std::size_t>(RunClass::NotDetermined)] > 0;
    if (from == first.settings.size())
        return text +
               (some ? ". At no setting do all that are determined agree." : ". At no setting do all of them agree.");
    return text + (some ? ". Those that are determined all agree from " : ". They all agree from ") +
           first.settings[from].label + " on.";
}

/// How the criterion fared with some of the pairs.
struct CriterionCount {
    std::size_t pairs = 0, fooled = 0, alarms = 0;
    const StabilityCell *firstFooled = nullptr, *firstAlarm = nullptr;

    void add(const StabilityCell& cell)
    {
        ++pairs;
        if (cell.criterion->verdict == CriterionVerdict::Fooled && fooled++ == 0) firstFooled = &cell;
        if (cell.criterion->verdict == CriterionVerdict::FalseAlarm && alarms++ == 0) firstAlarm = &cell;
    }
};

void tellCriterion(const StabilityTask& task, const StabilityMap& map, StudyReport& report)
{
    CriterionCount all, own;
    std::size_t moved = 0, unknown = 0;
    for (const StabilityCell& cell : map.cells) {
        if (!cell.criterion) continue;
        all.add(cell);
        if (std::abs(task.rows[cell.row].methods[cell.method].settings[cell.setting].value - paperStep) <
            1e-6 * paperStep)
            own.add(cell);
        moved += !cell.criterion->endChanges && cell.criterion->trajectoryChange > task.rule.agreement;
        unknown += cell.criterion->verdict == CriterionVerdict::NotDetermined;
    }
    if (all.pairs == 0) {
        report.warnings.push_back("The paper's criterion, the same with a tenth of the step, was not applied: no "
                                  "setting has its tenth among the others.");
        return;
    }
    const auto first = [&](const StabilityCell* cell) {
        return cell == nullptr ? std::string()
                               : ", as with " + placeOf(task, *cell) + " against " + cell->criterion->finer;
    };
    std::string text = "The paper's criterion asks whether the end of a run changes with a tenth of the step. Of " +
                       counted(all.pairs, "pair") + " of runs it was fooled by " + std::to_string(all.fooled) +
                       " (the end stays, and is not the reference's" + first(all.firstFooled) +
                       ") and raised a false alarm at " + std::to_string(all.alarms) +
                       " (the end changes, though at the longer step it was the reference's" + first(all.firstAlarm) +
                       ").";
    if (own.pairs > 0)
        text += " With the paper's own steps, 10 ns and 1 ns: " + counted(own.pairs, "pair") + ", fooled by " +
                std::to_string(own.fooled) + ", false alarm at " + std::to_string(own.alarms) + ".";
    if (unknown > 0) text += " The true end of " + counted(unknown, "pair") + " is not determined.";
    report.findings.push_back(text);
    if (moved > 0)
        report.findings.push_back("In " + counted(moved, "pair") +
                                  " the end does not change while the trajectory changes by more than " +
                                  fewDigits(task.rule.agreement, "nm") + ", which the criterion does not detect.");
}

} // namespace

StudyChart mapChart(const StabilityTask& task, const StabilityMap& map)
{
    StudyChart chart;
    chart.title = task.parameter ? "How the runs end, over " + task.parameter->label : "How the runs end";
    chart.caption =
        "Each cell is a run, compared with a reference that two methods prove. By another way: the trajectory "
        "is at some time more than " +
        fewDigits(task.rule.agreement, "nm") + " from the reference's. Drifting energy: an energy imbalance above " +
        percent(task.rule.energyDrift) +
        " of the largest change of a part. Not determined: starts that hardly differ end differently.";
    if (task.parameter != nullptr && !task.parameterIsNumber)
        for (const StabilityRow& row : task.rows)
            chart.caption += " " + fewDigits(row.value, "") + ": " + row.label + ".";
    for (std::size_t method = 0; method < task.methods.size(); ++method)
        chart.panels.push_back(panelOf(task, map, method));
    return chart;
}

std::vector<StudyTable> mapTables(const StabilityTask& task, const StabilityMap& map)
{
    return {runsTable(task, map), referenceTable(task, map)};
}

void tellMap(const StabilityTask& task, const StabilityMap& map, StudyReport& report)
{
    for (std::size_t method = 0; method < task.methods.size(); ++method)
        report.findings.push_back(countsOf(task, map, method));
    tellCriterion(task, map, report);
    for (std::size_t row = 0; row < task.rows.size(); ++row)
        if (const StabilityReference& reference = map.references[row]; reference.horizon || !reference.endKnown)
            report.warnings.push_back((task.rows[row].label.empty() ? "" : "At " + task.rows[row].label + ": ") +
                                      reference.knowledge + ".");
}

} // namespace touchdown
