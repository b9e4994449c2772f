// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_file.h"

#include "core/case/disk_setup.h"
#include "core/case/fields.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/cml_case.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"

#include <algorithm>

namespace touchdown {

namespace {

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

std::string_view keyOf(std::string_view setting) { return trimmed(setting.substr(0, setting.find('='))); }

/// Applies one "key=value"; returns its problem.
std::optional<InputProblem> applySetting(Case& target, std::string_view setting)
{
    const auto problem = [](std::string_view key, std::string message) {
        return InputProblem{"--set", 0, shortenedKey(key), std::move(message)};
    };
    const auto equals = setting.find('=');
    if (equals == std::string_view::npos) return problem("", inQuotes(setting) + " is not key=value");
    const std::string_view key = keyOf(setting);
    std::string_view value = trimmed(setting.substr(equals + 1));
    const Field* field = findField(key);
    if (field == nullptr)
        return problem(key.empty() ? inQuotes(setting) : std::string(key), "unknown key" + didYouMean(nearestKey(key)));

    const bool inMarks =
        value.size() > 1 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
    if (inMarks) value = value.substr(1, value.size() - 2);
    auto message = inMarks && field->kind == FieldKind::Number ? setFromToml(target, *field, std::string(value))
                                                               : setFromText(target, *field, value);
    if (!message) return {};
    return problem(key, *message);
}

} // namespace

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
    const std::filesystem::path folder = file.parent_path();
    return parseCase(std::move(text), file.string(), folder.empty() ? "." : folder);
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
    if (isFile && isCmlPath(fileOrName)) return readCmlCase(fileOrName);
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
    const auto ofFile = diskFileProblems(document.value);
    std::erase_if(document.problems, [&](const InputProblem& problem) {
        if (std::ranges::any_of(ofFile, [&](const InputProblem& old) { return old.text() == problem.text(); }))
            return true;
        return std::ranges::any_of(
            before, [&](const CaseProblem& old) { return old.key == problem.key && old.message == problem.message; });
    });
    const bool readable = document.valid();
    for (const std::string& setting : settings)
        if (auto problem = applySetting(document.value, setting)) document.problems.push_back(std::move(*problem));
    if (!document.valid()) return;
    for (const CaseProblem& problem : checkCombinations(document.value))
        document.problems.push_back({document.name, 0, problem.key, problem.message});
    if (document.valid())
        for (const InputProblem& problem : diskFileProblems(document.value)) document.problems.push_back(problem);
    // What had no effect in the file may have one now; a setting may have none.
    std::erase_if(document.unused,
                  [&](const InputProblem& unused) { return findField(unused.key)->used(document.value); });
    for (const std::string& setting : settings) {
        const std::string key(keyOf(setting));
        if (const std::string message = unusedMessage(document.value, *findField(key)); !message.empty())
            document.unused.push_back({"--set", 0, key, message});
    }
    if (readable && !settings.empty()) document.text = updateCaseText(document.text, document.value, document.folder);
}

std::string writeCaseFile(const std::filesystem::path& file, const std::string& text)
{
    const std::string problem = writeTextFile(file, text);
    return problem.empty() ? problem : file.string() + ": " + problem;
}

} // namespace touchdown
