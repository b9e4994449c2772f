// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/design_report.h"

#include <cmath>

#include "app/commands/steady_report.h"
#include "app/terminal/json_text.h"
#include "app/terminal/number_text.h"
#include "app/terminal/report_row.h"

namespace touchdown {

namespace {

/// The grid's error where it is estimated.
double gridError(const DiscretisationError& error, const std::string& quantity)
{
    if (quantity == "minimum_spacing") return error.minimumSpacing;
    if (quantity == "pitch") return error.pitch;
    if (quantity == "roll") return error.roll;
    return 0.0;
}

Json pointJson(const DesignTask& task, const DesignPoint& point)
{
    Json parameters = Json::object(), quantities = Json::object();
    for (std::size_t i = 0; i < point.parameters.size(); ++i)
        parameters[task.parameters[i].keys.front().key] = jsonNumber(point.parameters[i]);
    for (std::size_t i = 0; i < point.quantities.size(); ++i)
        quantities[task.targets[i].quantity.name] = jsonNumber(point.quantities[i]);
    return {{"iteration", point.iteration},
            {"parameters", parameters},
            {"quantities", quantities},
            {"misfit", point.problem.empty() ? jsonNumber(point.misfit) : Json(nullptr)}};
}

std::string targetText(const DesignTarget& target)
{
    const std::string& unit = target.quantity.displayUnit;
    return displayed(target.value, unit, 5) + " within " + displayed(target.tolerance, unit, 3);
}

} // namespace

std::string designJson(const DesignTask& task, const DesignStudy& study)
{
    Json steps = Json::array(), targets = Json::array();
    for (const DesignPoint& point : study.steps) steps.push_back(pointJson(task, point));
    for (const DesignTarget& target : task.targets)
        targets.push_back(
            {{"quantity", target.quantity.name},
             {"value", jsonNumber(target.value)},
             {"tolerance", jsonNumber(target.tolerance)},
             {"grid_error", jsonNumber(gridError(study.state.discretisationError, target.quantity.name))}});
    const bool known = !study.steps.empty() && study.steps.back().problem.empty();
    return jsonText({{"status", name(study.status)},
                     {"message", study.message},
                     {"solves", study.solves},
                     {"wall_seconds", jsonNumber(study.wallSeconds)},
                     {"targets", targets},
                     {"best", known ? pointJson(task, study.steps.back()) : Json(nullptr)},
                     {"state", known ? Json{{"status", name(study.state.status)}, {"message", study.state.message}}
                                     : Json(nullptr)},
                     {"steps", steps}});
}

std::string designText(const DesignTask& task, const DesignStudy& study)
{
    std::string text = study.found.title + "\n";
    text += reportRow("status", std::string(name(study.status)) + (study.message.empty() ? "" : ": " + study.message));
    text +=
        reportRow("search", std::to_string(study.solves) + " static states, " + displayed(study.wallSeconds, "s", 3));
    const DesignPoint& best = study.steps.back();
    for (std::size_t i = 0; i < best.parameters.size(); ++i) {
        const DesignParameter& parameter = task.parameters[i];
        const DesignKey& key = parameter.keys.front();
        text += reportRow(key.key, displayed(best.parameters[i], key.displayUnit, 7) + ", from " +
                                       displayed(parameter.start, key.displayUnit, 7));
    }
    if (!best.problem.empty()) return text;
    for (std::size_t i = 0; i < best.quantities.size(); ++i) {
        const DesignTarget& target = task.targets[i];
        const std::string& unit = target.quantity.displayUnit;
        const double error = gridError(study.state.discretisationError, target.quantity.name);
        text += reportRow(target.quantity.name,
                          displayed(best.quantities[i], unit, 5) +
                              (error > 0.0 ? " (grid error about " + displayed(error, unit, 2) + ")" : "") +
                              ", wanted " + targetText(target));
    }
    return text + reportRow("static state", statusText(study.state.status, study.state.message));
}

} // namespace touchdown
