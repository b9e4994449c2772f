// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design_task.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int mostIterations = 1000;
constexpr const char* neededKey = "a key of the case in quotation marks";
constexpr const char* neededQuantity = "a quantity such as \"minimum_spacing\"";
constexpr double smallestDifference = 1e-6, largestDifference = 0.25;

/// The quantities that may be wanted; an error of the grid is none.
std::vector<Quantity> wantedQuantities()
{
    std::vector<Quantity> list;
    for (const SteadyQuantity& each : steadyQuantities({}))
        if (!each.quantity.name.ends_with("_error")) list.push_back(each.quantity);
    return list;
}

/// Where a study names neither a parameter nor a target: the preload with which the slider flies at its initial height;
/// where the attitude is held, the height at which the film carries the preload. Nothing for a case that is refused.
DesignTask defaultTask(const Case& c)
{
    DesignTask task;
    const double height = c.initial.nominalTrailingEdgeHeight > 0.0 ? c.initial.nominalTrailingEdgeHeight : 10e-9;
    const double load = c.suspension.preload > 0.0 ? c.suspension.preload : 10e-3;
    const bool held = c.steady.fixedAttitude;
    const auto key = numberKey(c, held ? "initial.nominal_trailing_edge_height" : "suspension.preload");
    if (!reasonNotToDesign(c).empty() || !std::holds_alternative<Parameter>(key)) return task;
    const double middle = held ? height : load, wanted = held ? load : height;
    const Parameter& moved = std::get<Parameter>(key);
    const std::vector<Quantity> all = wantedQuantities();
    const Quantity& aim = all[static_cast<std::size_t>(findQuantity(all, held ? "net_force" : "minimum_spacing"))];
    task.parameters = {{.keys = {moved},
                        .start = middle,
                        .minimum = roundedIn(0.2 * middle, moved.displayUnit, 2),
                        .maximum = roundedIn(5.0 * middle, moved.displayUnit, 2)}};
    task.targets = {{aim, roundedIn(wanted, aim.displayUnit, 2), roundedIn(0.01 * wanted, aim.displayUnit, 2)}};
    return task;
}

class DesignReader {
public:
    explicit DesignReader(StudyReader& reader) : reader_(reader), start_(reader.start()) {}

    DesignTask read()
    {
        task_.maximumIterations = reader_.integer("search.iterations");
        task_.difference = reader_.number("search.difference");
        if (const std::string reason = reasonNotToDesign(start_); !reason.empty()) reader_.add("case", reason);
        const std::vector<std::string> parameters = tables("parameter", mostParameters);
        const std::vector<std::string> targets = tables("target", mostTargets);
        if (!reader_.has("parameter") && !reader_.has("target")) {
            DesignTask standard = defaultTask(start_);
            task_.parameters = std::move(standard.parameters);
            task_.targets = std::move(standard.targets);
            return std::move(task_);
        }
        for (const char* kind : {"parameter", "target"})
            if (!reader_.has(kind)) reader_.add(kind, std::string("is missing; write one [[") + kind + "]] or more");
        readParameters(parameters);
        readTargets(targets);
        return std::move(task_);
    }

private:
    /// A missing one is a problem.
    std::optional<std::string> text(const std::string& key, const std::string& needed)
    {
        if (!reader_.has(key)) reader_.add(key, "is missing; " + needed + " is needed");
        return reader_.text(key, needed);
    }

