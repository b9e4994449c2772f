// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_reader.h"

#include "core/case/disk_setup.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/case_files/surface_text.h"
#include "core/formats/cml_text.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"
#include "core/formats/toml_quantity.h"
#include "core/physics/slider/surface_relations.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace touchdown {

namespace {

/// The default numbers of a list, or two numbers that show the unit.
std::string exampleOf(const Parameter& parameter)
{
    if (parameter.unit.empty())
        if (std::string usual = toText(Case{}, parameter); !usual.empty()) return usual;
    const std::string one = parameter.unit.empty() ? "1" : "\"1 " + parameter.displayUnit + '"';
    return one + ", " + one;
}

std::string needed(const Parameter& parameter)
{
    switch (parameter.kind) {
    case ParameterKind::Number:
        return parameter.unit.empty() ? "a number is needed"
                                      : "a number or \"1 " + parameter.displayUnit + "\" is needed";
    case ParameterKind::Integer: return "a whole number is needed";
    case ParameterKind::Choice: return "allowed is " + allowedRange(parameter);
    case ParameterKind::Boolean: return "true or false is needed";
    case ParameterKind::Text: return "text in quotation marks is needed";
    case ParameterKind::List: return "a list such as [" + exampleOf(parameter) + "] is needed";
    }
    return {};
}

struct ValueReader {
    Case& target;
    const Parameter& parameter;
    using Problem = std::optional<std::string>;

    Problem operator()(std::monostate) const { return "has the wrong type; " + needed(parameter); }
    Problem operator()(bool value) const
    {
        if (parameter.kind != ParameterKind::Boolean) return (value ? "is true; " : "is false; ") + needed(parameter);
        parameter.set(target, value);
        return {};
    }
    Problem operator()(std::int64_t value) const { return fromNumber(static_cast<double>(value)); }
    Problem operator()(double value) const { return fromNumber(value); }
    Problem operator()(const std::string& text) const
    {
        if (parameter.kind == ParameterKind::Text || parameter.kind == ParameterKind::Choice)
            return setFromText(target, parameter, text);
        if (parameter.kind != ParameterKind::Number) return "is text; " + needed(parameter);
        const auto number = parseQuantity(text, parameter.unit);
        if (const auto* problem = std::get_if<UnitProblem>(&number)) return problem->message;
        return setFromNumber(target, parameter, std::get<double>(number));
    }
    Problem operator()(const TomlArray& array) const
    {
        if (parameter.kind != ParameterKind::List) return "has the wrong type; " + needed(parameter);
        std::vector<double> values;
        for (const TomlElement& element : array.elements) {
            if (values.size() > parameter.maximumCount) break;
            const auto number = tomlQuantity(element.value, parameter.unit, parameter.displayUnit);
            if (const auto* problem = std::get_if<UnitProblem>(&number)) return problem->message;
            values.push_back(std::get<double>(number));
        }
        return setFromNumbers(target, parameter, values);
    }

private:
    Problem fromNumber(double value) const
    {
        if (parameter.kind != ParameterKind::Number && parameter.kind != ParameterKind::Integer)
            return "is a number; " + needed(parameter);
        return setFromNumber(target, parameter, value);
    }
};

std::vector<std::string> groups()
{
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters())
        if (!parameter.group().empty() && (names.empty() || names.back() != parameter.group()))
            names.push_back(parameter.group());
    return names;
}

class CaseReader {
public:
    CaseReader(CaseDocument& document, OutsidePaths outside, MeasuredSurface surface)
        : document_(document), outside_(outside), surface_(surface), groups_(groups())
    {}

    void read()
    {
        const TomlDocument toml = readToml(document_.text);
        if (!toml.problem.empty()) {
            document_.problems.push_back({document_.name, toml.problemLine, "", toml.problem});
            return;
        }
        document_.value = defaultsOf(modelOf(toml));
        document_.value.folder = document_.folder;
        readRailFile(toml);
        for (const TomlTable& table : toml.tables) readTable(table);
        // First: some spellings of the law stand for asperity.model as well, which counts where it is given by itself.
        for (const bool law : {true, false})
            for (const TomlEntry& entry : toml.entries)
                if ((entry.key == "contact") == law) readEntry(entry);
        for (const InputProblem& problem : readSurface(toml, document_.value.surface))
            add(problem.line, problem.key, problem.message);
        addCombinations(toml);
        addUnused(toml);
        if (document_.valid() && surface_ == MeasuredSurface::Checked) {
            DiskFileCheck disk = checkDiskFile(document_.value);
            disk.nameIn(document_.name, lineOf(std::string(surfaceFileKey), toml));
            document_.problems = disk.problems;
            document_.warnings.insert(document_.warnings.end(), disk.warnings.begin(), disk.warnings.end());
        }
        std::ranges::stable_sort(document_.problems, {}, &InputProblem::line);
    }

private:
    void add(int line, const std::string& key, std::string message)
    {
        document_.problems.push_back({document_.name, line, shortenedKey(key), std::move(message)});
        wrongKeys_.insert(key);
    }

