// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run_source.h"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/commands/case_commands.h"
#include "app/terminal/console.h"
#include "app/terminal/refusal.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

/// A case file is a text, which does not begin so.
bool isResultsFile(const fs::path& file)
{
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    std::string begin(signature.size(), '\0');
    std::error_code none;
    if (!fs::is_regular_file(file, none)) return false;
    std::ifstream in(file, std::ios::binary);
    return in.read(begin.data(), std::streamsize(begin.size())) && begin == signature;
}

} // namespace

RunSource openRunSource(const CommandArguments& arguments)
{
    RunSource source;
    source.out = arguments.out;
    source.resumes = !arguments.resumeRun.empty();
    const auto refuse = [&](std::string problem) {
        source.document.name = arguments.name;
        source.document.problems.push_back({arguments.name, 0, "", std::move(problem)});
        return source;
    };
    if (source.resumes && arguments.resumeRun != "true" && arguments.resumeRun != "anyway")
        return refuse("--resume=" + arguments.resumeRun + " is not understood: it is --resume or --resume=anyway");
    if (!isResultsFile(arguments.name)) {
        if (source.resumes) return refuse("is no results file; --resume continues the run of one, FILE.h5");
        source.document = openCaseToUse(arguments);
        return source;
    }
    source.isStored = true;
    StoredRun stored = readResults(arguments.name);
    if (!stored.problem.empty()) {
        source.document.problems.push_back({"", 0, "", stored.problem});
        return source;
    }
    const fs::path folder = fs::path(arguments.name).parent_path();
    CaseDocument& document = source.document =
        parseCase(stored.caseText, arguments.name, folder.empty() ? fs::path(".") : folder, arguments.outside());
    const Case before = document.value;
    if (document.valid() && !arguments.settings.empty()) applySettings(document, arguments.settings);
    complainOf(document.warnings, "warning: ");
    if (!document.valid() || !source.resumes) return source;
    if (source.out.empty()) source.out = arguments.name;
    const OtherOrigin other = arguments.resumeRun == "anyway" ? OtherOrigin::Allowed : OtherOrigin::Refused;
    source.continued = continueRun(stored, before, document.value, other);
    if (std::string& problem = source.continued.problem; !problem.empty()) {
        if (source.continued.isOfOthers) problem += "; --resume=anyway continues it nevertheless, and marks the file";
        return refuse(problem);
    }
    if (!stored.samples.time.empty()) source.heldUntil = stored.samples.time.back();
    if (const auto& from = source.continued.from) {
        source.samples = std::move(stored.samples);
        source.fields = std::move(stored.fields);
        cutTo(*from, source.samples, source.fields);
        return source;
    }
    complain("warning: " + arguments.name + ": the run starts again, as " + source.continued.startsAgain);
    return source;
}

} // namespace touchdown
