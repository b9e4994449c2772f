// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

using Ordinate = std::function<std::optional<double>(const StudiedEquilibrium&)>; // none: not known
using StepOrdinate = std::function<ChartPoint(const HeldStep&)>;

double frequency(std::complex<double> eigenvalue) { return std::abs(eigenvalue.imag()) / (2.0 * std::numbers::pi); }

/// Equilibria that a chart draws alike.
struct Group {
    std::string name{};
    bool unstable = false;
    bool operator==(const Group&) const = default;
};

Group groupOf(const HysteresisResult& result, const StudiedEquilibrium& at, bool outside)
{
    Group group{.unstable = at.stability == Stability::Flutter || at.stability == Stability::Divergence};
    if (group.unstable)
        group.name = result.doubtful(at) ? "unstable equilibria, on this grid" : "unstable equilibria";
    else if (at.incomplete())
        group.name = "equilibria of unknown stability";
    else
        group.name = at.stability == Stability::Stable ? "stable equilibria" : "neutral equilibria";
    if (outside) group.name += ", outside the model";
    return group;
}

/// Lines cut where their stability changes; each part reaches to the first point of the next.
void addEquilibria(ChartPanel& panel, const HysteresisResult& result, const Ordinate& ordinate)
{
    const auto add = [&](ChartSeries& series, const StudiedEquilibrium& at, const std::string& label) {
        if (const std::optional<double> y = ordinate(at))
            series.points.push_back({.x = at.value, .y = *y, .label = label});
    };
    for (const EquilibriumLine& line : result.lines) {
        for (std::size_t begin = 0; begin < line.points.size();) {
            ChartSeries series;
            const Group group = groupOf(result, line.points[begin], line.outside);
            series.name = group.name;
            series.line = group.unstable ? ChartLine::Dashed : ChartLine::Solid;
            series.markers = false;
            series.quiet = line.outside;
            std::size_t i = begin;
            for (; i < line.points.size() && groupOf(result, line.points[i], line.outside) == group; ++i)
                add(series, line.points[i], {});
            if (i < line.points.size()) add(series, line.points[i], {});
            begin = i;
            if (!series.points.empty()) panel.series.push_back(std::move(series));
        }
    }
    const auto addMarks = [&](const char* name, EquilibriumMark kind) {
        ChartSeries series{.name = name, .line = ChartLine::None};
        for (const StudiedMark& mark : result.marks)
            if (mark.kind == kind) add(series, mark.at, mark.name);
        if (!series.points.empty()) panel.series.push_back(std::move(series));
    };
    addMarks("folds", EquilibriumMark::Fold);
    addMarks("Hopf points", EquilibriumMark::Hopf);
    addMarks("ends at a switch of the law", EquilibriumMark::Switch);
    addMarks("kinks at a switch of the law", EquilibriumMark::Kink);
}

void addSteps(ChartPanel& panel, const HeldSteps& task, const HysteresisResult& result, const StepOrdinate& point)
{
    const bool rising = task.values.back() > task.values.front();
    for (const bool back : {false, true}) {
        ChartSeries series;
        series.name = task.fresh ? "end states" : rising != back ? "held, rising" : "held, falling";
        for (const HeldStep& step : result.steps) {
            if (!step.done || step.back != back || step.end.kind == EndKind::Failed) continue;
            ChartPoint& at = series.points.emplace_back(point(step));
            if (step.end.kind == EndKind::Intermittent) at.label = "in and out of contact";
        }
        if (task.fresh) series.line = ChartLine::None; // none follows from its neighbour
        if (!series.points.empty()) panel.series.push_back(std::move(series));
    }
}

ChartPanel pitchPanel(const HeldSteps& task, const HysteresisResult& result, const ParameterText& text)
{
    ChartPanel panel{{text.label, text.unit, text.displayUnit}, {"Pitch", "rad", "urad"}};
    addEquilibria(panel, result, [](const StudiedEquilibrium& at) { return at.pitch; });
    addSteps(panel, task, result, [](const HeldStep& step) { return ChartPoint{.x = step.value, .y = step.pitch}; });
    return panel;
}

/// Of equilibria: above zero a motion grows.
ChartPanel growthPanel(const HysteresisResult& result, const ParameterText& text)
{
    ChartPanel panel{{text.label, text.unit, text.displayUnit}, {"Largest real part of an eigenvalue", "1/s", "1/s"}};
    addEquilibria(panel, result, [](const StudiedEquilibrium& at) { return at.growth(); });
    panel.bands.push_back({.alongX = false, .lower = 0.0, .upper = 0.0, .label = "above: unstable"});
    return panel;
}

StudyChart spacingChart(const HeldSteps& task, const HysteresisResult& result, const ParameterText& text)
{
    const std::string name = task.start.model == ModelKind::Springs ? "Flying height" : "Minimum spacing";
    ChartPanel spacing{{text.label, text.unit, text.displayUnit}, {name, "m", "nm"}};
    addEquilibria(spacing, result, [](const StudiedEquilibrium& at) { return at.spacing; });
    addSteps(spacing, task, result, [](const HeldStep& step) {
        return ChartPoint{
            .x = step.value, .y = step.end.spacing, .yError = 0.5 * (step.spacing.max - step.spacing.min)};
    });
    std::string caption = "Points: mean over the last tenth of the hold of " + fewDigitsOfTime(task.hold, 3) +
                          " at each value; bars: the range there.";
    if (!result.lines.empty())
        caption += std::string(" Lines: equilibria") +
                   (task.start.model == ModelKind::Film ? ", all on one grid" : "") +
                   ". An equilibrium ends where the contact law or a spring switches with a jump of its force.";
    return {"Spacing over " + uncapitalized(text.label),
            caption,
            {spacing, result.lines.empty() ? pitchPanel(task, result, text) : growthPanel(result, text)}};
}

