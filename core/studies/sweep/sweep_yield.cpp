// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_yield.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/numerics/moments.h"
#include "core/studies/sweep/sweep_points.h"
#include "core/studies/sweep/sweep_surface.h"

namespace touchdown {

namespace {

constexpr std::size_t fewestForHistogram = 20, mostBins = 60;
constexpr std::size_t mostHistograms = 6;
constexpr double standardErrors = 1.96; // of a share: 95 % of the draws of as many samples [-]
constexpr double tail = 0.05;           // below and above the quantiles that are told [-]

/// Values of the readings at each sample; NaN where there is none.
using Values = std::vector<std::vector<double>>;

bool within(const SweepTask& task, const std::vector<double>& values)
{
    for (std::size_t r = 0; r < values.size(); ++r)
        if (task.limits[r].any() && !task.limits[r].hold(values[r])) return false;
    return true;
}

bool hasLimits(const SweepTask& task) { return std::ranges::any_of(task.limits, &SweepLimits::any); }

double shareWithin(const SweepTask& task, const Values& values)
{
    return double(std::ranges::count_if(values, [&](const auto& each) { return within(task, each); })) /
           double(values.size());
}

std::string percentOf(double share) { return fewDigits(100.0 * share, "", 4) + " %"; }

/// "93.1 % +- 0.2 %": what as many other samples may give.
std::string shareText(double share, std::size_t count)
{
    const double error = standardErrors * std::sqrt(share * (1.0 - share) / double(count));
    return percentOf(share) + (error > 0.0 ? " +- " + fewDigits(100.0 * error, "", 2) + " %" : "");
}

std::string limitsText(const SweepLimits& limits, const std::string& unit)
{
    const auto shown = [&](double value) { return fewDigits(value, unit, 6); };
    if (limits.least && limits.most) return "from " + shown(*limits.least) + " to " + shown(*limits.most);
    return limits.least ? "at least " + shown(*limits.least) : "at most " + shown(*limits.most);
}

std::vector<double> columnOf(const Values& values, std::size_t r)
{
    std::vector<double> column;
    for (const std::vector<double>& each : values)
        if (std::isfinite(each[r])) column.push_back(each[r]);
    std::ranges::sort(column);
    return column;
}

double quantileOf(const std::vector<double>& sorted, double share)
{
    const double place = share * double(sorted.size() - 1);
    const auto below = std::size_t(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - double(below));
}

void addHistogram(const SweepTask& task, std::size_t r, const std::vector<double>& sorted, StudyReport& report)
{
    if (sorted.size() < fewestForHistogram || !(sorted.back() > sorted.front())) return;
    const StudyColumn column = task.readings[r].column();
    const auto bins = std::clamp(std::size_t(std::sqrt(double(sorted.size()))), std::size_t{8}, mostBins);
    const double width = (sorted.back() - sorted.front()) / double(bins);
    std::vector<std::size_t> counts(bins, 0);
    for (const double value : sorted) ++counts[std::min(std::size_t((value - sorted.front()) / width), bins - 1)];
    ChartSeries series{.name = "samples", .line = ChartLine::Steps, .markers = false};
    for (std::size_t k = 0; k < bins; ++k)
        series.points.push_back({sorted.front() + (double(k) + 0.5) * width, double(counts[k])});
    ChartPanel panel{{column.longName, column.unit, column.displayUnit}, {"Samples"}};
    panel.series.push_back(std::move(series));
    constexpr double endless = std::numeric_limits<double>::infinity();
    const SweepLimits& limits = task.limits[r];
    if (limits.any())
        panel.bands.push_back(
            {true, limits.least.value_or(-endless), limits.most.value_or(endless), "within the limits"});
    report.charts.push_back({column.longName + ": how the samples are spread",
                             "Each step is as wide as all others; its height is the number of samples in it.",
                             {panel}});
}

/// A row for each reading: mean, spread and the share within its limits.
void addSpread(const SweepTask& task, const Values& values, StudyReport& report)
{
    StudyTable table{"spread",
                     {{.name = "reading", .longName = "Reading"},
                      {.name = "unit", .longName = "Unit"},
                      {.name = "mean", .longName = "Mean"},
                      {.name = "deviation", .longName = "Standard deviation"},
                      {.name = "low", .longName = "5 % lie below"},
                      {.name = "high", .longName = "5 % lie above"},
                      {.name = "limits", .longName = "Limits"},
                      {.name = "share", .longName = "Share within them"}}};
    for (std::size_t r = 0; r < task.readings.size(); ++r) {
        if (task.readings[r].isText || task.readings[r].isError) continue;
        const std::vector<double> sorted = columnOf(values, r);
        if (sorted.empty()) continue;
        const StudyColumn column = task.readings[r].column();
        const double factor = column.displayUnit.empty() ? 1.0 : unitFactor(column.displayUnit);
        const Moments moments = momentsOf(sorted);
        const SweepLimits& limits = task.limits[r];
        const double share =
            double(std::ranges::count_if(values, [&](const auto& each) { return limits.hold(each[r]); })) /
            double(values.size());
        table.rows.push_back({column.name, column.displayUnit, moments.mean / factor, moments.deviation / factor,
                              quantileOf(sorted, tail) / factor, quantileOf(sorted, 1.0 - tail) / factor,
                              limits.any() ? StudyValue(limitsText(limits, column.displayUnit)) : StudyValue(),
                              known(limits.any(), share)});
        if (report.charts.size() < mostHistograms) addHistogram(task, r, sorted, report);
    }
    report.tables.push_back(std::move(table));
}

void addShare(const SweepTask& task, const Values& values, const std::string& what, StudyReport& report)
{
    if (!hasLimits(task) || values.empty()) return;
    const double share = shareWithin(task, values);
    report.findings.insert(report.findings.begin(),
                           (task.samples ? shareText(share, values.size()) : percentOf(share)) + " of " +
                               std::to_string(values.size()) + " " + what + " lie within all limits.");
}

/// One surface for each reading but stated errors.
class Surfaces {
public:
    Surfaces(const SweepTask& task, const ItemRows& rows) : task_(task)
    {
        for (std::size_t r = 0; r < task.readings.size(); ++r) {
            std::optional<ResponseSurface>& surface = surfaces_.emplace_back();
            if (task.readings[r].isError) continue;
            std::vector<double> values;
            for (const auto& row : rows) values.push_back(std::get<double>((*row)[r]));
            surface.emplace(task.design, values);
        }
        for (const std::vector<double>& point : task.points) {
            std::vector<double>& x = drawn_.emplace_back();
            for (std::size_t k = 0; k < point.size(); ++k) x.push_back(task.axes[k].at(point[k]).number);
        }
    }

