// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_task.h"

#include <algorithm>
#include <cmath>

#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/numerics/cvode.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int mostRepeats = 1000, mostStarts = 100000;
constexpr double longestBudget = 1e6; // [s]

constexpr double mostStepsOfRun = 1e7; // of a method's finest run
constexpr double fewestReferenceSteps = 4e6, mostReferenceSteps = 4e7;
constexpr std::size_t mostOfSeries = 13; // 1, 2, 5, 10 ..: four decades

/// 1, 2, 5 times a power of ten, from coarse to fine.
std::vector<std::string> stepSeries(double duration)
{
    const double least = duration / mostStepsOfRun * (1.0 - 1e-9);
    std::vector<std::string> series;
    for (double decade = std::pow(10.0, std::floor(std::log10(least))); decade < duration; decade *= 10.0)
        for (const double mantissa : {1.0, 2.0, 5.0})
            if (const double step = roundedTo(mantissa * decade, 1);
                step >= least && step < duration && series.size() < mostOfSeries)
                series.push_back(fewDigits(step, step < 0.999e-6 ? "ns" : "us", 1));
    std::ranges::reverse(series);
    return series;
}

std::vector<MethodSpec> springMethods(const Case& c)
{
    const std::vector<std::string> steps = stepSeries(c.run.duration);
    const std::vector<std::string> tolerances{"1e-4", "1e-5",  "1e-6",  "1e-7", "1e-8",
                                              "1e-9", "1e-10", "1e-11", "1e-12"};
    std::vector<MethodSpec> methods;
    for (const std::string integrator : {"rk4", "rk4-events", "newmark"}) {
        methods.push_back({integrator, {{"run.integrator", integrator}}, "run.step", steps, {"10 ns"}});
        if (integrator == "rk4") methods.back().ensemble.push_back("5 ns");
    }
    for (const std::string integrator : {"dopri5", "cvode"})
        if (integrator != "cvode" || haveCvode)
            methods.push_back({integrator, {{"run.integrator", integrator}}, "run.tolerance", tolerances, {"1e-8"}});
    return methods;
}

std::vector<MethodSpec> filmMethods(const Case& c, bool inTime)
{
    const std::vector<std::string> nodes = inTime
                                               ? std::vector<std::string>{"49", "97", "145", "193"}
                                               : std::vector<std::string>{"33", "49", "65", "97", "145", "193", "289"};
    const std::string ownScheme = toText(c, *findParameter("film.scheme")),
                      ownGrid = toText(c, *findParameter("film.grid"));
    std::vector<MethodSpec> methods;
    const auto add = [&](const std::string& scheme, const std::string& grid) {
        methods.push_back({scheme + ", " + grid,
                           {{"film.scheme", scheme}, {"film.grid", grid}, {"film.accuracy", "0"}},
                           "film.nodes",
                           nodes,
                           {"97"}});
    };
    for (const std::string grid : {"adapted", "graded", "uniform"}) add(ownScheme, grid);
    for (const std::string scheme : {"upwind", "power-law", "exponential", "complete-flux"})
        if (scheme != ownScheme) add(scheme, ownGrid);
    if (!inTime) {
        methods.push_back(
            {"line-multigrid", {{"film.solver", "line-multigrid"}, {"film.accuracy", "0"}}, "film.nodes", nodes, {}});
        return methods;
    }
    const std::vector<std::string> errors{"0.5 nm", "0.05 nm", "0.005 nm", "0.0005 nm"};
    for (const std::string coupling : {"monolithic", "staggered"})
        methods.push_back({coupling, {{"film.coupling", coupling}}, "run.step_error", errors, {"0.005 nm"}});
    return methods;
}

int nodesOfFinest(const std::vector<SweptMethod>& methods)
{
    int most = 17;
    for (const SweptMethod& method : methods)
        for (const MethodSetting& setting : method.settings)
            most = std::max({most, setting.c.film.nodes[0], setting.c.film.nodes[1]});
    return most;
}

