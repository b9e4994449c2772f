// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/case_commands.h"

#include <algorithm>
#include <filesystem>

#include "app/commands/study_command.h"
#include "app/terminal/console.h"
#include "app/terminal/refusal.h"
#include "app/terminal/text_table.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"
#include "core/formats/dxf_surface.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"
#include "core/formats/words.h"
#include "core/simulation/static_state/high_disk.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

namespace fs = std::filesystem;

Json validation(const char* what, const CaseDocument& document, const std::string& title,
                const std::vector<InputProblem>& problems)
{
    return {{what, document.name},
            {"title", title},
            {"valid", problems.empty()},
            {"problems", problemsJson(problems)},
            {"warnings", problemsJson(document.warnings)},
            {"unused", problemsJson(document.unused)}};
}

/// The problem of the kind that a study names, if there is one.
std::optional<InputProblem> kindProblem(const std::string& name, const StudySource& study)
{
    const std::vector<std::string> kinds = studyKindNames();
    if (std::ranges::find(kinds, study.kind) != kinds.end()) return {};
    const std::string said = study.kind.empty() ? "is missing: it is one of "
                                                : inQuotes(study.kind) + " is no kind of study: allowed is one of ";
    return InputProblem{name, study.kindLine, "kind",
                        said + joined(kinds) + didYouMean(nearestName(study.kind, kinds))};
}

int validateStudy(const CommandArguments& arguments, const StudySource& study)
{
    StudyPlan plan;
    if (const auto problem = kindProblem(arguments.name, study))
        plan.problems.push_back(*problem);
    else
        plan = openStudy(study.kind, arguments.name, arguments.settings, {}, arguments.outside());
    CaseDocument& start = plan.start;
    start.name = arguments.name;
    warnOf(plan);
    complainOf(plan.problems);
    if (arguments.json) {
        Json object = validation("study", start, plan.title, plan.problems);
        object["kind"] = study.kind;
        print(jsonText(object));
    } else if (plan.valid()) {
        print(arguments.name + ": valid, a study of kind " + study.kind + "\n");
    }
    return plan.valid() ? exitDone : exitWrongInput;
}

/// What a film on the case's grid finds of the disk under it at the start of a run.
void lookAtDisk(CaseDocument& document)
{
    if (!document.valid() || document.value.model != ModelKind::Film) return;
    constexpr auto key = "initial.nominal_trailing_edge_height";
    DiskAtStart disk = diskAtStart(document.value);
    if (!disk.problem.empty()) document.problems.push_back({document.name, 0, key, std::move(disk.problem)});
    for (std::string& warning : disk.warnings) {
        document.warnings.push_back({document.name, 0, "disk.surface", std::move(warning)});
        complainOf({document.warnings.back()}, "warning: ");
    }
}

/// Names the file of the disk's surface as seen from the folder of the new files. Returns whether it lies outside.
bool moveSurface(CaseDocument& document, const fs::path& folder)
{
    std::string& surface = document.value.diskSurface.file;
    if (surface.empty()) return false;
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(document.value.folder / surface, error), error);
    const bool outside = leadsOutside(folder, whole);
    surface =
        (outside ? whole : fs::proximate(whole, fs::weakly_canonical(fs::absolute(folder), error), error)).string();
    return outside;
}

/// Writes a case file whose file names fit the folder of `to`. Returns the problem, or "".
std::string writeToml(CaseDocument& document, const fs::path& to)
{
    const fs::path folder = to.parent_path().empty() ? fs::path(".") : to.parent_path();
    const bool outside = moveSurface(document, folder);
    const std::string& surface = document.value.diskSurface.file;
    const std::string text = updateCaseText(document.text, document.value, folder);
    const CaseDocument written = parseCase(text, to.string(), folder, OutsidePaths::Allowed);
    if (written.valid() && outside)
        complain("warning: " + to.string() + ": " + surfaceFileKey + ": " + outsideProblem(surface, "the case"));
    if (!written.valid()) return "does not fit into a case file: " + written.problems.front().text();
    return writeCaseFile(to, text);
}

/// Why the files that `to` names must not be replaced; "" if there are none, or they may be.
std::string replacementProblem(const CaseDocument& document, const fs::path& to, bool oneFile, bool force)
{
    std::error_code none;
    for (const fs::path& file : oneFile ? std::vector{to} : replacedCmlFiles(to)) {
        for (const fs::path& input : document.inputs())
            if (fs::equivalent(file, input, none)) return file.string() + " is what is converted; name another target";
        if (!oneFile && !force) return file.string() + " exists; --force replaces it";
    }
    return {};
}

