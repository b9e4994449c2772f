// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_head.h"

#include <algorithm>
#include <string_view>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/cml_case.h"
#include "core/case_files/outside_path.h"
#include "core/formats/quotation.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr const char* neededCase = "the file of a case, or the name of a sample case, in quotation marks";

/// Gives problems of settings their place in the study's table `set`.
void placeInStudy(const StudyReader& reader, std::vector<InputProblem>& problems)
{
    const auto lineOf = [&reader](const std::string& key) {
        return std::max(reader.lineOf("set." + key), reader.lineOf("set.\"" + key + '"'));
    };
    constexpr std::string_view names = "; --set names"; // in a problem inside the file of a measured surface
    for (InputProblem& problem : problems) {
        if (const auto at = problem.message.find(names); at != std::string::npos)
            problem.message.replace(
                at, names.size(), "; " + reader.name() + ':' + std::to_string(lineOf("disk.surface.file")) + " names");
        if (problem.file != "--set" || problem.kind == ProblemKind::NotFound) continue;
        problem.file = reader.name();
        problem.line = lineOf(problem.key);
        problem.key = "set." + problem.key;
    }
}

/// Cases lie in the folder of the study or beside it: a study may name case files and folders of the established
/// program within the folder above its own, and any file within its own.
bool mayName(const StudyReader& reader, const std::filesystem::path& file)
{
    if (reader.folder().empty() || reader.outsidePaths() == OutsidePaths::Allowed) return true;
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::canonical(file, error);
    if (error) return false;
    const bool isCase = lowerCase(whole.extension().string()) == ".toml" || isCmlPath(whole);
    return !leadsOutside(reader.folder(), whole) || (isCase && !leadsOutside(reader.folder() / "..", whole));
}

/// "steps", "ensemble.starts".
bool isKey(std::string_view key)
{
    const bool bare = key.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.") ==
                      std::string_view::npos;
    return bare && !key.empty() && !key.starts_with('.') && !key.ends_with('.') &&
           key.find("..") == std::string_view::npos;
}

/// The one entry of "key = value"; text where the value is no TOML.
TomlDocument readOption(const std::string& key, std::string_view value)
{
    TomlDocument toml = readToml(key + " = " + std::string(value));
    const bool several = value.find_first_of("\r\n") != std::string_view::npos;
    return toml.problem.empty() && !several ? toml : readToml(key + " = " + tomlString(value));
}

/// "" or why a key of the file cannot be an option.
std::string reasonAgainst(const TomlDocument& toml, std::string_view key)
{
    const auto isListOf = [&](const TomlTable& table) {
        return table.kind == TomlTableKind::Array && key.substr(0, key.find('.')) == table.key;
    };
    if (std::ranges::any_of(toml.tables, isListOf)) return "is of a list of tables; it stands in the study's file";
    if (key == "set" || key.starts_with("set.")) return "is no option; --set KEY=VALUE changes the case";
    if (key == "case" || key == "kind") return "is no option; it stands in the study's file";
    return {};
}

void removeKey(TomlDocument& toml, const std::string& key)
{
    const auto isWithin = [&](const auto& each) {
        return each.key == key || each.key.starts_with(key + '.') || each.key.starts_with(key + '[');
    };
    std::erase_if(toml.entries, isWithin);
    std::erase_if(toml.tables, isWithin);
}

} // namespace

TomlDocument readStudyText(const std::string& text)
{
    TomlDocument toml = readToml(text);
    const auto entry = [&](const char* key) { return std::ranges::find(toml.entries, key, &TomlEntry::key); };
    if (entry("kind") == toml.entries.end())
        if (const auto other = entry("study"); other != toml.entries.end()) other->key = "kind";
    return toml;
}

std::vector<StudyKey> headKeys()
{
    return {textKey("title", {}, "", "title of the report; default: that of the case"),
            textKey("kind", {}, "", "kind of study"),
            textKey("case", {}, neededCase, "the case that is studied; a path is relative to the study's file"),
            settingsKey("set", "changes of the case")};
}