template <class Get>
double leastOf(const std::vector<SweptMethod>& methods, double least, Get get)
{
    for (const SweptMethod& method : methods)
        for (const MethodSetting& setting : method.settings) least = std::min(least, get(setting.c));
    return least;
}

/// Finer than any fixed step of the methods, within some bounds.
double referenceStep(const Case& c, const std::vector<SweptMethod>& methods)
{
    const double finest = leastOf(methods, 2.0 * c.run.duration / fewestReferenceSteps, [](const Case& each) {
        const IntegratorKind kind = each.run.integrator;
        return hasFixedStep(kind) ? each.run.step : each.run.duration;
    });
    return std::max(0.5 * finest, c.run.duration / mostReferenceSteps);
}

/// Springs: every integrator over four decades of steps, whose finest takes up to ten million of them, or eight of
/// tolerances. Film: grids and schemes over the number of nodes; in time also the step error, with both couplings; in a
/// static state also the solvers.
std::vector<MethodSpec> defaultMethods(const Case& c, bool inTime)
{
    if (c.model == ModelKind::Springs) return springMethods(c);
    return c.model == ModelKind::Film ? filmMethods(c, inTime) : std::vector<MethodSpec>{};
}

/// Finer than any setting of the methods. Springs: rk4-events at half of the finest step, with four to forty million of
/// them. Film: grids with half as many nodes more than the finest, in time with a quarter of the smallest step error.
std::vector<ReferenceCase> defaultReferences(const Case& c, bool inTime, const std::vector<SweptMethod>& methods)
{
    if (c.model == ModelKind::Springs) return springReferences(c, referenceStep(c, methods));
    if (c.model != ModelKind::Film) return {};
    const int cells = nodesOfFinest(methods) - 1;
    const int nodes = std::min(2049, std::max(cells / 16 + 1, cells * 3 / 2 / 16) * 16 + 1);
    if (!inTime) return gridReferences(c, nodes, {});
    return gridReferences(
        c, nodes, 0.25 * leastOf(methods, c.run.stepError, [](const Case& each) { return each.run.stepError; }));
}

/// Those of which errors can be.
std::vector<Quantity> quantitiesOf(const PrecisionTask& task)
{
    if (task.inTime) return recordedQuantities(task.start);
    std::vector<Quantity> all;
    for (const SteadyQuantity& each : steadyQuantities({})) all.push_back(each.quantity);
    return all;
}

/// What costs time beside a static state.
void leaveOut(Case& c)
{
    c.steady.stiffness = c.steady.sensitivities = c.steady.allEquilibria = false;
    for (std::vector<double>* series : {&c.steady.radii, &c.steady.skews, &c.steady.speeds, &c.steady.altitudes})
        series->clear();
}

std::vector<std::string> namesOf(const std::vector<Quantity>& quantities)
{
    std::vector<std::string> names;
    for (const Quantity& quantity : quantities) names.push_back(quantity.name);
    return names;
}

std::string defaultQuantity(const PrecisionTask& task)
{
    if (task.start.model == ModelKind::Contact) return "contact_force";
    return task.inTime ? std::string(spacingOf(task.start)) : "minimum_spacing";
}

void readQuantity(StudyReader& reader, PrecisionTask& task)
{
    const std::vector<Quantity> all = quantitiesOf(task);
    const std::string name = reader.choice("quantity", namesOf(all)).value_or(defaultQuantity(task));
    const auto find = [&](const std::string& wanted) { return std::ranges::find(all, wanted, &Quantity::name); };
    if (find(name) == all.end()) return; // the case has problems of its own
    task.quantity = *find(name);
    for (const char* also : {"pitch", "net_force"})
        if (name != also && find(also) != all.end()) task.also.push_back(*find(also));
}

std::vector<std::string> measureNames()
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < errorMeasures; ++i) names.emplace_back(name(static_cast<ErrorMeasure>(i)));
    return names;
}

void readMeasure(StudyReader& reader, PrecisionTask& task)
{
    const std::vector<std::string> names = measureNames();
    task.measure = static_cast<ErrorMeasure>(std::ranges::find(names, reader.choice("error")) - names.begin());
}

