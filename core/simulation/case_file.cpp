// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/case_file.h"

#include "core/simulation/fields.h"
#include "core/simulation/nearest_name.h"
#include "core/simulation/quotation.h"
#include "core/simulation/text_file.h"
#include "core/simulation/toml_document.h"
#include "core/simulation/units.h"

#include <algorithm>
#include <set>

namespace touchdown {

namespace {

std::string needed(const Field& field)
{
    switch (field.kind) {
    case FieldKind::Number:
        return field.unit.empty() ? "a number is needed" : "a number or \"1 " + field.displayUnit + "\" is needed";
    case FieldKind::Integer: return "a whole number is needed";
    case FieldKind::Choice: return "allowed is " + allowedRange(field);
    case FieldKind::Boolean: return "true or false is needed";
    case FieldKind::Text: return "text in quotation marks is needed";
    }
    return {};
}

/// Sets a field from a value of a case file; returns what is wrong with it.
struct ValueReader {
    Case& target;
    const Field& field;
    using Problem = std::optional<std::string>;

    Problem operator()(std::monostate) const { return "has the wrong type; " + needed(field); }
    Problem operator()(bool value) const
    {
        if (field.kind != FieldKind::Boolean) return (value ? "is true; " : "is false; ") + needed(field);
        field.set(target, value);
        return {};
    }
    Problem operator()(std::int64_t value) const { return fromNumber(static_cast<double>(value)); }
    Problem operator()(double value) const { return fromNumber(value); }
    Problem operator()(const std::string& text) const
    {
        if (field.kind == FieldKind::Integer || field.kind == FieldKind::Boolean) return "is text; " + needed(field);
        if (field.kind != FieldKind::Number) return setFromText(target, field, text);
        const auto number = parseQuantity(text, field.unit);
        if (const auto* problem = std::get_if<UnitProblem>(&number)) return problem->message;
        return setFromNumber(target, field, std::get<double>(number));
    }

private:
    Problem fromNumber(double value) const
    {
        if (field.kind != FieldKind::Number && field.kind != FieldKind::Integer) return "is a number; " + needed(field);
        return setFromNumber(target, field, value);
    }
};

std::vector<std::string> groups()
{
    std::vector<std::string> names;
    for (const Field& field : fields())
        if (!field.group().empty() && (names.empty() || names.back() != field.group())) names.push_back(field.group());
    return names;
}

std::string shortened(const std::string& key)
{
    constexpr std::size_t longest = 80;
    return key.size() <= longest ? key : key.substr(0, longest) + "...";
}

/// Fills a document from its text.
class CaseReader {
public:
    explicit CaseReader(CaseDocument& document) : document_(document), groups_(groups()) {}

    void read()
    {
        const TomlDocument toml = readToml(document_.text);
        if (!toml.problem.empty()) {
            document_.problems.push_back({document_.name, toml.problemLine, "", toml.problem});
            return;
        }
        for (const TomlTable& table : toml.tables) readTable(table);
        for (const TomlEntry& entry : toml.entries) readEntry(entry);
        addCombinations(toml);
        std::ranges::stable_sort(document_.problems, {}, &InputProblem::line);
    }

private:
    void add(int line, const std::string& key, std::string message)
    {
        document_.problems.push_back({document_.name, line, shortened(key), std::move(message)});
        wrongKeys_.insert(key);
    }

    void readTable(const TomlTable& table)
    {
        if (isGroup(table.key) || insideUnknown(table.key)) return;
        unknownTables_.insert(table.key);
        if (findField(table.key) != nullptr) {
            add(table.line, table.key, "is a value, not a table");
            return;
        }
        add(table.line, table.key, "unknown table" + didYouMean(nearestName(table.key, groups_)));
    }

    void readEntry(const TomlEntry& entry)
    {
        if (insideUnknown(entry.key)) return;
        if (isGroup(entry.key)) {
            add(entry.line, entry.key, "is a table, not a value; write [" + entry.key + "]");
        } else if (const Field* field = findField(entry.key)) {
            if (auto problem = std::visit(ValueReader{document_.value, *field}, entry.value))
                add(entry.line, entry.key, *problem);
        } else {
            // A search over all keys each; more than a few are no slips of the pen.
            constexpr int mostSuggestions = 50;
            add(entry.line, entry.key,
                "unknown key" + didYouMean(suggestions_++ < mostSuggestions ? nearestKey(entry.key) : ""));
        }
    }

    bool isGroup(const std::string& key) const { return std::ranges::find(groups_, key) != groups_.end(); }

    bool insideUnknown(const std::string& key) const
    {
        for (auto dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1))
            if (unknownTables_.contains(key.substr(0, dot))) return true;
        return false;
    }

