// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision_methods.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numerics/cvode.h"
#include "core/simulation/fields.h"
#include "core/simulation/units.h"

namespace touchdown {

namespace {

constexpr double mostSteps = 1e7;          // of a method's finest run
constexpr double fewestReferenceSteps = 4e6, mostReferenceSteps = 4e7;
constexpr int stepsBelow = 12;             // 1, 2, 5, 10 ..: four decades

std::string secondsText(double seconds) { return formatQuantity(seconds, seconds < 0.999e-6 ? "ns" : "us"); }

/// 1, 2, 5 times a power of ten, from coarse to fine.
std::vector<std::string> stepSeries(double duration)
{
    constexpr std::array<double, 3> mantissas{1.0, 2.0, 5.0};
    const double least = duration / mostSteps * (1.0 - 1e-9);
    int exponent = static_cast<int>(std::floor(std::log10(least)));
    std::size_t m = 0;
    const auto value = [&](int step) {
        const int place = static_cast<int>(m) + step;
        // As decimal text, so that a step is the number that a person would write.
        return std::stod(std::to_string(static_cast<int>(mantissas[static_cast<std::size_t>(place % 3)])) + "e" +
                         std::to_string(exponent + place / 3));
    };
    while (value(0) < least) {
        exponent += m == 2;
        m = (m + 1) % 3;
    }
    std::vector<std::string> series;
    for (int step = stepsBelow; step >= 0; --step)
        if (const double length = value(step); length < duration) series.push_back(secondsText(length));
    return series;
}

std::vector<MethodSpec> springMethods(const Case& c)
{
    const std::vector<std::string> steps = stepSeries(c.run.duration);
    const std::vector<std::string> tolerances{"1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10", "1e-11", "1e-12"};
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
    const std::vector<std::string> nodes = inTime ? std::vector<std::string>{"49", "97", "145", "193"}
                                                  : std::vector<std::string>{"33", "49", "65", "97", "145", "193", "289"};
    const std::string ownScheme = toText(c, *findField("film.scheme")), ownGrid = toText(c, *findField("film.grid"));
    std::vector<MethodSpec> methods;
    const auto add = [&](const std::string& scheme, const std::string& grid) {
        methods.push_back({scheme + ", " + grid, {{"film.scheme", scheme}, {"film.grid", grid}}, "film.nodes", nodes, {"97"}});
    };
    for (const std::string grid : {"adapted", "graded", "uniform"}) add(ownScheme, grid);
    for (const std::string scheme : {"upwind", "power-law", "exponential", "complete-flux"})
        if (scheme != ownScheme) add(scheme, ownGrid);
    if (!inTime) {
        methods.push_back({"line-multigrid", {{"film.solver", "line-multigrid"}}, "film.nodes", nodes, {}});
        return methods;
    }
    const std::vector<std::string> errors{"0.5 nm", "0.05 nm", "0.005 nm", "0.0005 nm"};
    for (const std::string coupling : {"monolithic", "staggered"})
        methods.push_back({coupling, {{"film.coupling", coupling}}, "run.step_error", errors, {"0.005 nm"}});
    return methods;
}

/// "97, 97" of "97" for a list of two.
std::string fullValue(const Field& field, const std::string& value)
{
    if (field.kind != FieldKind::List || field.minimumCount < 2 || field.minimumCount != field.maximumCount) return value;
    if (listElements(value).size() != 1) return value;
    std::string list = value;
    for (std::size_t i = 1; i < field.minimumCount; ++i) list += ", " + value;
    return list;
}

/// "97" of "97, 97".
std::string shortLabel(const Field& field, const std::string& value)
{
    if (field.kind != FieldKind::List) return value;
    const std::vector<std::string_view> elements = listElements(value);
    const bool alike = std::ranges::all_of(elements, [&](std::string_view each) { return each == elements.front(); });
    return elements.empty() || !alike ? value : std::string(elements.front());
}

/// A number by which settings of one key are in order.
double rankOf(const Field& field, const Case& c)
{
    const FieldValue value = field.get(c);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* whole = std::get_if<int>(&value)) return *whole;
    if (const auto* list = std::get_if<std::vector<double>>(&value); list != nullptr && !list->empty()) return list->front();
    return 0.0;
}

/// Puts the case's own value where it belongs among the others.
void insertOwn(const Field& field, PrecisionSetting own, std::vector<PrecisionSetting>& settings)
{
    const bool falling = settings.size() > 1 && rankOf(field, settings.front().c) > rankOf(field, settings.back().c);
    const double rank = rankOf(field, own.c);
    const auto place = std::ranges::find_if(settings, [&](const PrecisionSetting& each) {
        return falling ? rankOf(field, each.c) < rank : rankOf(field, each.c) > rank;
    });
    settings.insert(place, std::move(own));
}

/// Settings that would make runs which cannot be compared.
std::string problemOfKey(const std::string& key)
{
    for (const char* fixed : {"model", "run.duration", "run.sample_interval"})
        if (key == fixed) return key + ": must be the same for all methods; set it for the case";
    return {};
}

/// Applies and says where a setting would have no effect.
std::string apply(Case& c, const std::vector<CaseSetting>& settings)
{
    for (const CaseSetting& setting : settings)
        if (std::string problem = problemOfKey(setting.key); !problem.empty()) return problem;
    if (std::string problem = applySettings(c, settings); !problem.empty()) return problem;
    for (const CaseSetting& setting : settings)
        if (const std::string message = unusedMessage(c, *findField(setting.key)); !message.empty())
            return setting.key + ": " + message;
    return {};
}

int nodesOfFinest(const std::vector<PrecisionMethod>& methods)
{
    int most = 17;
    for (const PrecisionMethod& method : methods)
        for (const PrecisionSetting& setting : method.settings)
            most = std::max({most, setting.c.film.nodes[0], setting.c.film.nodes[1]});
    return most;
}

template <class Get>
double leastOf(const std::vector<PrecisionMethod>& methods, double least, Get get)
{
    for (const PrecisionMethod& method : methods)
        for (const PrecisionSetting& setting : method.settings) least = std::min(least, get(setting.c));
    return least;
}

std::vector<PrecisionReference> springReferences(const Case& c, const std::vector<PrecisionMethod>& methods)
{
    const auto family = [&](const std::string& integrator, const std::string& key, const std::string& value) {
        PrecisionReference reference{integrator + ", " + value, c};
        applySettings(reference.c, {{"run.integrator", integrator}, {key, value}});
        return reference;
    };
    const double finest = leastOf(methods, 2.0 * c.run.duration / fewestReferenceSteps, [](const Case& each) {
        const IntegratorKind kind = each.run.integrator;
        return kind == IntegratorKind::Dopri5 || kind == IntegratorKind::Cvode ? each.run.duration : each.run.step;
    });
    const double step = std::max(0.5 * finest, c.run.duration / mostReferenceSteps);
    std::vector<PrecisionReference> families{family("dopri5", "run.tolerance", "1e-14"),
                                             family("rk4-events", "run.step", secondsText(step))};
    if (haveCvode) families.push_back(family("cvode", "run.tolerance", "1e-13"));
    return families;
}

std::vector<PrecisionReference> filmReferences(const Case& c, bool inTime, const std::vector<PrecisionMethod>& methods)
{
    const int nodes = std::min(2049, (nodesOfFinest(methods) - 1) * 3 / 2 / 16 * 16 + 1);
    const double stepError = 0.25 * leastOf(methods, c.run.stepError, [](const Case& each) { return each.run.stepError; });
    std::vector<PrecisionReference> families;
    for (const GridKind grid : {GridKind::Adapted, GridKind::Graded}) {
        PrecisionReference& reference = families.emplace_back();
        reference.label = std::string(grid == GridKind::Adapted ? "adapted" : "graded") + " grid of " + std::to_string(nodes) + " nodes";
        reference.c = c;
        reference.c.film.grid = grid;
        reference.c.film.nodes = {nodes, nodes};
        reference.c.film.scheme = ConvectionScheme::CompleteFlux;
        reference.c.film.solver = FilmSolver::Newton;
        reference.c.film.coupling = FilmCoupling::Monolithic;
        if (!inTime) continue;
        reference.c.run.steps = StepControl::Adaptive;
        reference.c.run.stepError = std::max(1e-18, stepError);
        reference.label += ", step error " + formatQuantity(reference.c.run.stepError, "nm");
    }
    return families;
}

} // namespace

