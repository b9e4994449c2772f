// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/convergence_report.h"

#include "app/terminal/aligned_table.h"
#include "app/terminal/json_text.h"
#include "app/terminal/number_text.h"
#include "app/terminal/report_row.h"

namespace touchdown {
namespace {

using Row = std::vector<std::string>;

std::string orderText(const ObservedOrder& observed)
{
    return observed.order ? displayed(*observed.order, "", 3) : "none";
}

} // namespace

std::string convergenceJson(const ConvergenceStudy& study)
{
    Json levels = Json::array();
    for (const ConvergenceLevel& level : study.levels) {
        Json values = Json::object();
        for (std::size_t i = 0; i < level.values.size(); ++i)
            values[study.quantities[i].name] = jsonNumber(level.values[i]);
        levels.push_back({{"cell", jsonNumber(level.cell)},
                          {"cells", level.cells},
                          {"iterations", level.iterations},
                          {"seconds", jsonNumber(level.seconds)},
                          {"values", values}});
    }
    Json observed = Json::object();
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        const ObservedOrder& one = study.observed[i];
        observed[study.quantities[i].name] = {{"order", one.order ? jsonNumber(*one.order) : Json(nullptr)},
                                              {"limit", jsonNumber(one.limit)},
                                              {"error", jsonNumber(one.error)}};
    }
    return jsonText({{"status", name(study.status)},
                     {"message", study.message},
                     {"separation", jsonNumber(study.separation)},
                     {"wall_seconds", jsonNumber(study.wallSeconds)},
                     {"levels", levels},
                     {"observed", observed}});
}

std::string convergenceText(const Case& c, const ConvergenceStudy& study)
{
    std::string text = c.title + "\n";
    text += reportRow("status", std::string(name(study.status)));
    text += reportRow("state", "closest approach, separation " + displayed(study.separation, "nm"));
    if (study.observed.empty()) return text;
    std::vector<Row> rows{{"cell", "cells"}};
    for (const Quantity& quantity : study.quantities) rows.front().push_back(quantity.name);
    rows.front().push_back("time");
    for (const ConvergenceLevel& level : study.levels) {
        Row row{displayed(level.cell, "um"), std::to_string(level.cells)};
        for (std::size_t i = 0; i < level.values.size(); ++i)
            row.push_back(displayed(level.values[i], study.quantities[i].displayUnit, 7));
        row.push_back(displayed(level.seconds, "s", 3));
        rows.push_back(std::move(row));
    }
    Row order{"observed order", ""}, limit{"limit", ""}, error{"error", ""};
    for (std::size_t i = 0; i < study.observed.size(); ++i) {
        const std::string& unit = study.quantities[i].displayUnit;
        order.push_back(orderText(study.observed[i]));
        limit.push_back(displayed(study.observed[i].limit, unit, 7));
        error.push_back(displayed(study.observed[i].error, unit, 2));
    }
    for (Row* row : {&order, &limit, &error}) rows.push_back(*row);
    return text + alignedTable(rows);
}

} // namespace touchdown
