// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/case/contact_check.h"
#include "core/case/contact_law.h"
#include "core/formats/decimal.h"
#include "core/formats/units.h"
#include "core/simulation/contact/elastic_pad.h"
#include "core/simulation/contact/pad_way.h"
#include "core/simulation/run.h"
#include "core/studies/convergence/film_convergence_report.h"
#include "core/studies/convergence/film_convergence_task.h"
#include "core/studies/runs/case_content.h"
#include "core/studies/study/study_reader.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

/// Differences that shrink faster than any of the methods here does so by chance.
constexpr double highestOrder = 3.0;
/// Steps from the start to the closest approach where the state depends on how it was reached.
constexpr int stepsOfAdhesion = 40;

/// The cell of the last but one level is that of the case.
double cellOf(const Case& c, int level, int levels) { return std::ldexp(c.elastic.cell, levels - 2 - level); }

/// What does not follow from the rest.
std::vector<Quantity> studied(const Case& c)
{
    std::vector<Quantity> list = contactQuantities(c);
    std::erase_if(list, [](const Quantity& quantity) {
        return quantity.name == "minimum_spacing" || quantity.name == "net_contact_force" ||
               quantity.name == "friction_force";
    });
    return list;
}

ConvergenceLevel solveLevel(Case c, double cell, const std::function<bool()>& goOn)
{
    const double begin = wallClock();
    ConvergenceLevel level;
    level.cell = cell;
    c.elastic.cell = cell;
    ElasticPad pad(c, goOn);
    level.cells = static_cast<long long>(pad.cells());
    const double closest = 0.5 * c.run.duration;
    const int steps = pad.canJump() ? stepsOfAdhesion : 1;
    ContactForces forces;
    for (int i = pad.canJump() ? 0 : 1; i <= steps && forces.problem.empty(); ++i) {
        const double time = closest * i / steps;
        forces = pad.move(i == steps ? c.approach.closest : padSeparation(c, time), time);
        level.iterations += forces.iterations;
    }
    level.problem = forces.problem;
    const std::vector<Quantity> all = contactQuantities(c);
    std::vector<double> values(all.size());
    contactValues(c, contactRows(c), forces, values.data());
    for (const Quantity& quantity : studied(c))
        level.values.push_back(values[static_cast<std::size_t>(findQuantity(all, quantity.name))]);
    level.seconds = wallClock() - begin;
    return level;
}

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
        ChartSeries series{.name = study.quantities[i].longName};
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
                                 {"seconds", "s", "s", "Wall time"}}};
    for (const Quantity& quantity : study.quantities)
        table.columns.push_back({quantity.name, quantity.unit, quantity.displayUnit, quantity.longName});
    table.columns.push_back({"iterations", "", "", "Iterations of the contact solver", true});
    for (const ConvergenceLevel& level : study.levels) {
        if (!level.solved || !level.problem.empty()) continue;
        std::vector<StudyValue>& row = table.rows.emplace_back();
        row = {level.cell, double(level.cells), level.seconds};
        for (const double value : level.values) row.push_back(ifFinite(value));
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
                                 {"unit", "", "", "SI unit of limit and error"}}};
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        const ObservedOrder& observed = study.observed[i];
        table.rows.push_back({study.quantities[i].name, known(observed.order), observed.limit, observed.error,
                              study.quantities[i].unit});
    }
    return table;
}

/// Problem, cells, iterations, seconds, then the values.
ItemRow rowOf(const ConvergenceLevel& level)
{
    ItemRow row{level.problem, double(level.cells), double(level.iterations), level.seconds};
    for (const double value : level.values) row.push_back(ifFinite(value));
    return row;
}

void take(const ItemRow& row, ConvergenceLevel& level)
{
    level.problem = textAt(row, 0);
    level.cells = std::llround(numberAt(row, 1));
    level.iterations = std::llround(numberAt(row, 2));
    level.seconds = numberAt(row, 3);
    for (std::size_t i = 4; i < row.size(); ++i) level.values.push_back(numberAt(row, i));
}

} // namespace

ObservedOrder observedOrder(double coarse, double middle, double fine)
{
    const double before = middle - coarse;
    const double last = fine - middle;
    if (last == 0.0) return {{}, fine, 0.0};
    const double ratio = before / last;
    if (!(ratio > 1.0) || ratio > std::exp2(highestOrder))
        return {{}, fine, std::max(std::abs(before), std::abs(last))};
    const double order = std::log2(ratio);
    const double correction = last / (ratio - 1.0);
    return {order, fine + correction, std::abs(correction)};
}

