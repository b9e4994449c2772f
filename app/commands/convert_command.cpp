// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/convert_command.h"

#include <filesystem>
#include <vector>

#include "app/commands/case_commands.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

// The case as a case file that can stand in the folder of `to`. Returns the problem, or "".
std::string writeToml(const CaseDocument& document, const fs::path& to)
{
    const fs::path folder = to.parent_path().empty() ? fs::path(".") : to.parent_path();
    const std::string text = updateCaseText(document.text, document.value, folder);
    const CaseDocument written = parseCase(text, to.string(), folder);
    if (!written.valid()) return "does not fit into a case file: " + written.problems.front().text();
    return writeCaseFile(to, text);
}

std::string writeCml(const CaseDocument& document, const fs::path& to)
{
    const CmlOutput output = formatCmlCase(document.value);
    if (!output.problem.empty()) return document.name + ": " + output.problem;
    std::string problem = writeCmlCase(to, output.members);
    if (!problem.empty() || output.keptKeys.empty()) return problem;
    std::string keys;
    for (const std::string& key : output.keptKeys) keys += (keys.empty() ? "" : ", ") + key;
    complain("warning: " + to.string() +
             ": kept in the comments of run.dat, where the established program does not see them: " + keys);
    return {};
}

} // namespace

int convertCommand(const std::string& from, const std::string& to)
{
    // What has no effect now is kept, so that nothing is lost on the way back.
    const CaseDocument document = openCaseToKeep(from);
    if (!document.valid()) return exitWrongInput;
    const bool toml = fs::path(to).extension() == ".toml";
    const std::string problem = toml ? writeToml(document, to) : writeCml(document, to);
    if (problem.empty()) return exitDone;
    complain(problem);
    return exitWrongInput;
}

} // namespace touchdown
