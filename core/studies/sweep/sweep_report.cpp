// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <variant>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/numerics/moments.h"
#include "core/studies/sweep/rank_correlation.h"
#include "core/studies/sweep/sweep_charts.h"
#include "core/studies/sweep/sweep_points.h"
#include "core/studies/sweep/sweep_yield.h"

namespace touchdown {

namespace {

constexpr std::size_t fewestCorrelated = 8; // samples that tell a correlation
constexpr std::size_t mostReasons = 3;      // of failures, in a sentence
constexpr double clearCorrelation = 0.3;    // that a finding names [-]

class Teller {
public:
    explicit Teller(const SweepPoints& points) : at_(points) {}

    StudyReport tell() const
    {
        StudyReport report;
        report.tables.push_back(table());
        report.charts = sweepCharts(at_);
        if (at_.task().samples) addCorrelations(report);
        addFindings(report);
        addYield(at_, report);
        return report;
    }

private:
    StudyTable table() const
    {
        StudyTable table{"sweep"};
        for (std::size_t k = 0; k < at_.axes(); ++k) {
            const SweepAxis& axis = at_.axis(k);
            // A key may have the name of a reading: "contact".
            const auto isAxis = [&](const Reading& reading) { return reading.column().name == axis.columnName(); };
            const bool taken = std::ranges::any_of(at_.task().readings, isAxis);
            table.columns.push_back({axis.columnName() + (taken ? "_of_the_case" : ""),
                                     axis.isNumber ? axis.text.unit : "", axis.isNumber ? axis.text.displayUnit : "",
                                     axis.text.label});
        }
        for (const Reading& reading : at_.task().readings) {
            table.columns.push_back(reading.column());
            if (!at_.averages() || reading.isText || reading.isError) continue;
            StudyColumn deviation = reading.column();
            deviation.longName += ", standard deviation over what is averaged";
            deviation.name += "_deviation";
            deviation.secondary = true;
            table.columns.push_back(std::move(deviation));
        }
        if (at_.averages())
            table.columns.push_back({.name = "failed", .longName = "Items without a valid end", .secondary = true});
        if (keepsFiles())
            table.columns.push_back({.name = "file", .longName = "Results of the run, in the folder runs"});
        table.columns.push_back({.name = "problem", .longName = "Why there is no valid end", .secondary = true});
        for (const SweepPoint& point : at_.points())
            if (!point.rows.empty()) table.rows.push_back(rowOf(point));
        return table;
    }

    std::vector<StudyValue> rowOf(const SweepPoint& point) const
    {
        std::vector<StudyValue> row;
        for (std::size_t k = 0; k < at_.axes(); ++k)
            row.push_back(at_.axis(k).isNumber ? StudyValue(point.at[k].number) : point.at[k].text);
        for (std::size_t r = 0; r < at_.readings(); ++r) {
            row.push_back(at_.valueOf(point, r));
            const Reading& reading = at_.reading(r);
            if (!at_.averages() || reading.isText || reading.isError) continue;
            const std::vector<double> list = at_.numbers(point, r);
            row.push_back(known(!list.empty(), list.empty() ? 0.0 : momentsOf(list).deviation));
        }
        if (at_.averages())
            row.emplace_back(double(
                std::ranges::count_if(point.rows, [&](const ItemRow* each) { return !at_.problemOf(*each).empty(); })));
        if (keepsFiles()) row.push_back((*point.rows.front())[at_.readings()]);
        row.emplace_back(at_.firstProblem(point));
        return row;
    }

    /// A point that is averaged over has a file for each of its items, which no column names.
    bool keepsFiles() const { return at_.task().keepsRuns && !at_.averages(); }

    void addCorrelations(StudyReport& report) const
    {
        StudyTable table{"rank_correlations",
                         {{.name = "reading", .longName = "Reading"},
                          {.name = "axis", .longName = "Axis"},
                          {.name = "correlation", .longName = "Spearman's rank correlation"},
                          {.name = "samples", .longName = "Samples with both"}}};
        for (const std::size_t r : at_.drawn()) {
            std::vector<std::pair<double, std::string>> clear;
            for (std::size_t k = 0; k < at_.axes(); ++k) {
                if (!at_.axis(k).isNumber) continue; // texts have no order
                std::vector<double> x, y;
                for (const SweepPoint& point : at_.points())
                    if (const double value = at_.numberOf(point, r); std::isfinite(value)) {
                        x.push_back(point.at[k].number);
                        y.push_back(value);
                    }
                if (x.size() < fewestCorrelated) continue;
                const double correlation = rankCorrelation(x, y);
                const SweepAxis& axis = at_.axis(k);
                table.rows.push_back({at_.reading(r).column().name, axis.key.key, correlation, double(x.size())});
                if (std::abs(correlation) >= clearCorrelation)
                    clear.emplace_back(-std::abs(correlation),
                                       uncapitalized(axis.text.label) + " (" + fewDigits(correlation, "", 2) + ")");
            }
            if (clear.empty()) continue;
            std::ranges::sort(clear);
            std::vector<std::string> names;
            for (const auto& [size, text] : clear) names.push_back(text);
            report.findings.push_back(at_.reading(r).column().longName + " goes most with " + joined(names) +
                                      ", by rank correlation.");
        }
        if (!table.rows.empty()) report.tables.push_back(std::move(table));
    }