void readTimes(StudyReader& reader, PrecisionTask& task)
{
    task.repeats = reader.integer("repeats");
    task.timeLimit = reader.number("time_limit");
    task.budget = reader.number("budget");
    const Quantity& q = task.quantity;
    if (const auto bound = reader.number("agreement", q.unit, q.displayUnit, 1e-24, INFINITY))
        task.agreement = *bound;
    else if (q.unit != "m")
        task.agreement = INFINITY; // of what is no length there is no natural one
}

void readMethods(StudyReader& reader, PrecisionTask& task)
{
    std::vector<MethodSpec> specs = readMethods(reader, true);
    const bool own = specs.empty();
    if (own) specs = defaultMethods(task.start, task.inTime);
    const auto methodTable = [](std::size_t i) { return "method[" + std::to_string(i + 1) + ']'; };
    for (std::size_t i = 0; i < specs.size(); ++i) {
        SweptMethod method;
        const std::optional<InputProblem> problem = makeMethod(task.start, specs[i], method);
        // A default method that this case does not allow is left out.
        if (!problem)
            task.methods.push_back(std::move(method));
        else if (!own)
            reader.addOfSettings(methodTable(i), {methodTable(i) + ".set"}, *problem);
    }
    const auto chosen = [](const SweptMethod& method) {
        return std::ranges::any_of(method.settings, &MethodSetting::chosen);
    };
    if (!task.methods.empty() && std::ranges::none_of(task.methods, chosen))
        task.methods.push_back({.name = "the case as it is",
                                .settings = {{.label = "", .c = task.start, .chosen = true, .inEnsemble = true}}});
}

void readReferences(StudyReader& reader, PrecisionTask& task)
{
    const std::vector<std::string> tables = reader.tables("reference");
    for (const std::string& table : tables) {
        ReferenceCase reference{reader.text(table + ".name").value_or(table), task.start};
        if (reference.label.empty()) reader.add(table + ".name", "must not be empty");
        if (const auto problem = changeCase(reference.c, reader.settings(table + ".set"), reader.outsidePaths()))
            reader.addOfSettings(table, {table + ".set"}, *problem);
        task.references.push_back(std::move(reference));
    }
    if (tables.empty()) task.references = defaultReferences(task.start, task.inTime, task.methods);
    if (!tables.empty() && tables.size() < 2)
        reader.add("reference", "two or more are needed, of which one proves the other; list them as [[reference]]");
}

void readEnsemble(StudyReader& reader, PrecisionTask& task)
{
    task.ensembleWanted = reader.has("ensemble");
    EnsembleTask& ensemble = task.ensemble;
    ensemble.key = defaultEnsembleKey(task.start);
    if (const auto starts = reader.integer("ensemble.starts", 2, mostStarts)) ensemble.starts = *starts;
    if (const auto seed = reader.integer("ensemble.seed", 0, mostSeed)) ensemble.seed = *seed;
    if (const auto key = reader.text("ensemble.key")) {
        const Parameter* parameter = findParameter(*key);
        if (parameter == nullptr || parameter->kind != ParameterKind::Number) {
            reader.add("ensemble.key", inQuotes(*key) + " is no key of a number" + didYouMean(nearestKey(*key)));
        } else if (const std::string unused = unusedMessage(task.start, *parameter); !unused.empty()) {
            reader.add("ensemble.key", inQuotes(*key) + " " + unused);
        } else {
            ensemble.key = *key;
        }
    }
    const Parameter& parameter = *findParameter(ensemble.key);
    if (parameter.unit != "m") ensemble.spread = 0.01 * std::abs(std::get<double>(parameter.get(task.start)));
    if (const auto spread = reader.number("ensemble.spread", parameter.unit, parameter.displayUnit, 0.0, INFINITY))
        ensemble.spread = *spread;
    const std::vector<CaseSetting> settings = reader.settings("ensemble.set");
    task.ensembleReference = ensembleReference(task.start);
    if (settings.empty()) return;
    task.ensembleReference = {"", task.start};
    for (const CaseSetting& setting : settings)
        task.ensembleReference.label += (task.ensembleReference.label.empty() ? "" : ", ") + setting.value;
    if (const auto problem = changeCase(task.ensembleReference.c, settings, reader.outsidePaths()))
        reader.addOfSettings("ensemble.set", {"ensemble.set"}, *problem);
}

} // namespace