std::vector<MethodSpec> defaultMethods(const Case& c, bool inTime)
{
    if (c.model == ModelKind::Springs) return springMethods(c);
    return c.model == ModelKind::Film ? filmMethods(c, inTime) : std::vector<MethodSpec>{};
}

std::string makeMethod(const Case& start, const MethodSpec& spec, PrecisionMethod& method, bool addOwn)
{
    method = {.name = spec.name, .key = spec.key};
    Case base = start;
    if (std::string problem = apply(base, spec.set); !problem.empty()) return problem;
    const bool own = std::ranges::all_of(spec.set, [&](const CaseSetting& setting) {
        const Field& field = *findField(setting.key);
        return toText(base, field) == toText(start, field);
    });
    if (spec.key.empty()) {
        method.settings.push_back({"", base, own, true});
        return {};
    }
    const Field* field = findField(spec.key);
    if (field == nullptr) return apply(base, {{spec.key, ""}}); // which says what is wrong with the key
    method.ordered = field->kind == FieldKind::Number || field->kind == FieldKind::Integer || field->kind == FieldKind::List;
    bool found = false;
    for (const std::string& value : spec.values) {
        PrecisionSetting setting{.label = value, .c = base};
        const std::string full = fullValue(*field, value);
        if (std::string problem = apply(setting.c, {{spec.key, full}}); !problem.empty()) return problem;
        setting.label = shortLabel(*field, value);
        setting.chosen = own && toText(setting.c, *field) == toText(start, *field);
        setting.inEnsemble = spec.ensemble.empty() || std::ranges::find(spec.ensemble, value) != spec.ensemble.end();
        found = found || setting.chosen;
        method.settings.push_back(std::move(setting));
    }
    if (addOwn && own && !found) insertOwn(*field, {shortLabel(*field, toText(start, *field)), base, true, true}, method.settings);
    return {};
}

std::vector<PrecisionReference> defaultReferences(const Case& c, bool inTime, const std::vector<PrecisionMethod>& methods)
{
    if (c.model == ModelKind::Springs) return springReferences(c, methods);
    return c.model == ModelKind::Film ? filmReferences(c, inTime, methods) : std::vector<PrecisionReference>{};
}

PrecisionReference defaultEnsembleReference(const Case& c)
{
    PrecisionReference reference{"", c};
    if (c.model == ModelKind::Springs) {
        applySettings(reference.c, {{"run.integrator", "dopri5"}, {"run.tolerance", "1e-12"}});
        reference.label = "dopri5, 1e-12";
    } else {
        reference.c.run.steps = StepControl::Adaptive;
        reference.c.run.stepError = std::max(1e-18, 0.1 * c.run.stepError);
        reference.label = "step error " + formatQuantity(reference.c.run.stepError, "nm");
    }
    return reference;
}

} // namespace touchdown