std::string writeCml(CaseDocument& document, const fs::path& to)
{
    const bool archive = isCmlPath(to) && !fs::is_directory(to);
    moveSurface(document, !archive ? to : to.parent_path().empty() ? fs::path(".") : to.parent_path());
    const CmlOutput output = formatCmlCase(document.value);
    if (!output.problem.empty()) return document.name + ": " + output.problem;
    std::string problem = writeCmlCase(to, output.members);
    if (problem.empty() && !output.lost.empty()) complain("warning: " + to.string() + ": " + output.lost);
    if (!problem.empty() || output.keptKeys.empty()) return problem;
    complain("warning: " + to.string() +
             ": kept in the comments of run.dat, where the established program does not see them: " +
             joined(output.keptKeys));
    return {};
}

std::string writeDxf(const CaseDocument& document, const fs::path& to)
{
    const Case& c = document.value;
    if (c.model != ModelKind::Film) return document.name + ": has no slider with rails, of which a drawing is made";
    const std::string problem = writeTextFile(to, dxfText(c.surface, c.slider.length, c.slider.width));
    if (!problem.empty()) return to.string() + ' ' + problem;
    if (const std::string lost = lostInDrawing(c.surface); !lost.empty())
        complain("warning: " + to.string() + ": " + lost);
    return {};
}

} // namespace

CaseDocument openCaseToKeep(const CommandArguments& arguments)
{
    const std::string& name = arguments.name;
    const std::vector<std::string>& settings = arguments.settings;
    CaseDocument document = openCase(name, arguments.outside());
    if (const auto study = document.valid() ? std::nullopt : findStudySource(name)) {
        const std::string kind = study->kind.empty() ? "KIND" : study->kind;
        document.problems = {{document.name, 0, "",
                              "is a study, not a case; did you mean `touchdown study " + kind + ' ' + name + "`?"}};
    } else if (!settings.empty()) {
        applySettings(document, settings);
    }
    complainOf(document.warnings, "warning: ");
    return document;
}

CaseDocument openCaseToUse(const CommandArguments& arguments)
{
    CaseDocument document = openCaseToKeep(arguments);
    complainOf(document.unused, "warning: ");
    return document;
}

CaseDocument openFilmCase(const CommandArguments& arguments)
{
    CaseDocument document = openCaseToUse(arguments);
    if (!document.valid() || document.value.model == ModelKind::Film) return document;
    document.problems.push_back({document.name, 0, "model", "must be \"film\" for a static state on an air film"});
    return document;
}

int listCommand(bool json)
{
    Json cases = Json::array(), studies = Json::array();
    std::vector<std::vector<std::string>> rows, studyRows;
    for (const SampleCase& sample : sampleCases()) {
        const Case c = parseCase(sample.text, sample.name).value;
        rows.push_back({sample.name, c.title});
        cases.push_back({{"name", sample.name},
                         {"title", c.title},
                         {"paper", c.about.paper},
                         {"watch", c.about.watch},
                         {"assumed", c.about.assumed}});
    }
    for (const SampleStudy& study : sampleStudies()) {
        studyRows.push_back({study.kind, study.name, study.title});
        studies.push_back({{"kind", study.kind}, {"name", study.name}, {"title", study.title}});
    }
    const std::vector<bool> left(3, true);
    print(json ? jsonText({{"cases", cases}, {"studies", studies}})
               : alignedTable(rows, left) + "\nStudies: touchdown study KIND NAME\n" + alignedTable(studyRows, left));
    return exitDone;
}

int validateCommand(const CommandArguments& arguments)
{
    if (const auto study = findStudySource(arguments.name)) return validateStudy(arguments, *study);
    CaseDocument document = openCaseToUse(arguments);
    lookAtDisk(document);
    complainOf(document.problems);
    if (arguments.json)
        print(jsonText(validation("case", document, document.value.title, document.problems)));
    else if (document.valid())
        print(document.name + ": valid\n");
    return document.valid() ? exitDone : exitWrongInput;
}

int convertCommand(const CommandArguments& arguments, const std::string& to, bool force)
{
    // Values without effect are kept, so that converting back loses no more than is said.
    CaseDocument document = openCaseToKeep(arguments);
    if (!document.valid()) return refuse(document.problems, false);
    const bool toml = fs::path(to).extension() == ".toml", dxf = fs::path(to).extension() == ".dxf";
    if (const std::string problem = replacementProblem(document, to, toml || dxf, force); !problem.empty())
        return refuse({{"", 0, "", problem}}, false);
    const std::string problem = toml ? writeToml(document, to) : dxf ? writeDxf(document, to) : writeCml(document, to);
    if (problem.empty()) return exitDone;
    complain(problem);
    return exitWrongInput;
}

} // namespace touchdown