    /// Only where the values that are combined were all read.
    void addCombinations(const TomlDocument& toml)
    {
        for (const CaseProblem& problem : checkCombinations(document_.value)) {
            const bool follows = std::ranges::any_of(wrongKeys_, [&](const std::string& key) {
                return key == problem.key || problem.message.find(key) != std::string::npos;
            });
            if (follows) continue;
            const auto entry = std::ranges::find(toml.entries, problem.key, &TomlEntry::key);
            const int line = entry == toml.entries.end() ? 0 : entry->line;
            document_.problems.push_back({document_.name, line, problem.key, problem.message});
        }
    }

    CaseDocument& document_;
    std::vector<std::string> groups_;
    std::set<std::string, std::less<>> unknownTables_;
    std::set<std::string, std::less<>> wrongKeys_;
    int suggestions_ = 0;
};

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/// Applies one "key=value"; returns its problem.
std::optional<InputProblem> applySetting(Case& target, std::string_view setting)
{
    const auto problem = [](std::string_view key, std::string message) {
        return InputProblem{"--set", 0, shortened(std::string(key)), std::move(message)};
    };
    const auto equals = setting.find('=');
    if (equals == std::string_view::npos) return problem("", inQuotes(setting) + " is not key=value");
    const std::string_view key = trimmed(setting.substr(0, equals));
    std::string_view value = trimmed(setting.substr(equals + 1));
    const Field* field = findField(key);
    if (field == nullptr)
        return problem(key.empty() ? inQuotes(setting) : std::string(key), "unknown key" + didYouMean(nearestKey(key)));

    const bool inMarks =
        value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    if (inMarks) value = value.substr(1, value.size() - 2);
    auto message = inMarks && field->kind == FieldKind::Number ? ValueReader{target, *field}(std::string(value))
                                                               : setFromText(target, *field, value);
    if (!message) return {};
    return problem(key, *message);
}

} // namespace

std::string InputProblem::text() const
{
    std::string result = file;
    if (line > 0) result += ':' + std::to_string(line);
    if (!result.empty()) result += ": ";
    if (!key.empty()) result += key + ": ";
    return result + message;
}

CaseDocument parseCase(std::string text, std::string name)
{
    CaseDocument document;
    document.text = std::move(text);
    document.name = std::move(name);
    CaseReader(document).read();
    return document;
}

CaseDocument readCaseFile(const std::filesystem::path& file)
{
    const auto refuse = [&](std::string message) {
        CaseDocument document;
        document.name = file.string();
        document.problems.push_back({document.name, 0, "", std::move(message)});
        return document;
    };
    if (file.empty()) return refuse("a file name is needed");
    auto content = readTextFile(file, maximumCaseFileSize);
    if (const auto* problem = std::get_if<FileProblem>(&content)) return refuse(problem->message);
    std::string& text = std::get<std::string>(content);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) return refuse("is empty");
    return parseCase(std::move(text), file.string());
}

CaseDocument openCase(const std::string& fileOrName)
{
    std::error_code error;
    const auto sample = std::ranges::find(sampleCases(), fileOrName, &SampleCase::name);
    const bool isSample = sample != sampleCases().end();
    // A folder of results may bear the name of its case.
    const bool isFile =
        std::filesystem::exists(fileOrName, error) && !(isSample && std::filesystem::is_directory(fileOrName, error));
    if (isSample && !isFile) return parseCase(sample->text, sample->name);
    CaseDocument document = readCaseFile(fileOrName);
    if (!isFile && !error && !fileOrName.empty() && fileOrName.find('/') == std::string::npos) {
        std::vector<std::string> names;
        for (const SampleCase& each : sampleCases()) names.push_back(each.name);
        document.problems.front().message =
            "is neither a file nor a sample case" + didYouMean(nearestName(fileOrName, names));
    }
    return document;
}

void applySettings(CaseDocument& document, const std::vector<std::string>& settings)
{
    // A setting may mend a combination of the file, or spoil one.
    const auto before = checkCombinations(document.value);
    std::erase_if(document.problems, [&](const InputProblem& problem) {
        return std::ranges::any_of(
            before, [&](const CaseProblem& old) { return old.key == problem.key && old.message == problem.message; });
    });
    const bool readable = document.valid();
    for (const std::string& setting : settings)
        if (auto problem = applySetting(document.value, setting)) document.problems.push_back(std::move(*problem));
    if (!document.valid()) return;
    for (const CaseProblem& problem : checkCombinations(document.value))
        document.problems.push_back({document.name, 0, problem.key, problem.message});
    if (readable && !settings.empty()) document.text = updateCaseText(document.text, document.value);
}

std::string writeCaseFile(const std::filesystem::path& file, const std::string& text)
{
    const std::string problem = writeTextFile(file, text);
    return problem.empty() ? problem : file.string() + ": " + problem;
}

} // namespace touchdown
