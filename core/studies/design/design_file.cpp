// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/formats/decimal.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study/study_head.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int mostIterations = 1000;
constexpr double smallestDifference = 1e-6, largestDifference = 0.25;

/// The quantities that may be wanted; an error of the grid is none.
std::vector<Quantity> wantedQuantities()
{
    std::vector<Quantity> list;
    for (const SteadyQuantity& each : steadyQuantities({}))
        if (!each.quantity.name.ends_with("_error")) list.push_back(each.quantity);
    return list;
}

/// Twelve digits: differences of lengths carry the rounding of their ends.
double withoutNoise(double value)
{
    if (value == 0.0) return value;
    const double scale = std::pow(10.0, 11.0 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

bool isSampleCase(const std::string& name)
{
    return std::ranges::any_of(sampleCases(), [&](const SampleCase& each) { return each.name == name; });
}

class DesignReader {
public:
    DesignReader(DesignDocument& document, const TomlDocument& toml)
        : document_(document), reader_(toml, document.name, document.start.value, document.problems)
    {}

    void read(const std::filesystem::path& folder, const std::vector<std::string>& settings)
    {
        document_.title = reader_.text("title").value_or("");
        if (!isOfKind(reader_, "design")) return;
        readSearch();
        openStart(folder, settings);
        readParameters(document_.valid());
        readTargets();
        reader_.finish();
        std::ranges::stable_sort(document_.problems, {}, &InputProblem::line);
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

    void readSearch()
    {
        DesignTask& task = document_.task;
        task.maximumIterations =
            reader_.integer("search.iterations", 1, mostIterations).value_or(task.maximumIterations);
        task.difference = reader_.number("search.difference", "", "", smallestDifference, largestDifference)
                              .value_or(task.difference);
    }

    void openStart(const std::filesystem::path& folder, const std::vector<std::string>& settings)
    {
        auto start = openStudyCase(reader_, folder, settings);
        if (!start) return;
        document_.start = std::move(*start);
        for (const InputProblem& problem : document_.start.problems) document_.problems.push_back(problem);
        if (!document_.start.valid()) return;
        if (const std::string reason = reasonNotToDesign(document_.start.value); !reason.empty())
            reader_.add("case", document_.start.name + ": " + reason);
    }

    std::vector<std::string> tables(const std::string& kind, std::size_t most)
    {
        std::vector<std::string> list = reader_.tables(kind);
        if (list.empty() && !reader_.has(kind))
            reader_.add(kind, "a study needs one or more; write [[" + kind + "]] for each");
        if (list.size() <= most) return list;
        reader_.add(list[most],
                    std::to_string(list.size()) + " are too many; at most " + std::to_string(most) + " are possible");
        return {};
    }

    std::vector<std::string> keysOf(const std::string& table)
    {
        const std::string one = table + ".key", several = table + ".keys";
        if (!reader_.has(several)) {
            const auto key = text(one, "a key of the case in quotation marks");
            return key ? std::vector{*key} : std::vector<std::string>{};
        }
        if (reader_.has(one)) {
            reader_.add(one, "is one key, and keys are several; write one of the two");
            return {};
        }
        return reader_.texts(several, "a list such as [\"abs.rail[1].recess\", \"abs.rail[3].recess\"]")
            .value_or(std::vector<std::string>{});
    }

    /// What they may be depends on the case.
    void readParameters(bool caseIsGood)
    {
        std::set<std::string> keys;
        for (const std::string& table : tables("parameter", mostParameters)) {
            reader_.allow(table, {"key", "keys", "start", "minimum", "maximum"});
            if (!caseIsGood) continue;
            const std::size_t before = document_.problems.size();
            DesignParameter parameter;
            for (const std::string& name : keysOf(table)) {
                auto key = designKey(document_.start.value, name);
                const std::string at = table + (reader_.has(table + ".keys") ? ".keys" : ".key");
                if (!keys.insert(name).second)
                    reader_.add(at, inQuotes(name) + " is changed by more than one parameter");
                else if (const auto* problem = std::get_if<std::string>(&key))
                    reader_.add(at, inQuotes(name) + ' ' + *problem);
                else if (parameter.keys.push_back(std::get<DesignKey>(key));
                         parameter.keys.back().unit != parameter.keys.front().unit)
                    reader_.add(at, inQuotes(name) + " is measured otherwise than the first key");
            }
            if (document_.problems.size() != before) continue;
            readBounds(table, parameter);
            if (document_.problems.size() == before) document_.task.parameters.push_back(std::move(parameter));
        }
    }

    void readBounds(const std::string& table, DesignParameter& parameter)
    {
        const DesignKey& first = parameter.keys.front();
        const auto value = [&](const char* name, std::optional<double> otherwise = {}) {
            return number(table + '.' + name, first.unit, first.displayUnit, otherwise);
        };
        const auto minimum = value("minimum"), maximum = value("maximum"),
                   start = value("start", first.get(document_.start.value));
        if (!minimum || !maximum || !start) return;
        parameter.minimum = *minimum;
        parameter.maximum = *maximum;
        parameter.start = *start;
        const auto shown = [&](double number) { return formatQuantity(withoutNoise(number), first.displayUnit); };
        const auto complain = [&](const char* name, std::string message) {
            reader_.add(table + '.' + name, std::move(message));
        };
        if (!(*minimum < *maximum))
            return complain("maximum", "must be greater than minimum (" + shown(*minimum) + ")");
        if (*start < *minimum || *start > *maximum)
            return complain("start", shown(*start) + " is not between minimum (" + shown(*minimum) + ") and maximum (" +
                                         shown(*maximum) + ")");
        for (const auto& [name, bound] : {std::pair{"minimum", *minimum}, std::pair{"maximum", *maximum}}) {
            Case tried = document_.start.value;
            for (const DesignKey& key : parameter.keys)
                if (const auto problem = key.set(tried, key.get(tried) + bound - first.get(document_.start.value)))
                    return complain(name, key.key + ": " + *problem);
        }
    }

    void readTargets()
    {
        const std::vector<Quantity> quantities = wantedQuantities();
        std::vector<std::string> names;
        for (const Quantity& quantity : quantities) names.push_back(quantity.name);
        for (const std::string& table : tables("target", mostTargets)) {
            reader_.allow(table, {"quantity", "value", "tolerance"});
            const auto name = text(table + ".quantity", "a quantity such as \"minimum_spacing\"");
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
                document_.task.targets.push_back({quantity, *value, *tolerance});
        }
    }

    DesignDocument& document_;
    StudyReader reader_;
};

} // namespace

DesignDocument parseDesign(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                           const std::vector<std::string>& settings)
{
    DesignDocument document;
    document.name = name;
    document.text = text;
    const TomlDocument toml = readToml(text);
    if (!toml.problem.empty())
        document.problems.push_back({name, toml.problemLine, "", toml.problem});
    else
        DesignReader(document, toml).read(folder, settings);
    return document;
}

DesignDocument readDesign(const std::filesystem::path& file, const std::vector<std::string>& settings)
{
    std::error_code error;
    const bool isFile = std::filesystem::exists(file, error);
    if (const SampleStudy* sample = findSampleStudy("design", file.string()); sample != nullptr && !isFile)
        return parseDesign(sample->text, sample->name, {}, settings);
    const auto content = readTextFile(file, maximumStudyFileSize);
    if (const auto* text = std::get_if<std::string>(&content))
        return parseDesign(*text, file.string(), file.parent_path(), settings);
    DesignDocument document;
    document.name = file.string();
    std::string message = std::get<FileProblem>(content).message;
    if (!isFile && !document.name.empty() && !file.has_parent_path())
        message = isSampleCase(document.name)
                      ? "is a case; a design needs the file of a study, which says what may change and what is wanted"
                      : "is neither a file nor a sample study of this kind" +
                            didYouMean(nearestName(document.name, sampleStudyNames("design")));
    document.problems.push_back({document.name, 0, "", std::move(message)});
    return document;
}

std::string writeDesignCsv(const std::filesystem::path& file, const DesignTask& task, const DesignStudy& study)
{
    std::string text = "iteration";
    for (const DesignParameter& parameter : task.parameters) {
        const DesignKey& key = parameter.keys.front();
        text += ',' + key.key + (key.unit.empty() ? "" : " [" + key.unit + ']');
    }
    for (const DesignTarget& target : task.targets)
        text += ',' + target.quantity.name + " [" + target.quantity.unit + ']';
    text += ",misfit\r\n";
    for (const DesignPoint& point : study.steps) {
        text += std::to_string(point.iteration);
        for (const double value : point.parameters) text += ',' + decimalText(value);
        for (const double value : point.quantities) text += ',' + decimalText(value);
        text += ',' + decimalText(point.misfit) + "\r\n";
    }
    const std::string problem = writeTextFile(file, text);
    return problem.empty() ? problem : file.string() + ": " + problem;
}

} // namespace touchdown
