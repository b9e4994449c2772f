// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence_study.h"

#include <cmath>

#include "core/studies/convergence/convergence.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

std::size_t ownLevel(const ConvergenceStudy& study) { return study.levels.size() - 2; }

void addFindings(const ConvergenceStudy& study, StudyReport& report)
{
    report.findings.push_back("State: closest approach, separation " + fewDigits(study.separation, "nm", 6) + ".");
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        const Quantity& quantity = study.quantities[i];
        const ObservedOrder& observed = study.observed[i];
        const auto text = [&](double value, int digits) { return fewDigits(value, quantity.displayUnit, digits); };
        std::string finding = quantity.longName;
        if (observed.order) {
            const double own = study.levels[ownLevel(study)].values[i];
            finding += ": observed order " + fewDigits(*observed.order, "", 3) + ", limit " + text(observed.limit, 7) +
                       "; error with the cells of the case about " + text(std::abs(own - observed.limit), 2) +
                       ", with the finest cells about " + text(observed.error, 2);
        } else {
            finding += ": no observed order; " + text(observed.limit, 7) +
                       " with the finest cells, uncertain by about " + text(observed.error, 2);
        }
        report.findings.push_back(finding + ".");
    }
}

StudyChart chartOf(const ConvergenceStudy& study)
{
    ChartPanel panel;
    panel.x = {"Side of a cell", "m", "um", true};
    panel.y = {"Relative distance from the limit", "", "", true};
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        ChartSeries series{.name = study.quantities[i].longName, .points = {}};
        const double limit = study.observed[i].limit;
        for (const ConvergenceLevel& level : study.levels)
            if (const double distance = std::abs(level.values[i] / limit - 1.0);
                std::isfinite(distance) && distance > 0.0)
                series.points.push_back(
                    {.x = level.cell, .y = distance, .chosen = &level == &study.levels[ownLevel(study)]});
        panel.series.push_back(std::move(series));
    }
    return {.title = "Distance from the limit over the size of a cell",
            .caption = "Each point is the closest approach, solved with cells of one size; the ring marks the cells "
                       "of the case. The limit is extrapolated from the three finest levels. Where no order is "
                       "observed, it is the value of the finest level.",
            .panels = {panel}};
}

StudyTable levelsOf(const ConvergenceStudy& study)
{
    StudyTable table{.name = "levels",
                     .columns = {{"cell", "m", "um", "Side of a cell"},
                                 {"cells", "", "", "Cells of all patches"},
                                 {"seconds", "s", "s", "Wall time"}},
                     .rows = {}};
    for (const Quantity& quantity : study.quantities)
        table.columns.push_back({quantity.name, quantity.unit, quantity.displayUnit, quantity.longName});
    table.columns.push_back({"iterations", "", "", "Iterations of the contact solver", true});
    for (const ConvergenceLevel& level : study.levels) {
        if (!level.problem.empty()) continue;
        std::vector<StudyValue>& row = table.rows.emplace_back();
        row = {level.cell, double(level.cells), level.seconds};
        for (const double value : level.values) row.emplace_back(value);
        row.emplace_back(double(level.iterations));
    }
    return table;
}

/// Numbers in the SI unit that stands in their row.
StudyTable observedOf(const ConvergenceStudy& study)
{
    StudyTable table{.name = "observed",
                     .columns = {{"quantity", "", "", "Quantity"},
                                 {"order", "", "", "Observed order"},
                                 {"limit", "", "", "Limit by Richardson's extrapolation"},
                                 {"error", "", "", "Estimated error of the finest level"},
                                 {"unit", "", "", "SI unit of limit and error"}},
                     .rows = {}};
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        const ObservedOrder& observed = study.observed[i];
        table.rows.push_back({study.quantities[i].name, observed.order ? StudyValue(*observed.order) : StudyValue(),
                              observed.limit, observed.error, study.quantities[i].unit});
    }
    return table;
}

StudyReport perform(const Case& start, ConvergenceOptions options, int jobs, const StudyCallback& callback)
{
    options.jobs = jobs;
    const auto done = [&](int solved) {
        const double share = double(solved) / options.levels;
        return !callback ||
               callback({.share = share,
                         .doing = std::to_string(solved) + " of " + std::to_string(options.levels) + " levels",
                         .soFar = nullptr});
    };
    return convergenceReport(studyConvergence(start, options, done));
}

} // namespace

StudyReport convergenceReport(const ConvergenceStudy& study)
{
    StudyReport report;
    report.status = study.status;
    report.message = study.message;
    report.wallSeconds = study.wallSeconds;
    report.tables = {levelsOf(study)};
    if (study.observed.empty()) return report;
    addFindings(study, report);
    report.charts = {chartOf(study)};
    report.tables.push_back(observedOf(study));
    return report;
}

StudyPerformance planConvergence(StudyReader& reader)
{
    ConvergenceOptions options;
    options.levels = reader.integer("levels");
    if (const std::string reason = reasonNotToConverge(reader.start(), options); !reason.empty())
        reader.add("case", reason);
    return [start = reader.start(), options](int jobs, const StudyCallback& callback) {
        return perform(start, options, jobs, callback);
    };
}

StudyForm convergenceForm(const Case&)
{
    return {
        .keys = {integerKey("levels", ConvergenceOptions{}.levels, fewestLevels, mostLevels,
                            "cells of each level are half as large; the last level but one has those of the case")}};
}

} // namespace touchdown
