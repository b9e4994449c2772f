// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_task.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/quotation.h"
#include "core/simulation/run.h"
#include "core/studies/stability/stability.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

constexpr std::size_t mostRuns = 100000;
constexpr double checkStep = 1e-9; // of rk4-events, of a reference [s]
constexpr double mostCheckSteps = 4e6;

std::vector<std::string> multiples(double value, const std::string& displayUnit, const std::vector<double>& factors)
{
    std::vector<std::string> list;
    for (const double factor : factors) list.push_back(fewDigits(factor * value, displayUnit, 6));
    return list;
}

/// The parameter, and its values as they are given; one empty label where nothing is varied.
std::vector<std::string> readParameter(StudyReader& reader, StabilityTask& task)
{
    const DefaultParameter otherwise = defaultParameter(task.start);
    const auto key = reader.text("parameter");
    const auto values = reader.texts("values");
    if (task.start.model == ModelKind::Contact) {
        reader.add("case", "is of model \"contact\", whose pad follows a prescribed motion; a stability study takes a "
                           "case of model \"springs\" or \"film\"");
        return {};
    }
    const std::string chosen = key ? *key : values ? std::string() : otherwise.key;
    if (!key && values)
        reader.add("values", "are of no parameter; name it with parameter = \"ono_yamane.contact_stiffness\"");
    if (chosen.empty()) return {""};
    task.parameter = findField(chosen);
    if (task.parameter == nullptr) {
        const std::string near = nearestKey(chosen);
        reader.add("parameter",
                   inQuotes(chosen) + " is no key of a case" + (near.empty() ? "" : "; did you mean " + near + "?"));
        return {};
    }
    if (const std::string unused = unusedMessage(task.start, *task.parameter); !unused.empty())
        reader.add("parameter", inQuotes(chosen) + " " + unused);
    for (const char* fixed : {"model", "run.integrator", "run.sample_interval"})
        if (chosen == fixed) reader.add("parameter", inQuotes(chosen) + " cannot be varied here");
    task.parameterIsNumber = task.parameter->kind == FieldKind::Number || task.parameter->kind == FieldKind::Integer;
    if (key && !values && chosen != otherwise.key) reader.add("parameter", "has no values");
    return values ? *values : otherwise.values;
}

void makeRows(StudyReader& reader, StabilityTask& task, const std::vector<std::string>& labels)
{
    std::size_t runs = 0;
    for (const std::string& label : labels) {
        StabilityRow row{.label = label, .value = double(task.rows.size() + 1), .references = {}, .methods = {}};
        Case base = task.start;
        if (task.parameter != nullptr) {
            if (const std::string problem = applySettings(base, {{task.parameter->key, label}}); !problem.empty()) {
                reader.add("values", problem);
                continue;
            }
            const FieldValue value = task.parameter->get(base);
            if (const auto* number = std::get_if<double>(&value))
                row.value = *number;
            else if (const auto* whole = std::get_if<int>(&value))
                row.value = *whole;
        }
        row.references = base.model == ModelKind::Springs
                             ? springReferences(base, std::max(checkStep, base.run.duration / mostCheckSteps))
                             : couplingReferences(base);
        for (const MethodSpec& spec : task.methods) {
            SweptMethod& method = row.methods.emplace_back();
            if (const std::string problem = makeMethod(base, spec, method, false); !problem.empty()) {
                reader.add("method", spec.name + ": " + problem);
                return; // the others would say the same
            }
            runs += method.settings.size();
        }
        task.rows.push_back(std::move(row));
    }
    if (runs > mostRuns)
        reader.add("values", "make " + std::to_string(runs) + " runs; " + std::to_string(mostRuns) + " are the most");
}

} // namespace

DefaultParameter defaultParameter(const Case& c)
{
    const std::vector<double> factors{0.2, 0.5, 1.0, 2.0, 5.0, 10.0};
    if (c.model == ModelKind::Film)
        return {"suspension.preload", multiples(c.suspension.preload, "mN", {0.7, 1.0, 1.4})};
    if (c.contact == ContactKind::OnoYamane && c.onoYamane.contactStiffness > 0.0)
        return {"ono_yamane.contact_stiffness", multiples(c.onoYamane.contactStiffness, "N/m", factors)};
    if (c.springs.rearStiffness > 0.0)
        return {"springs.rear_stiffness", multiples(c.springs.rearStiffness, "N/m", factors)};
    return {"initial.flying_height", multiples(c.initial.flyingHeight, "nm", {0.5, 1.0, 2.0})};
}

std::vector<MethodSpec> defaultStabilityMethods(const Case& c)
{
    if (c.model == ModelKind::Film) {
        const std::vector<std::string> steps{"2 us", "1 us", "0.5 us", "0.2 us", "0.1 us", "0.05 us"};
        return {{"monolithic", {{"film.coupling", "monolithic"}, {"run.steps", "fixed"}}, "run.step", steps, {}},
                {"staggered", {{"film.coupling", "staggered"}, {"run.steps", "fixed"}}, "run.step", steps, {}}};
    }
    if (c.model != ModelKind::Springs) return {};
    const std::vector<std::string> steps{"500 ns", "200 ns", "100 ns", "50 ns", "20 ns",
                                         "10 ns",  "5 ns",   "2 ns",   "1 ns"};
    return {{"rk4", {{"run.integrator", "rk4"}}, "run.step", steps, {}},
            {"rk4-events", {{"run.integrator", "rk4-events"}}, "run.step", steps, {}},
            {"dopri5",
             {{"run.integrator", "dopri5"}},
             "run.tolerance",
             {"1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10"},
             {}}};
}

StudyForm stabilityForm(const Case& c)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    const DefaultParameter parameter = defaultParameter(c);
    const ClassRule rule;
    // A film moves less.
    const double agreement = c.model == ModelKind::Film ? 0.01e-9 : rule.agreement;
    StudyForm form;
    form.keys = {
        booleanKey("picture", true, "stability region of each method, with the eigenvalues of the case times its step"),
        booleanKey("map", true, "runs over settings and a parameter, each compared with a reference"),
        textKey("parameter", parameter.key, "", "a key of the case"),
        listKey("values", parameter.values, "values of the parameter"),
        numberKey("agreement", agreement, "m", "nm", 1e-24, endless,
                  "largest distance between two trajectories that agree"),
        numberKey("energy_drift", rule.energyDrift, "", "", 1e-12, endless,
                  "largest energy imbalance of a good run, relative to the largest change of a part of the energy"),
    };
    for (StudyKey& key : methodKeys(false)) form.keys.push_back(std::move(key));
    for (const MethodSpec& method : defaultStabilityMethods(c)) form.lists += methodText(method);
    return form;
}

StabilityTask readStabilityTask(StudyReader& reader)
{
    StabilityTask task;
    task.start = reader.start();
    task.picture = reader.flag("picture");
    task.map = reader.flag("map");
    task.rule = {.agreement = reader.number("agreement"), .energyDrift = reader.number("energy_drift")};
    if (!task.picture && !task.map) reader.add("map", "is false, and so is picture; at least one of them must be true");
    const std::vector<std::string> labels = readParameter(reader, task);
    task.methods = readMethods(reader, false);
    if (task.methods.empty()) task.methods = defaultStabilityMethods(task.start);
    if (task.start.model == ModelKind::Contact) return task;
    if (const std::string reason = reasonNotToRun(task.start); !reason.empty())
        reader.add("case", reason);
    else if (task.map)
        makeRows(reader, task, labels);
    return task;
}

} // namespace touchdown
