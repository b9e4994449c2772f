// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_form.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/case/case_key.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/studies/runs/reading.h"

namespace touchdown {

namespace {

const std::vector<std::string> methods{"grid", "random", "latin-hypercube", "sobol"};

Calculation standardCalculation(const Case& c)
{
    return c.model == ModelKind::Film ? Calculation::Steady : Calculation::Run;
}

/// What a sweep of this case varies and reads where its file does not say.
struct Standard {
    std::string axis; // a key; empty where none suits
    std::vector<std::pair<std::string, std::string>> readings{};
};
Standard standardOf(const Case& c)
{
    switch (c.model) {
    case ModelKind::Springs:
        return {"springs.flying_height", {{"flying_height", "end"}, {"minimum_spacing", "least"}, {"motion", ""}}};
    case ModelKind::Film: return {"disk.speed", {{"minimum_spacing", ""}, {"pitch", ""}, {"roll", ""}}};
    case ModelKind::Contact: break;
    }
    return {"approach.closest", {{"largest_contact_force", ""}}};
}

/// From half to one and a half of a number, or to one in its unit where it is zero; all choices of a choice. Empty for
/// what cannot be varied so.
std::string axisOver(const Case& c, const std::string& name)
{
    const auto found = caseKey(c, name);
    const auto* key = std::get_if<Parameter>(&found);
    if (key == nullptr) return {};
    const std::string begin = "[[axis]]\nkey = " + tomlString(name) + "\n";
    if (key->kind == ParameterKind::Choice) {
        std::string values;
        for (const std::string& choice : key->choices) values += (values.empty() ? "" : ", ") + tomlString(choice);
        return begin + "values = [" + values + "]\n\n";
    }
    if (key->kind != ParameterKind::Number) return {};
    const double own = numberOf(*key, c), from = own == 0.0 ? 0.0 : 0.5 * own,
                 to = own == 0.0 ? unitFactor(key->displayUnit) : 1.5 * own;
    const auto shown = [&](double value) {
        if (value < key->minimum || (value == key->minimum && !key->minimumAllowed)) value = own;
        const double rounded = roundedIn(std::min(value, key->maximum), key->displayUnit, 3);
        return tomlString(formatQuantity(rounded, key->displayUnit));
    };
    return begin + "from = " + shown(std::min(from, to)) + "\nto = " + shown(std::max(from, to)) +
           "\ncount = " + std::to_string(standardSweepCount) + "\n\n";
}

std::string readingsOf(const Standard& standard)
{
    std::string text;
    for (const auto& [quantity, at] : standard.readings)
        text += "[[reading]]\nquantity = " + tomlString(quantity) + "\n" +
                (at.empty() ? std::string() : "at = " + tomlString(at) + "\n") + "\n";
    return text;
}

} // namespace

std::string standardSweepLists(const Case& c)
{
    const Standard standard = standardOf(c);
    return axisOver(c, standard.axis) + readingsOf(standard);
}

std::string sweepLists(const Case& c, const std::string& key) { return axisOver(c, key) + readingsOf(standardOf(c)); }

StudyForm sweepForm(const Case& c)
{
    StudyForm form;
    form.remark = "Each [[axis]] is a key of the case with its values; each [[reading]] is a column of the table.";
    form.keys = {
        choiceKey("calculate", std::string(name(standardCalculation(c))), {"run", "steady", "modes"},
                  "what is done with each case: a run in time, its static state, or the modes about that"),
        choiceKey("keep", "rows", {"rows", "all"},
                  "all: also the results of each run, in a file in the folder runs beside the report"),
        tableKey("samples", "Instead of a grid over all axes: points that are drawn, with the distribution of each "
                            "axis."),
        onlyOffered(choiceKey("samples.method", "grid", methods, "grid: every value of each axis with all others")),
        onlyOffered(integerKey("samples.count", 64, 1, mostSweepSamples, "of the points")),
        onlyOffered(choiceKey("samples.by", "items", {"items", "surface"},
                              "items: each sample is calculated; surface: a few are, and a surface of second order "
                              "through them gives all others")),
        onlyOffered(integerKey("samples.seed", 1, 0, 2147483647, "the same seed draws the same points")),
        inList(textKey("axis.key", {}, "a key of the case in quotation marks", "what changes along the axis")),
        inList(listKey("axis.keys", {}, "instead of key: several that take the same value")),
        inList(listKey("axis.values", {}, "all values; or from, to and count")),
        inList(textKey("axis.from", {}, "", "first value")),
        inList(textKey("axis.to", {}, "", "last value")),
        inList(integerKey("axis.count", standardSweepCount, 1, mostSweepValues, "of the values, both ends included")),
        inList(choiceKey("axis.spacing", sweepSpacings.front(), sweepSpacings, "distances of the values")),
        inList(choiceKey("axis.distribution", sweepDistributions.front(), sweepDistributions, "of samples")),
        inList(textKey("axis.mean", {}, "", "of a normal distribution, which from and to cut off")),
        inList(textKey("axis.deviation", {}, "", "its standard deviation")),
        inList(booleanKey("axis.average", false,
                          "the readings are averaged over this axis; of flies, caught and bounces that is the share")),
        inList(textKey("reading.quantity", {}, "a name such as \"minimum_spacing\"",
                       "what is read; `touchdown describe study.sweep.readings` lists all")),
        inList(textKey("reading.at", "end", "",
                       "of a quantity over time: end, tail (mean over the last tenth), swing, "
                       "rms, mean, least, most")),
        inList(textKey("reading.least", {}, "", "limit; the report tells the share within the limits")),
        inList(textKey("reading.most", {}, "", "limit")),
    };
    form.lists = standardSweepLists(c);
    return form;
}

} // namespace touchdown