bool isOfKind(StudyReader& reader, const std::string& kind)
{
    const bool silent = !reader.has("kind");
    const auto its = reader.text("kind");
    if (its && *its != kind) reader.add("kind", "is " + inQuotes(*its) + ", not " + inQuotes(kind));
    return silent || (its && *its == kind);
}

bool namesCase(StudyReader& reader)
{
    if (reader.has("case")) return true;
    reader.text("case", neededCase); // it may
    return false;
}

std::optional<CaseDocument> openStudyCase(StudyReader& reader)
{
    if (!namesCase(reader)) reader.add("case", std::string("is missing; ") + neededCase + " is needed");
    const auto name = reader.text("case", neededCase);
    if (!name) return {};
    CaseDocument document = openFurtherCase(reader, *name);
    for (InputProblem& problem : document.problems) {
        // Of the whole file, such as that there is none: one of the study, which names it.
        if (problem.file != document.name || problem.line > 0 || !problem.key.empty()) continue;
        problem.file = reader.name();
        problem.line = reader.lineOf("case");
        problem.key = "case";
        problem.message = inQuotes(*name) + ' ' + problem.message;
    }
    return document;
}

CaseDocument openFurtherCase(StudyReader& reader, const std::string& name)
{
    return changedStudyCase(reader, openCaseBeside(reader, name));
}

CaseDocument openCaseBeside(StudyReader& reader, const std::string& name)
{
    std::error_code error;
    const std::filesystem::path beside = reader.folder() / name;
    const bool isBeside = !reader.folder().empty() && !name.empty() && std::filesystem::exists(beside, error);
    const std::string file = isBeside ? beside.string() : name;
    const bool opens = std::filesystem::is_regular_file(file, error) || isCmlPath(file);
    if (opens && !mayName(reader, file)) {
        CaseDocument document;
        document.name = file;
        document.outsideFiles.push_back(name);
        document.problems.push_back({reader.name(), reader.lineOf("case"), "case", outsideProblem(name, "the study")});
        return document;
    }
    CaseDocument document = openCase(file, reader.outsidePaths());
    reader.addInputs(document.inputs());
    return document;
}

CaseDocument changedStudyCase(StudyReader& reader, CaseDocument start)
{
    std::vector<std::string> own;
    for (const CaseSetting& each : reader.settings("set")) own.push_back(each.key + '=' + each.value);
    if (!own.empty()) applySettings(start, own, reader.outsidePaths());
    placeInStudy(reader, start.problems);
    placeInStudy(reader, start.unused);
    placeInStudy(reader, start.warnings);
    if (!reader.caseSettings().empty()) applySettings(start, reader.caseSettings());
    return start;
}

std::vector<InputProblem> applyOptions(TomlDocument& toml, const std::vector<std::string>& options)
{
    std::vector<InputProblem> problems;
    for (const std::string& option : options) {
        const auto refuse = [&](const std::string& key, std::string message) {
            problems.push_back({"--option", 0, shortenedKey(key), std::move(message)});
        };
        const auto equals = option.find('=');
        const std::string key(trimmed(std::string_view(option).substr(0, equals), blanks));
        if (equals == std::string::npos || !isKey(key)) {
            refuse("", inQuotes(option) + " is not key=value");
            continue;
        }
        if (const std::string reason = reasonAgainst(toml, key); !reason.empty()) {
            refuse(key, reason);
            continue;
        }
        TomlDocument one = readOption(key, trimmed(std::string_view(option).substr(equals + 1), blanks));
        if (!one.problem.empty()) {
            refuse(key, one.problem);
            continue;
        }
        removeKey(toml, key);
        for (TomlEntry& entry : one.entries) {
            entry.line = optionLine;
            toml.entries.push_back(std::move(entry));
        }
        for (TomlTable& table : one.tables) {
            if (std::ranges::find(toml.tables, table.key, &TomlTable::key) != toml.tables.end())
                continue; // it has one key more
            table.line = optionLine;
            toml.tables.push_back(std::move(table));
        }
    }
    return problems;
}

} // namespace touchdown
