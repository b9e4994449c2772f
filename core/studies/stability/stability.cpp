// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/simulation/run.h"
#include "core/studies/stability/stability_curves.h"
#include "core/studies/stability/stability_map.h"
#include "core/studies/stability/stability_picture.h"
#include "core/studies/stability/stability_report.h"
#include "core/studies/study/growing_report.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

/// Adds what became of the runs before the linear picture, which explains it.
StudyReport withMap(StudyReport report, const StabilityTask& task, const StabilityMap& map, bool whole)
{
    StudyReport runs;
    if (whole) tellMap(task, map, runs);
    report.findings.insert(report.findings.begin(), runs.findings.begin(), runs.findings.end());
    report.warnings.insert(report.warnings.begin(), runs.warnings.begin(), runs.warnings.end());
    report.charts.push_back(mapChart(task, map));
    std::vector<StudyTable> tables = mapTables(task, map);
    report.tables.insert(report.tables.begin(), tables.begin(), tables.end());
    return report;
}

/// The report of the linear picture; nothing where it was told to end.
std::optional<StudyReport> pictureOf(const StabilityTask& task, const GoOn& goOn)
{
    StudyReport report;
    if (!makeLinearPicture(task.start, report, goOn)) return {};
    if (const std::string reason = std::exchange(report.message, {}); !reason.empty()) {
        report.warnings.insert(report.warnings.begin(), "There is no linear picture: " + reason + ".");
        report.status = task.map ? StudyStatus::Completed : StudyStatus::Failed;
        if (!task.map) report.message = "there is no linear picture: " + reason;
    }
    return report;
}

constexpr std::size_t mostRuns = 100000;
constexpr double checkStep = 1e-9; // of rk4-events, of a reference [s]
constexpr double mostCheckSteps = 4e6;

std::vector<std::string> multiples(double value, const std::string& displayUnit, const std::vector<double>& factors)
{
    std::vector<std::string> list;
    for (const double factor : factors) list.push_back(fewDigits(factor * value, displayUnit, 6));
    return list;
}

std::vector<MethodSpec> defaultStabilityMethods(const Case& c)
{
    if (c.model == ModelKind::Film) {
        const std::vector<std::string> steps{"2 us", "1 us", "0.5 us", "0.2 us", "0.1 us", "0.05 us"};
        return {{"monolithic", {{"film.coupling", "monolithic"}, {"run.steps", "fixed"}}, "run.step", steps, {}},
                {"staggered", {{"film.coupling", "staggered"}, {"run.steps", "fixed"}}, "run.step", steps, {}}};
    }
    if (c.model != ModelKind::Springs) return {};
    std::vector<std::string> steps{"500 ns", "200 ns", "100 ns", "50 ns", "20 ns", "10 ns", "5 ns", "2 ns", "1 ns"};
    // A surface that moves may not allow the longest ones.
    std::erase_if(steps, [&](const std::string& step) {
        Case at = c;
        return step != "1 ns" && changeCase(at, {{"run.integrator", "rk4"}, {"run.step", step}}).has_value();
    });
    return {{"rk4", {{"run.integrator", "rk4"}}, "run.step", steps, {}},
            {"rk4-events", {{"run.integrator", "rk4-events"}}, "run.step", steps, {}},
            {"dopri5",
             {{"run.integrator", "dopri5"}},
             "run.tolerance",
             {"1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10"},
             {}}};
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
    task.parameter = findParameter(chosen);
    if (task.parameter == nullptr) {
        reader.add("parameter", inQuotes(chosen) + " is no key of a case" + didYouMean(nearestKey(chosen)));
        return {};
    }
    if (const std::string unused = unusedMessage(task.start, *task.parameter); !unused.empty())
        reader.add("parameter", inQuotes(chosen) + " " + unused);
    for (const char* fixed : {"model", "run.integrator", "run.sample_interval"})
        if (chosen == fixed) reader.add("parameter", inQuotes(chosen) + " cannot be varied here");
    task.parameterIsNumber =
        task.parameter->kind == ParameterKind::Number || task.parameter->kind == ParameterKind::Integer;
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
            const std::vector<CaseSetting> value{{task.parameter->key, label}};
            if (const auto problem = changeCase(base, value, reader.outsidePaths())) {
                reader.add("values", problem->text());
                continue;
            }
            if (task.parameterIsNumber) row.value = numberOf(*task.parameter, base);
        }
        row.references = base.model == ModelKind::Springs
                             ? springReferences(base, std::max(checkStep, base.run.duration / mostCheckSteps))
                             : couplingReferences(base);
        for (const MethodSpec& spec : task.methods) {
            SweptMethod& method = row.methods.emplace_back();
            if (const auto problem = makeMethod(base, spec, method, false)) {
                reader.add("method", spec.name + ": " + problem->text());
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
    if (const auto law = characteristic(c); law && law->contactStiffness > 0.0)
        return {"ono_yamane.contact_stiffness", multiples(law->contactStiffness, "N/m", factors)};
    if (c.springs.rearStiffness > 0.0)
        return {"springs.rear_stiffness", multiples(c.springs.rearStiffness, "N/m", factors)};
    return {"initial.flying_height", multiples(c.initial.flyingHeight, "nm", {0.5, 1.0, 2.0})};
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

StudyWork planStability(StudyReader& reader)
{
    const auto task = std::make_shared<const StabilityTask>(readStabilityTask(reader));
    if (!task->map)
        return StudyPerformance([task](int, const StudyCallback& callback) {
            const auto picture = pictureOf(*task, [&] {
                return !callback || callback({0.0, "linear picture", nullptr});
            });
            return picture ? *picture : ended({}, StudyStatus::Cancelled, "stopped before it was done");
        });
    const auto picture = std::make_shared<StudyReport>();
    ItemStudy items = stabilityItems(
        task, [task, picture](const StabilityMap& map, bool whole) { return withMap(*picture, *task, map, whole); });
    if (task->picture)
        items.prepare = [task, picture](const GoOn& goOn) {
            std::optional<StudyReport> made = pictureOf(*task, goOn);
            if (made) *picture = std::move(*made);
            return made.has_value();
        };
    return items;
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

} // namespace touchdown
