// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_head.h"

#include <algorithm>

#include "core/case_files/case_settings.h"
#include "core/formats/quotation.h"

namespace touchdown {

namespace {

constexpr const char* settingsOption = "--set"; // what applySettings calls their file
constexpr const char* neededCase = "the file of a case, or the name of a sample case, in quotation marks";

/// What was said of settings is said of the study's table.
void nameTheStudy(const StudyReader& reader, std::vector<InputProblem>& problems)
{
    for (InputProblem& problem : problems) {
        if (problem.file != settingsOption) continue;
        problem.file = reader.name();
        problem.line = std::max(reader.lineOf("set." + problem.key), reader.lineOf("set.\"" + problem.key + '"'));
        problem.key = "set." + problem.key;
    }
}

} // namespace

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

std::optional<CaseDocument> openStudyCase(StudyReader& reader, const std::filesystem::path& folder,
                                          const std::vector<std::string>& settings)
{
    if (!namesCase(reader)) reader.add("case", std::string("is missing; ") + neededCase + " is needed");
    const auto name = reader.text("case", neededCase);
    if (!name) return {};
    std::error_code error;
    const std::filesystem::path beside = folder / *name;
    const bool isBeside = !folder.empty() && !name->empty() && std::filesystem::exists(beside, error);
    return changedStudyCase(reader, openCase(isBeside ? beside.string() : *name), settings);
}

CaseDocument changedStudyCase(StudyReader& reader, CaseDocument start, const std::vector<std::string>& settings)
{
    std::vector<std::string> own;
    for (const auto& [key, value] : reader.settings("set")) own.push_back(key + '=' + value);
    if (!own.empty()) applySettings(start, own);
    nameTheStudy(reader, start.problems);
    nameTheStudy(reader, start.unused);
    if (!settings.empty()) applySettings(start, settings);
    return start;
}

} // namespace touchdown