    /// Whether a file that the text names is not to be read; then that is a problem.
    bool refusesFile(const TomlEntry& entry, const std::string& file)
    {
        if (file.empty() || outside_ == OutsidePaths::Allowed || !leadsOutside(document_.folder, file)) return false;
        document_.outsideFiles.push_back(file);
        add(entry.line, entry.key, outsideProblem(file, "the case"));
        return true;
    }

    /// Missing values have the default of the model.
    static ModelKind modelOf(const TomlDocument& toml)
    {
        Case c;
        const auto entry = std::ranges::find(toml.entries, "model", &TomlEntry::key);
        if (entry != toml.entries.end()) setFromToml(c, *findParameter("model"), entry->value);
        return c.model;
    }

    /// The slider and its surface from a CML file; values in the case override it.
    void readRailFile(const TomlDocument& toml)
    {
        const auto entry = std::ranges::find(toml.entries, railFileKey, &TomlEntry::key);
        if (entry == toml.entries.end()) return;
        const auto refuse = [&](std::string message) { add(entry->line, entry->key, std::move(message)); };
        const auto* name = std::get_if<std::string>(&entry->value);
        if (name == nullptr) return refuse("has the wrong type; the name of a file in quotation marks is needed");
        for (const TomlTable& table : toml.tables)
            if (table.key == "abs.rail" || table.key == "abs.wall")
                return refuse("rails come from a file or from [[abs.rail]], not from both");
        if (document_.folder.empty()) return refuse("names a file, but this text has no folder");
        if (refusesFile(*entry, *name)) return;
        const std::filesystem::path file = document_.folder / *name;
        document_.files.push_back(file);
        const auto content = readTextFile(file, maximumCmlFileSize);
        if (const auto* problem = std::get_if<FileProblem>(&content))
            return refuse(inQuotes(*name) + ' ' + problem->message);
        CmlRails rails = readCmlRails(std::get<std::string>(content), file.string());
        for (const InputProblem& problem : rails.problems) document_.problems.push_back(problem);
        for (const InputProblem& warning : rails.warnings) document_.warnings.push_back(warning);
        if (!rails.valid()) {
            wrongKeys_.insert(entry->key);
            return;
        }
        document_.value.surface = std::move(rails.surface);
        document_.value.slider.length = rails.length;
        document_.value.slider.width = rails.width;
        document_.value.slider.thickness = rails.thickness;
    }

    void readTable(const TomlTable& table)
    {
        if (isSurfaceKey(table.key) || insideUnknown(table.key)) return;
        if (isGroup(table.key) && table.kind != TomlTableKind::Array) return;
        unknownTables_.insert(table.key);
        if (isGroup(table.key)) {
            add(table.line, table.key, "is a table, not a value; write [" + table.key + "]");
        } else if (findParameter(table.key) != nullptr || table.key == railFileKey) {
            add(table.line, table.key, "is a value, not a table");
        } else {
            add(table.line, table.key, "unknown table" + didYouMean(nearestName(table.key, groups_)));
        }
    }

    void readEntry(const TomlEntry& entry)
    {
        if (isSurfaceKey(entry.key) || entry.key == railFileKey || insideUnknown(entry.key)) return;
        if (isGroup(entry.key)) {
            add(entry.line, entry.key, "is a table, not a value; write [" + entry.key + "]");
        } else if (const Parameter* parameter = findParameter(entry.key)) {
            if (auto problem = setFromToml(document_.value, *parameter, entry.value))
                add(entry.line, entry.key, *problem);
            else if (entry.key == surfaceFileKey && refusesFile(entry, document_.value.diskSurface.file))
                document_.value.diskSurface.file.clear();
        } else {
            // Each suggestion searches all keys; a text with many unknown keys is not a case with typing errors.
            constexpr int mostSuggestions = 50;
            add(entry.line, entry.key,
                "unknown key" + didYouMean(suggestions_++ < mostSuggestions ? nearestKey(entry.key) : ""));
        }
    }