StudyTable stepTable(const HeldSteps& task, const HysteresisResult& result, const ParameterText& text)
{
    StudyTable table{.name = "steps"};
    table.columns = {{"way", "", "", "Way"},
                     {"value", text.unit, text.displayUnit, text.label},
                     {"end", "", "", "End"},
                     {"spacing", "m", "nm", "Mean spacing over the last tenth"},
                     {"spacing_min", "m", "nm", "Least spacing there"},
                     {"spacing_max", "m", "nm", "Largest spacing there"},
                     {"pitch", "rad", "urad", "Mean pitch there"},
                     {"remark", "", "", "Remark"}};
    const bool rising = task.values.back() > task.values.front();
    for (const HeldStep& step : result.steps) {
        if (!step.done) continue;
        std::string remark = step.problem;
        if (step.anew && step.back) remark = "started anew" + (remark.empty() ? "" : "; " + remark);
        std::vector<StudyValue> row{std::string(task.fresh            ? "anew"
                                                : rising != step.back ? "rising"
                                                                      : "falling"),
                                    step.value, std::string(name(step.end.kind))};
        if (step.end.kind == EndKind::Failed)
            row.insert(row.end(), 4, StudyValue{});
        else
            row.insert(row.end(), {step.end.spacing, step.spacing.min, step.spacing.max, step.pitch});
        row.emplace_back(std::move(remark));
        table.rows.push_back(std::move(row));
    }
    return table;
}

StudyTable equilibriumTable(const HysteresisResult& result, const ParameterText& text)
{
    StudyTable table{.name = "equilibria"};
    table.columns = {{"branch", "", "", "Branch"},
                     {"state", "", "", "State"},
                     {"value", text.unit, text.displayUnit, text.label},
                     {"spacing", "m", "nm", "Spacing"},
                     {"pitch", "rad", "urad", "Pitch"},
                     {"stability", "", "", "Stability"}};
    std::size_t most = 0;
    for (const EquilibriumLine& line : result.lines)
        for (const StudiedEquilibrium& at : line.points) most = std::max(most, at.eigenvalues.size());
    for (std::size_t k = 1; k <= most; ++k) {
        const std::string number = std::to_string(k);
        table.columns.push_back({"real_" + number, "1/s", "1/s", "Real part of eigenvalue " + number});
        table.columns.push_back({"frequency_" + number, "Hz", "kHz", "Frequency of eigenvalue " + number});
    }
    double branch = 0.0;
    for (const EquilibriumLine& line : result.lines) {
        ++branch;
        for (const StudiedEquilibrium& at : line.points) {
            const bool known = !at.incomplete() || at.stability == Stability::Divergence;
            std::vector<StudyValue> row{branch,   line.state(),
                                        at.value, at.spacing,
                                        at.pitch, std::string(known ? name(at.stability) : "not known")};
            for (const std::complex<double>& value : at.eigenvalues)
                row.insert(row.end(), {value.real(), frequency(value)});
            row.resize(table.columns.size());
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

StudyTable markTable(const HysteresisResult& result, const ParameterText& text)
{
    StudyTable table{.name = "special_points"};
    table.columns = {{"kind", "", "", "Kind"},
                     {"name", "", "", "Name"},
                     {"value", text.unit, text.displayUnit, text.label},
                     {"spacing", "m", "nm", "Spacing"},
                     {"pitch", "rad", "urad", "Pitch"},
                     {"frequency", "Hz", "kHz", "Frequency of the first eigenvalue"}};
    for (const StudiedMark& mark : result.marks) {
        StudyValue oscillates{};
        if (!mark.at.eigenvalues.empty() && mark.at.eigenvalues.front().imag() != 0.0)
            oscillates = frequency(mark.at.eigenvalues.front());
        table.rows.push_back(
            {std::string(name(mark.kind)), mark.name, mark.at.value, mark.at.spacing, mark.at.pitch, oscillates});
    }
    return table;
}

} // namespace

StudyReport hysteresisReport(const HeldSteps& task, const HysteresisResult& result)
{
    const ParameterText text = parameterText(task.parameter);
    StudyReport report;
    report.findings = hysteresisFindings(task, result);
    report.warnings = result.warnings;
    if (allFailed(result.steps)) {
        report.status = StudyStatus::Failed;
        report.message =
            result.steps.empty() ? "no value was held" : "no value has a valid end: " + result.steps.front().problem;
    }
    report.charts.push_back(spacingChart(task, result, text));
    if (!result.lines.empty())
        report.charts.push_back({"Pitch over " + uncapitalized(text.label), "", {pitchPanel(task, result, text)}});
    report.tables.push_back(stepTable(task, result, text));
    if (result.traced) {
        report.tables.push_back(equilibriumTable(result, text));
        report.tables.push_back(markTable(result, text));
    }
    return report;
}

} // namespace touchdown