    /// The same, unless there is a number to stand for it.
    std::optional<double> number(const std::string& key, const std::string& unit, const std::string& displayUnit,
                                 std::optional<double> otherwise = {})
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (reader_.has(key)) return reader_.number(key, unit, displayUnit, -infinity, infinity);
        if (!otherwise) reader_.add(key, "is missing");
        return otherwise;
    }

    /// None where there are too many.
    std::vector<std::string> tables(const std::string& kind, std::size_t most)
    {
        std::vector<std::string> list = reader_.tables(kind);
        if (list.size() <= most) return list;
        reader_.add(list[most], "is one too many of " + std::to_string(list.size()) + "; at most " +
                                    std::to_string(most) + " are possible");
        return {};
    }

    std::vector<std::string> keysOf(const std::string& table)
    {
        const std::string one = table + ".key", several = table + ".keys";
        if (!reader_.has(several)) {
            const auto key = text(one, neededKey);
            return key ? std::vector{*key} : std::vector<std::string>{};
        }
        if (reader_.has(one)) {
            reader_.add(one, "is one key, and keys are several; write one of the two");
            return {};
        }
        return reader_.texts(several, "a list such as [\"abs.rail[1].recess\", \"abs.rail[3].recess\"]")
            .value_or(std::vector<std::string>{});
    }

    void readParameters(const std::vector<std::string>& list)
    {
        std::set<std::string> names;
        for (const std::string& table : list) {
            bool good = true;
            const auto refuse = [&](const std::string& at, const std::string& message) {
                reader_.add(at, message);
                good = false;
            };
            DesignParameter parameter;
            for (const std::string& name : keysOf(table)) {
                auto key = numberKey(start_, name);
                const std::string at = table + (reader_.has(table + ".keys") ? ".keys" : ".key");
                if (!names.insert(name).second)
                    refuse(at, inQuotes(name) + " is changed by more than one parameter");
                else if (const auto* problem = std::get_if<std::string>(&key))
                    refuse(at, inQuotes(name) + ' ' + *problem);
                else if (parameter.keys.push_back(std::get<Parameter>(key));
                         parameter.keys.back().unit != parameter.keys.front().unit)
                    refuse(at, inQuotes(name) + " has another unit than the first key");
            }
            if (good && !parameter.keys.empty() && readBounds(table, parameter))
                task_.parameters.push_back(std::move(parameter));
        }
    }

    bool readBounds(const std::string& table, DesignParameter& parameter)
    {
        const Parameter& first = parameter.keys.front();
        const double own = numberOf(first, start_);
        const auto value = [&](const char* name, std::optional<double> otherwise = {}) {
            return number(table + '.' + name, first.unit, first.displayUnit, otherwise);
        };
        const auto minimum = value("minimum"), maximum = value("maximum"), start = value("start", own);
        if (!minimum || !maximum || !start) return false;
        parameter.minimum = *minimum;
        parameter.maximum = *maximum;
        parameter.start = *start;
        // Twelve digits: differences of lengths carry the rounding of their ends.
        const auto shown = [&](double number) { return formatQuantity(roundedTo(number, 12), first.displayUnit); };
        const auto refuse = [&](const char* name, const std::string& message) {
            reader_.add(table + '.' + name, message);
            return false;
        };
        if (!(*minimum < *maximum)) return refuse("maximum", "must be greater than minimum (" + shown(*minimum) + ")");
        if (*start < *minimum || *start > *maximum)
            return refuse("start", shown(*start) + " is not between minimum (" + shown(*minimum) + ") and maximum (" +
                                       shown(*maximum) + ")");
        for (const auto& [name, bound] : {std::pair{"minimum", *minimum}, std::pair{"maximum", *maximum}}) {
            Case tried = start_;
            for (const Parameter& key : parameter.keys)
                if (const auto problem = setFromNumber(tried, key, numberOf(key, tried) + bound - own))
                    return refuse(name, key.key + ": " + *problem);
        }
        return true;
    }

    void readTargets(const std::vector<std::string>& list)
    {
        const std::vector<Quantity> quantities = wantedQuantities();
        std::vector<std::string> names;
        for (const Quantity& quantity : quantities) names.push_back(quantity.name);
        for (const std::string& table : list) {
            const auto name = text(table + ".quantity", neededQuantity);
            if (!name) continue;
            const int index = findQuantity(quantities, *name);
            if (index < 0) {
                reader_.add(table + ".quantity", inQuotes(*name) + " is no quantity of a static state" +
                                                     didYouMean(nearestName(*name, names)));
                continue;
            }
            const Quantity& quantity = quantities[static_cast<std::size_t>(index)];
            const auto value = number(table + ".value", quantity.unit, quantity.displayUnit);
            const auto tolerance = number(table + ".tolerance", quantity.unit, quantity.displayUnit);
            if (tolerance && !(*tolerance > 0.0))
                reader_.add(table + ".tolerance", "must be greater than 0");
            else if (value && tolerance)
                task_.targets.push_back({quantity, *value, *tolerance});
        }
    }

    StudyReader& reader_;
    const Case& start_;
    DesignTask task_;
};

/// The tables of a task, with remarks for who changes them.
std::string tablesText(const DesignTask& task)
{
    std::string text;
    const auto line = [&](const char* key, const std::string& value, const std::string& remark = "") {
        text += std::string(key) + " = " + tomlString(value) + remark + "\n";
    };
    for (const DesignParameter& parameter : task.parameters) {
        const Parameter& key = parameter.keys.front();
        text += "\n[[parameter]] # one or more\n";
        line("key", key.key, " # of the case or of a rail, such as abs.rail[1].width");
        line("minimum", formatQuantity(parameter.minimum, key.displayUnit));
        line("maximum", formatQuantity(parameter.maximum, key.displayUnit));
    }
    for (const DesignTarget& target : task.targets) {
        text += "\n[[target]] # one or more\n";
        line("quantity", target.quantity.name, " # of the static state, such as pitch, roll or net_force");
        line("value", formatQuantity(target.value, target.quantity.displayUnit));
        line("tolerance", formatQuantity(target.tolerance, target.quantity.displayUnit));
    }
    return text;
}

} // namespace

DesignTask readDesignTask(StudyReader& reader) { return DesignReader(reader).read(); }

StudyForm designForm(const Case& c)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const DesignTask task;
    StudyForm form;
    const auto row = [&](StudyKey key) { form.keys.push_back(inList(std::move(key))); };
    const auto number = [&](const char* key, const char* help) {
        row(numberKey(key, {}, "", "", -infinity, infinity, help));
    };
    row(textKey("parameter.key", {}, neededKey,
                "the number that is searched, of the case or of its surface, such as abs.rail[1].width"));
    row(listKey("parameter.keys", {}, "several keys instead of one; all change by the same amount"));
    number("parameter.start", "default: the value of the case");
    number("parameter.minimum", "lower bound");
    number("parameter.maximum", "upper bound");
    StudyKey quantity = textKey("target.quantity", {}, neededQuantity, "number of the static state");
    for (const Quantity& each : wantedQuantities()) quantity.choices.push_back(each.name);
    row(std::move(quantity));
    number("target.value", "the wanted value");
    number("target.tolerance", "largest distance from it, greater than 0");
    for (StudyKey key : {tableKey("search", "The search itself."),
                         integerKey("search.iterations", task.maximumIterations, 1, mostIterations, "at most"),
                         numberKey("search.difference", task.difference, "", "", smallestDifference, largestDifference,
                                   "for the slopes, as a share of the range of a parameter")})
        form.keys.push_back(onlyOffered(std::move(key)));
    form.lists = tablesText(defaultTask(c));
    return form;
}

} // namespace touchdown