    bool isGroup(const std::string& key) const { return std::ranges::find(groups_, key) != groups_.end(); }

    bool insideUnknown(const std::string& key) const
    {
        for (auto end = key.find_first_of(".["); end != std::string::npos; end = key.find_first_of(".[", end + 1))
            if (unknownTables_.contains(key.substr(0, end))) return true;
        return false;
    }

    /// Only combinations whose values could all be read.
    void addCombinations(const TomlDocument& toml)
    {
        const bool badSurface = std::ranges::any_of(
            wrongKeys_, [](const std::string& key) { return key == railFileKey || isSurfaceKey(key); });
        for (const CaseProblem& problem : checkCombinations(document_.value)) {
            const bool follows =
                std::ranges::any_of(wrongKeys_, [&](const std::string& key) { return problem.concerns(key); });
            if (follows || (badSurface && isSurfaceKey(problem.key))) continue;
            document_.problems.push_back(problem.in(document_.name, lineOf(problem.key, toml)));
        }
        const Case& c = document_.value;
        if (!document_.valid()) return;
        for (const CaseProblem& warning : caseWarnings(c))
            document_.warnings.push_back(warning.in(document_.name, lineOf(warning.key, toml)));
        if (!usesSliderSurface(c)) return;
        std::vector<SurfaceProblem> warnings = surfaceWarnings(c.surface, c.slider.length, c.slider.width);
        std::ranges::move(relationProblems(c.surface, c.slider.width), std::back_inserter(warnings));
        for (const auto& [key, sentence, places] : warnings)
            document_.warnings.push_back({document_.name, lineOf(key, toml), key, sentence});
    }

    /// Values without effect; one sentence for all keys of a table that need the same choice.
    void addUnused(const TomlDocument& toml)
    {
        if (!document_.valid()) return;
        struct Unused {
            const TomlEntry& first;
            std::string message;
            std::vector<std::string> others;
        };
        std::vector<Unused> all;
        for (const TomlEntry& entry : toml.entries) {
            const Parameter* parameter = findParameter(entry.key);
            if (parameter == nullptr) continue;
            const std::string message = unusedMessage(document_.value, *parameter);
            if (message.empty()) continue;
            const auto same = std::ranges::find_if(all, [&](const Unused& unused) {
                return unused.message == message && findParameter(unused.first.key)->group() == parameter->group();
            });
            if (same == all.end())
                all.push_back({entry, message, {}});
            else
                same->others.push_back(entry.key);
        }
        for (const Unused& unused : all) {
            std::string others;
            for (const std::string& key : unused.others)
                others += (others.empty() ? "; the same holds for " : ", ") + key;
            document_.unused.push_back({document_.name, unused.first.line, unused.first.key, unused.message + others});
        }
    }

    /// The line of a value or a table; the line of abs.rails for values from that file.
    static int lineOf(const std::string& key, const TomlDocument& toml)
    {
        const auto entry = std::ranges::find(toml.entries, key, &TomlEntry::key);
        if (entry != toml.entries.end()) return entry->line;
        const auto table = std::ranges::find(toml.tables, key, &TomlTable::key);
        if (table != toml.tables.end()) return table->line;
        const auto file = std::ranges::find(toml.entries, railFileKey, &TomlEntry::key);
        return file == toml.entries.end() || !isSurfaceKey(key) ? 0 : file->line;
    }

    CaseDocument& document_;
    OutsidePaths outside_;
    MeasuredSurface surface_;
    std::vector<std::string> groups_;
    std::set<std::string, std::less<>> unknownTables_;
    std::set<std::string, std::less<>> wrongKeys_;
    int suggestions_ = 0;
};

} // namespace

std::optional<std::string> setFromToml(Case& target, const Parameter& parameter, const TomlValue& value)
{
    return std::visit(ValueReader{target, parameter}, value);
}

std::string shortenedKey(std::string_view key)
{
    constexpr std::size_t longest = 80;
    return key.size() <= longest ? std::string(key) : std::string(key.substr(0, longest)) + "...";
}

CaseDocument parseCase(std::string text, std::string name, const std::filesystem::path& folder, OutsidePaths outside,
                       MeasuredSurface surface)
{
    CaseDocument document;
    document.text = std::move(text);
    document.name = std::move(name);
    document.folder = folder;
    CaseReader(document, outside, surface).read();
    return document;
}

} // namespace touchdown