std::string reasonNotToConverge(const Case& c, int levels)
{
    if (c.model == ModelKind::Springs)
        return "is of model \"springs\", which has no grid; run.step_check compares a run with one of half its time "
               "step";
    if (!contactLaw(c).recordsSurfaces)
        return "has a contact law without a grid; a convergence study takes contact \"elastic\", or a film";
    if (std::string reason = reasonNotToRun(c); !reason.empty()) return reason;
    for (int level = 0; level < levels; ++level) {
        Case at = c;
        at.elastic.cell = cellOf(c, level, levels);
        std::vector<CaseProblem> problems;
        checkPatch(at, problems);
        if (!problems.empty())
            return problems.front().key + ": " + problems.front().message +
                   "; take fewer levels or another elastic.cell";
    }
    return {};
}

ConvergenceStudy convergenceOf(const Case& c, int levels, const ItemRows& rows)
{
    ConvergenceStudy study;
    study.separation = c.approach.closest;
    study.quantities = studied(c);
    for (int i = 0; i < levels; ++i) {
        ConvergenceLevel& level = study.levels.emplace_back();
        level.cell = cellOf(c, i, levels);
        level.solved = rows[std::size_t(i)].has_value();
        if (level.solved) take(*rows[std::size_t(i)], level);
    }
    for (const ConvergenceLevel& level : study.levels) {
        if (level.problem.empty()) continue;
        study.status = StudyStatus::Failed;
        study.message = "cells of " + formatQuantity(level.cell, "um") + ": " + level.problem;
        return study;
    }
    if (!isWhole(rows)) return study;
    const std::size_t last = study.levels.size() - 1;
    for (std::size_t i = 0; i < study.quantities.size(); ++i)
        study.observed.push_back(observedOrder(study.levels[last - 2].values[i], study.levels[last - 1].values[i],
                                               study.levels[last].values[i]));
    return study;
}

ItemStudy convergenceItems(const Case& c, int levels)
{
    const auto contents = std::make_shared<CaseContent>();
    const auto cellAt = [c, levels](std::size_t i) { return cellOf(c, int(i), levels); };
    return {
        .count = std::size_t(levels),
        .width = 4 + studied(c).size(),
        .content = [c, cellAt,
                    contents](std::size_t i) { return "level " + decimalText(cellAt(i)) + "\n" + contents->of(c); },
        .solve = [c, cellAt](std::size_t i, ItemCall& call) -> std::optional<ItemRow> {
            const ConvergenceLevel level = solveLevel(c, cellAt(i), call.goOn);
            return call.goOn() ? std::optional(rowOf(level)) : std::nullopt;
        },
        .report = [c, levels](const ItemRows& rows) { return convergenceReport(convergenceOf(c, levels, rows)); },
        .cost = [](std::size_t i) { return std::pow(4.0, double(i)); }, // as many cells
        .end = [contents] { contents->forget(); },
    };
}

StudyReport convergenceReport(const ConvergenceStudy& study)
{
    StudyReport report;
    report.status = study.status;
    report.message = study.message;
    report.tables = {levelsOf(study)};
    if (study.observed.empty()) return report;
    addFindings(study, report);
    report.charts = {chartOf(study)};
    report.tables.push_back(observedOf(study));
    return report;
}

StudyWork planConvergence(StudyReader& reader)
{
    if (reader.start().model == ModelKind::Film)
        return StudyPerformance([task = readFilmConvergence(reader)](int jobs, const StudyCallback& callback) {
            const auto report = [&](const FilmConvergence& study) { return filmConvergenceReport(task, study); };
            return report(performFilmConvergence(task, jobs, callback, report));
        });
    const int levels = reader.integer("levels");
    if (const std::string reason = reasonNotToConverge(reader.start(), levels); !reason.empty())
        reader.add("case", reason);
    return convergenceItems(reader.start(), levels);
}

StudyForm convergenceForm(const Case& c)
{
    if (c.model == ModelKind::Film) return filmConvergenceForm(c);
    return {.keys = {integerKey(
                "levels", standardLevels, fewestLevels, mostLevels,
                "of a contact case: cells of each level are half as large; the last level but one has its own")}};
}

} // namespace touchdown