    std::vector<double> at(std::span<const double> x) const
    {
        std::vector<double> values;
        for (const auto& surface : surfaces_)
            values.push_back(surface ? surface->at(x) : std::numeric_limits<double>::quiet_NaN());
        return values;
    }

    /// `tighter`: the axis that keeps half of its spread; none: as many as there are axes.
    Values samples(std::size_t tighter) const
    {
        Values values;
        for (std::vector<double> x : drawn_) {
            if (tighter < x.size()) x[tighter] = 0.5 * (x[tighter] + task_.design.front()[tighter]);
            values.push_back(at(x));
        }
        return values;
    }

private:
    const SweepTask& task_;
    std::vector<std::optional<ResponseSurface>> surfaces_;
    std::vector<std::vector<double>> drawn_; // the numbers of each sample, by axis [units of the axes]
};

void addTightened(const SweepTask& task, const Surfaces& surfaces, double share, StudyReport& report)
{
    if (!hasLimits(task)) return;
    StudyTable table{"tighter",
                     {{.name = "axis", .longName = "Axis that keeps half of its spread"},
                      {.name = "share", .longName = "Share within all limits"}}};
    std::pair<double, std::string> best{share, ""};
    for (std::size_t k = 0; k < task.axes.size(); ++k) {
        const double tighter = shareWithin(task, surfaces.samples(k));
        table.rows.push_back({task.axes[k].text.label, tighter});
        best = std::max(best, {tighter, uncapitalized(task.axes[k].text.label)});
    }
    std::ranges::stable_sort(table.rows, std::greater{}, [](const auto& row) { return std::get<double>(row[1]); });
    report.tables.push_back(std::move(table));
    if (!best.second.empty() && share < 1.0)
        report.findings.push_back("Half of the spread of " + best.second +
                                  " would bring most: " + percentOf(best.first) + " within all limits.");
}

/// How far the surfaces are off where items were drawn to check them.
void addChecks(const SweepTask& task, const ItemRows& rows, const Surfaces& surfaces, const Values& values,
               StudyReport& report)
{
    for (std::size_t r = 0; r < task.readings.size(); ++r) {
        if (task.readings[r].isError) continue;
        double most = 0.0;
        for (std::size_t i = surfaceItems(task.axes.size()); i < rows.size(); ++i)
            most = std::max(most, std::abs(std::get<double>((*rows[i])[r]) - surfaces.at(task.design[i])[r]));
        const StudyColumn column = task.readings[r].column();
        const double deviation = momentsOf(columnOf(values, r)).deviation;
        const std::string text = "The surface of " + uncapitalized(column.longName) + " misses " +
                                 std::to_string(surfaceChecks) + " exact items drawn to check it by at most " +
                                 fewDigits(most, column.displayUnit, 2);
        if (most > 0.1 * deviation && most > 0.0)
            report.warnings.push_back(text + ", " + percentOf(most / deviation) +
                                      " of the samples' standard deviation: smaller tolerances, or samples.by = "
                                      "\"items\", are safer.");
        else
            report.findings.push_back(text + ".");
    }
}

StudyTable itemTable(const SweepTask& task, const ItemRows& rows)
{
    StudyTable table{"sweep"};
    for (const SweepAxis& axis : task.axes)
        table.columns.push_back({axis.columnName(), axis.text.unit, axis.text.displayUnit, axis.text.label});
    for (const Reading& reading : task.readings) table.columns.push_back(reading.column());
    table.columns.push_back({.name = "role", .longName = "What the item is for"});
    table.columns.push_back({.name = "problem", .longName = "Why there is no valid end", .secondary = true});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i]) continue;
        std::vector<StudyValue> row;
        for (const double number : task.design[i]) row.emplace_back(number);
        row.insert(row.end(), rows[i]->begin(), rows[i]->end() - 1);
        const std::size_t axes = task.axes.size();
        row.emplace_back(std::string(i == 0                   ? "middle"
                                     : i < 1 + 2 * axes       ? "side"
                                     : i < surfaceItems(axes) ? "pair"
                                                              : "check"));
        row.push_back(rows[i]->back());
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace

void addYield(const SweepPoints& points, StudyReport& report)
{
    const SweepTask& task = points.task();
    Values values;
    for (const SweepPoint& point : points.points()) {
        if (point.rows.empty()) continue;
        std::vector<double>& each = values.emplace_back();
        for (std::size_t r = 0; r < points.readings(); ++r) each.push_back(points.numberOf(point, r));
    }
    if (task.samples && !values.empty()) addSpread(task, values, report);
    addShare(task, values, task.samples ? "samples" : "points", report);
}

StudyReport surfaceReport(const SweepTask& task, const ItemRows& rows)
{
    StudyReport report;
    report.tables.push_back(itemTable(task, rows));
    if (!std::ranges::all_of(rows, [](const auto& row) { return row.has_value(); })) return report;
    for (const auto& row : rows) {
        bool whole = true;
        for (std::size_t r = 0; r < task.readings.size(); ++r)
            whole = whole && (task.readings[r].isError || std::holds_alternative<double>((*row)[r]));
        const auto* problem = std::get_if<std::string>(&row->back());
        if (whole && (problem == nullptr || problem->empty())) continue;
        report.status = StudyStatus::Failed;
        report.message = "the surface needs all of its items, and one has no valid end: " +
                         (problem && !problem->empty() ? *problem : std::string("a reading has no value"));
        return report;
    }
    const Surfaces surfaces(task, rows);
    const Values values = surfaces.samples(task.axes.size());
    addSpread(task, values, report);
    addTightened(task, surfaces, shareWithin(task, values), report);
    addChecks(task, rows, surfaces, values, report);
    addShare(task, values, "samples drawn from the surface", report);
    return report;
}

} // namespace touchdown