StudyForm workPrecisionForm(const Case& c)
{
    const bool film = c.model == ModelKind::Film, springs = c.model == ModelKind::Springs;
    PrecisionTask task;
    task.start = c;
    StudyForm form;
    form.keys = {
        choiceKey("of", "run", {"run", "static"}, "the motion in time or the static state"),
        choiceKey("quantity", defaultQuantity(task), namesOf(quantitiesOf(task)), "quantity whose errors are measured"),
        choiceKey("error", "worst", measureNames(), "error in the chart"),
        integerKey("repeats", springs ? 5 : 3, 1, mostRepeats, "timed repeats of a run, after one that warms up"),
        numberKey("time_limit", springs ? 0.1 : 1.0, "s", "s", 0.0, longestBudget,
                  "runs that take longer are timed once"),
        numberKey("budget", springs ? 15.0 : 120.0, "s", "s", 0.01, longestBudget,
                  "wall time; runs that have not begun by then are left out"),
        numberKey("agreement", task.agreement, "m", "nm", 1e-24, INFINITY,
                  "largest distance between two references that agree"),
    };
    if (!film) form.keys[0].standard = {};
    if (c.model == ModelKind::Contact) form.keys.back().standard = {};
    for (StudyKey& key : methodKeys(true)) form.keys.push_back(std::move(key));
    form.keys.push_back(inList(textKey("reference.name", {}, "", "name in the findings")));
    form.keys.push_back(inList(settingsKey("reference.set", "changes of the case")));
    if (c.model == ModelKind::Contact) return form;
    form.lists = "\n# Each method takes one key from coarse to fine; without any method, these are taken.\n";
    for (const MethodSpec& spec : defaultMethods(c, true)) form.lists += methodText(spec);
    for (StudyKey key : {
             tableKey("ensemble", "Without this table ensembles are made only where the trajectory is not determined."),
             integerKey("ensemble.starts", task.ensemble.starts, 2, mostStarts, "number of runs"),
             integerKey("ensemble.seed", task.ensemble.seed, 0, mostSeed, "of the random starts"),
             numberKey("ensemble.spread", task.ensemble.spread, "m", "nm", 0.0, INFINITY,
                       "the starts are drawn at random between this much below and above the start of the case"),
             textKey("ensemble.key", defaultEnsembleKey(c), "", "key of the case that differs between the starts"),
             settingsKey("ensemble.set", "changes of the case for the reference ensemble"),
         })
        form.keys.push_back(onlyOffered(std::move(key)));
    return form;
}

PrecisionTask readPrecisionTask(StudyReader& reader)
{
    PrecisionTask task;
    task.start = reader.start();
    leaveOut(task.start);
    task.inTime = reader.choice("of", {"run", "static"}).value_or("run") == "run";
    if (!task.inTime && task.start.model != ModelKind::Film)
        reader.add("of", "\"static\" is for cases of model \"film\"");
    if (task.start.model == ModelKind::Contact &&
        (reader.tables("method").empty() || reader.tables("reference").empty()))
        reader.add("case", "is of model \"contact\", for which this study knows neither methods nor references: list "
                           "them as [[method]] and [[reference]], or let "
                           "\"touchdown study convergence\" refine its cells");
    else if (const std::string reason = task.inTime ? reasonNotToRun(task.start) : std::string(); !reason.empty())
        reader.add("case", reason);
    readQuantity(reader, task);
    readMeasure(reader, task);
    readTimes(reader, task);
    readMethods(reader, task);
    readReferences(reader, task);
    readEnsemble(reader, task);
    if (!task.inTime && task.ensembleWanted) reader.add("ensemble", "needs runs in time (of = \"run\")");
    return task;
}

} // namespace touchdown
