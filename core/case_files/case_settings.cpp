// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_settings.h"

#include "core/case/case_key.h"
#include "core/case/disk_setup.h"
#include "core/case/model_defaults.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"
#include "core/case_files/outside_path.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_document.h"
#include "core/formats/words.h"
#include "core/physics/slider/surface_check.h"

#include <algorithm>
#include <optional>
#include <variant>

namespace touchdown {

namespace {

std::string_view keyOf(std::string_view setting) { return trimmed(setting.substr(0, setting.find('=')), blanks); }

/// The parameter of a key, or "unknown key; did you mean ...?".
std::variant<Parameter, std::string> settingKey(const Case& c, std::string_view key)
{
    auto found = caseKey(c, key);
    const bool ofSurface = key.starts_with("abs.") && key.find('[') != std::string_view::npos;
    if (std::holds_alternative<std::string>(found) && !ofSurface) return "unknown key" + didYouMean(nearestKey(key));
    return found;
}

/// Why a file's setting of this key is refused; "" where it is not.
std::string pathProblem(const Case& c, std::string_view key)
{
    const std::string& file = c.diskSurface.file;
    if (key != surfaceFileKey || file.empty()) return {};
    // A sample case has no folder of its own.
    if (!c.folder.empty() && !leadsOutside(c.folder, file)) return {};
    return outsideProblem(file, "the case");
}

/// Applies one "key=value"; returns its problem.
std::optional<InputProblem> applySetting(Case& target, std::string_view setting, OutsidePaths allowed)
{
    const auto problem = [](std::string_view key, std::string message) {
        return InputProblem{"--set", 0, shortenedKey(key), std::move(message), ProblemKind::Setting};
    };
    const auto equals = setting.find('=');
    if (equals == std::string_view::npos) return problem("", inQuotes(setting) + " is not key=value");
    const std::string_view key = keyOf(setting);
    const std::string_view written = trimmed(setting.substr(equals + 1), blanks);
    const auto found = settingKey(target, key);
    const auto* parameter = std::get_if<Parameter>(&found);
    if (parameter == nullptr)
        return problem(key.empty() ? inQuotes(setting) : std::string(key), std::get<std::string>(found));

    const std::string_view value = withoutQuotes(written);
    const bool quoted = value.size() < written.size();
    const auto message = quoted && parameter->kind == ParameterKind::Number
                             ? setFromToml(target, *parameter, std::string(value))
                             : setFromText(target, *parameter, value);
    if (message) return problem(key, *message);
    std::string outside = allowed == OutsidePaths::Refused ? pathProblem(target, key) : "";
    if (outside.empty()) return {};
    target.diskSurface.file.clear();
    return problem(key, std::move(outside));
}

/// The line of a key in the file of the case; 0 where it has none, as in files of the established program.
int lineOf(const CaseDocument& document, std::string_view key)
{
    if (isCmlPath(document.name)) return 0;
    for (const TomlEntry& entry : readToml(document.text).entries)
        if (entry.key == key) return entry.line;
    return 0;
}

/// A contradiction belongs to a setting that takes part in it, else to the line of the case.
InputProblem placed(const CaseProblem& problem, const CaseDocument& document, const std::vector<std::string>& settings)
{
    InputProblem result = problem.in(document.name, lineOf(document, problem.key));
    auto setting = std::ranges::find(settings, problem.key, keyOf);
    if (setting == settings.end())
        setting = std::ranges::find_if(settings, [&](const auto& each) { return problem.concerns(keyOf(each)); });
    if (setting == settings.end()) return result;
    result.file = "--set";
    result.line = 0;
    result.key = keyOf(*setting);
    if (result.key != problem.key) result.message = problem.key + ' ' + problem.message;
    return result;
}

/// Where a setting chose another model: values that neither the text nor a setting states are its defaults.
void followModel(CaseDocument& document, ModelKind before, const std::vector<std::string>& settings)
{
    if (document.value.model == before) return;
    const std::vector<TomlEntry> entries = readToml(document.text).entries;
    takeModelDefaults(document.value, before, [&](const Parameter& parameter) {
        return std::ranges::find(entries, parameter.key, &TomlEntry::key) != entries.end() ||
               std::ranges::find(settings, parameter.key, keyOf) != settings.end();
    });
}

/// Where settings changed the surface or the slider's size.
void renewSurfaceWarnings(CaseDocument& document, const std::vector<std::string>& settings)
{
    const auto changes = [](const std::string& setting) {
        return keyOf(setting).starts_with("abs.") || keyOf(setting).starts_with("slider.");
    };
    if (std::ranges::none_of(settings, changes) || !usesSliderSurface(document.value)) return;
    const auto isOfSurface = [](const InputProblem& warning) {
        return warning.key == "abs" || warning.key.starts_with("abs.rail[") || warning.key.starts_with("abs.wall[");
    };
    const std::vector<InputProblem> before = document.warnings;
    std::erase_if(document.warnings, isOfSurface);
    const Case& c = document.value;
    for (const SurfaceProblem& warning : surfaceWarnings(c.surface, c.slider.length, c.slider.width)) {
        const auto same = std::ranges::find(before, warning.sentence, &InputProblem::message);
        if (same != before.end())
            document.warnings.push_back(*same);
        else
            document.warnings.push_back({"--set", 0, warning.key, warning.sentence, ProblemKind::Setting});
    }
}

/// A warning of a value that was set has the setting as its place; one that was there before keeps its line.
void renewWarnings(CaseDocument& document, const std::vector<std::string>& settings)
{
    const std::vector<InputProblem> before = document.warnings;
    std::erase_if(document.warnings, [](const InputProblem& warning) {
        return warning.kind == ProblemKind::Combination || warning.kind == ProblemKind::Setting;
    });
    for (const CaseProblem& each : caseWarnings(document.value)) {
        InputProblem warning = each.in(document.name);
        if (const auto same = std::ranges::find(before, each.key, &InputProblem::key); same != before.end())
            warning.file = same->file, warning.line = same->line, warning.kind = same->kind;
        if (std::ranges::find(settings, each.key, keyOf) != settings.end())
            warning.file = "--set", warning.line = 0, warning.kind = ProblemKind::Setting;
        document.warnings.push_back(std::move(warning));
    }
    renewSurfaceWarnings(document, settings);
}

} // namespace

void applySettings(CaseDocument& document, const std::vector<std::string>& settings, OutsidePaths outside)
{
    // A setting may remove a contradiction of the file, or make one.
    const auto isCombination = [](const InputProblem& problem) { return problem.kind == ProblemKind::Combination; };
    const auto isOfDisk = [](const InputProblem& problem) { return problem.kind == ProblemKind::MeasuredDisk; };
    std::erase_if(document.problems,
                  [&](const InputProblem& problem) { return isCombination(problem) || isOfDisk(problem); });
    // Another surface takes the place of one that the case may not read.
    if (std::ranges::find(settings, surfaceFileKey, keyOf) != settings.end() && !document.outsideFiles.empty())
        std::erase_if(document.problems, [](const InputProblem& problem) { return problem.key == surfaceFileKey; });
    const bool readable = document.valid();
    const ModelKind before = document.value.model;
    for (const std::string& setting : settings)
        if (auto problem = applySetting(document.value, setting, outside))
            document.problems.push_back(std::move(*problem));
    followModel(document, before, settings);
    if (!document.valid()) return;
    for (const CaseProblem& problem : checkCombinations(document.value))
        document.problems.push_back(placed(problem, document, settings));
    renewWarnings(document, settings);
    if (document.valid()) {
        DiskFileCheck disk = checkDiskFile(document.value);
        if (std::ranges::find(settings, surfaceFileKey, keyOf) != settings.end())
            disk.nameIn("--set", 0);
        else
            disk.nameIn(document.name, lineOf(document, surfaceFileKey));
        document.problems = disk.problems;
        std::erase_if(document.warnings, isOfDisk);
        document.warnings.insert(document.warnings.end(), disk.warnings.begin(), disk.warnings.end());
    }
    // A value without effect in the file may have one now; a setting may have none.
    std::erase_if(document.unused,
                  [&](const InputProblem& unused) { return findParameter(unused.key)->used(document.value); });
    for (const std::string& setting : settings) {
        const std::string key(keyOf(setting));
        const auto parameter = caseKey(document.value, key); // none where a later setting took its place away
        if (std::holds_alternative<std::string>(parameter)) continue;
        if (const std::string message = unusedMessage(document.value, std::get<Parameter>(parameter)); !message.empty())
            document.unused.push_back({"--set", 0, key, message, ProblemKind::Setting});
    }
    if (readable && !settings.empty()) document.text = updateCaseText(document.text, document.value, document.folder);
}

std::optional<InputProblem> changeCase(Case& c, const std::vector<CaseSetting>& settings, OutsidePaths outside)
{
    const auto refused = [](const std::string& key, std::string message) {
        return InputProblem{"", 0, key, std::move(message), ProblemKind::Setting};
    };
    Case changed = c;
    for (const CaseSetting& setting : settings) {
        const auto found = settingKey(changed, setting.key);
        if (const auto* problem = std::get_if<std::string>(&found)) return refused(setting.key, *problem);
        if (const auto problem = setFromText(changed, std::get<Parameter>(found), setting.value))
            return refused(setting.key, *problem);
        if (const std::string problem = pathProblem(changed, setting.key);
            outside == OutsidePaths::Refused && !problem.empty())
            return refused(setting.key, problem);
    }
    for (const CaseProblem& problem : checkCombinations(changed)) return refused(problem.key, problem.message);
    c = std::move(changed);
    return {};
}

} // namespace touchdown
