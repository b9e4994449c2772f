// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/design_command.h"

#include <filesystem>

#include "app/commands/case_commands.h"
#include "app/commands/design_report.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/stop_signal.h"
#include "core/studies/design/design_file.h"

namespace touchdown {

namespace {

Progress progressOf(const DesignProgress& progress)
{
    return {{},
            "",
            {{"iteration", static_cast<double>(progress.iteration), "", 10},
             {"static states", static_cast<double>(progress.solves), "", 10},
             {"misfit", progress.misfit}}};
}

/// The case with what was found, as the text of the case it began with. Returns the problem, or "".
std::string writeFound(const std::string& out, const DesignDocument& document, const Case& found)
{
    const std::filesystem::path folder = std::filesystem::path(out).parent_path();
    return writeCaseFile(out, updateCaseText(document.start.text, found, folder.empty() ? "." : folder));
}

} // namespace

int designCommand(const DesignArguments& arguments)
{
    const DesignDocument document = readDesign(arguments.study.name, arguments.study.settings);
    for (const auto* list : {&document.start.warnings, &document.start.unused})
        for (const InputProblem& warning : *list) complain("warning: " + warning.text());
    for (const InputProblem& problem : document.problems) complain(problem.text());
    if (arguments.asTemplate && !arguments.study.settings.empty()) {
        complain("--set: has no effect on what --template prints; write it into the file");
        return exitWrongInput;
    }
    if (arguments.asTemplate && document.valid()) {
        print(document.text);
        return exitDone;
    }
    const bool good = targetsAreGood({{"--out", arguments.out}, {"--csv", arguments.csv}}, arguments.study.name);
    if (!document.valid() || !good) return exitWrongInput;

    const StopSignal stop;
    ProgressLine line(arguments.progress);
    DesignStudy study = studyDesign(document.start.value, document.task, [&](const DesignProgress& progress) {
        line.show(progressOf(progress));
        return !stop.requested();
    });
    line.end();
    std::string problem;
    if (study.status == StudyStatus::Completed && !arguments.out.empty())
        problem = writeFound(arguments.out, document, study.found);
    if (study.status != StudyStatus::Cancelled && !arguments.csv.empty() && problem.empty())
        problem = writeDesignCsv(arguments.csv, document.task, study);
    if (!problem.empty()) {
        study.status = StudyStatus::Failed;
        study.message = problem;
    }
    print(arguments.json ? designJson(document.task, study) : designText(document.task, study));
    if (study.status == StudyStatus::Completed) return exitDone;
    complain(std::string(name(study.status)) + ": " + study.message);
    return exitNoAnswer;
}

} // namespace touchdown