    void addFindings(StudyReport& report) const
    {
        std::vector<std::string> ranges;
        for (const std::size_t r : at_.drawn()) {
            const SweepPoint *least = nullptr, *most = nullptr;
            for (const SweepPoint& point : at_.points()) {
                const double value = at_.numberOf(point, r);
                if (!std::isfinite(value)) continue;
                if (least == nullptr || value < at_.numberOf(*least, r)) least = &point;
                if (most == nullptr || value > at_.numberOf(*most, r)) most = &point;
            }
            if (least == nullptr) continue;
            const auto hasValue = [&](const SweepPoint& point) { return std::isfinite(at_.numberOf(point, r)); };
            const auto known = std::size_t(std::ranges::count_if(at_.points(), hasValue));
            const std::string name = at_.reading(r).column().longName;
            const auto shown = [&](const SweepPoint& point) {
                return at_.textOf(point, r) + " (" + at_.nameOf(point) + ")";
            };
            ranges.push_back(name + (at_.numberOf(*least, r) == at_.numberOf(*most, r)
                                         ? ": " + at_.textOf(*least, r) +
                                               (known == at_.points().size()
                                                    ? std::string(" everywhere.")
                                                    : " wherever there is a value, at " + std::to_string(known) +
                                                          " of " + counted(at_.points().size(), "point") + ".")
                                         : ": from " + shown(*least) + " to " + shown(*most) + "."));
        }
        for (std::size_t r = 0; r < at_.readings(); ++r)
            if (at_.reading(r).isText) ranges.push_back(countsOf(r));
        report.findings.insert(report.findings.begin(), ranges.begin(), ranges.end());
        addFailures(report);
    }

    /// "How the motion ends: at rest 5, bounces 2."
    std::string countsOf(std::size_t reading) const
    {
        std::map<std::string, std::size_t> counts;
        for (const SweepPoint& point : at_.points())
            for (const ItemRow* row : point.rows)
                if (const auto* text = std::get_if<std::string>(&(*row)[reading])) ++counts[*text];
        std::vector<std::string> words;
        for (const auto& [text, count] : counts) words.push_back(text + " " + std::to_string(count));
        return at_.reading(reading).column().longName + ": " + (words.empty() ? "not known" : joined(words)) + ".";
    }

    void addFailures(StudyReport& report) const
    {
        std::map<std::string, std::size_t> reasons;
        std::size_t failed = 0, done = 0;
        for (const auto& row : at_.rows()) {
            if (!row) continue;
            ++done;
            if (at_.problemOf(*row).empty()) continue;
            ++failed;
            ++reasons[at_.problemOf(*row)];
        }
        if (failed == 0) return;
        std::vector<std::pair<std::size_t, std::string>> sorted;
        for (const auto& [reason, count] : reasons) sorted.emplace_back(count, reason);
        std::ranges::stable_sort(sorted, std::greater{}, [](const auto& each) { return each.first; });
        std::vector<std::string> words;
        for (std::size_t i = 0; i < std::min(sorted.size(), mostReasons); ++i)
            words.push_back(std::to_string(sorted[i].first) + " of them: " + sorted[i].second);
        report.warnings.push_back(counted(failed, "item") + " of " + std::to_string(done) +
                                  (failed == 1 ? " has" : " have") + " no valid end; " + joined(words, "; ") + ".");
        if (failed == at_.rows().size()) {
            report.status = StudyStatus::Failed;
            report.message = "no item has a valid end: " + sorted.front().second;
        }
    }

    const SweepPoints& at_;
};

} // namespace

StudyReport sweepReport(const SweepTask& task, const ItemRows& rows)
{
    return task.design.empty() ? Teller(SweepPoints(task, rows)).tell() : surfaceReport(task, rows);
}

} // namespace touchdown
