// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/study_command.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "app/commands/case_commands.h"
#include "app/commands/study_report.h"
#include "app/terminal/fitted_table.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/stop_signal.h"
#include "core/case_files/case_text.h"
#include "core/formats/toml_document.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

/// The case that a study found, as the text of the case it began with. Returns the problem, or "".
std::string writeFound(const std::string& file, const StudyPlan& plan, const Case& found)
{
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    return writeCaseFile(file, updateCaseText(plan.start.text, found, folder.empty() ? "." : folder));
}

/// Writes all files that were asked for, also of a study that ended early. Returns the problems.
std::vector<std::string> writeFiles(const StudyArguments& arguments, const StudyPlan& plan, const StudyReport& report)
{
    std::vector<std::string> problems;
    const auto keep = [&](std::string problem) {
        if (!problem.empty()) problems.push_back(std::move(problem));
    };
    const Case& c = plan.start.value;
    // Without the files that the text may name, so that the results stand alone.
    if (!arguments.out.empty())
        keep(writeStudy(arguments.out, report, c, updateCaseText(plan.start.text, c), plan.text));
    if (!arguments.csv.empty() && !report.tables.empty()) keep(writeStudyCsv(arguments.csv, report));
    if (!arguments.apply.empty() && report.found) keep(writeFound(arguments.apply, plan, *report.found));
    return problems;
}

int coresOfThis() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

/// Where --out names a case file, the user may expect the case that was found there.
bool outIsGood(const StudyArguments& arguments)
{
    const auto kind = std::ranges::find(studyKinds(), arguments.kind, &StudyKind::name);
    if (kind == studyKinds().end() || !kind->findsCase || !arguments.out.ends_with(".toml")) return true;
    complain("--out: writes findings, charts and tables as HDF5; write the case that was found with --apply " +
             arguments.out);
    return false;
}

/// Prints the study that the arguments name, or one of their case with the defaults.
int printTemplate(const StudyArguments& arguments)
{
    const StudyPlan plan = openStudy(arguments.kind, arguments.study.name, arguments.study.settings);
    complainOf(plan);
    const bool isStudy = !plan.text.empty();
    const char* ignored = !arguments.options.empty()                     ? "--option"
                          : isStudy && !arguments.study.settings.empty() ? "--set"
                                                                         : "";
    const std::string shortcut = arguments.kind == "advise" ? "--tolerance" : "--levels";
    if (*ignored != 0)
        complain(std::string(ignored) + ": has no effect" +
                 (arguments.kind == "advise" || arguments.kind == "convergence" ? ", nor has " + shortcut + "," : "") +
                 " on what --template prints; write it into the file");
    if (!plan.valid() || *ignored != 0) return exitWrongInput;
    if (isStudy) {
        print(plan.text);
        return exitDone;
    }
    std::string head = "case = " + tomlString(arguments.study.name) + "\n";
    for (const std::string& setting : arguments.study.settings) {
        const auto equals = setting.find('=');
        head += "set." + tomlString(setting.substr(0, equals)) + " = " + tomlString(setting.substr(equals + 1)) + "\n";
    }
    print(head + studyTemplate(arguments.kind, plan.start.value));
    return exitDone;
}

} // namespace

void complainOf(const StudyPlan& plan)
{
    for (const auto* list : {&plan.start.warnings, &plan.start.unused})
        for (const InputProblem& warning : *list) complain("warning: " + warning.text());
    for (const InputProblem& problem : plan.problems) complain(problem.text());
}

int studyCommand(const StudyArguments& arguments)
{
    if (arguments.asTemplate) return printTemplate(arguments);
    const StudyPlan plan = openStudy(arguments.kind, arguments.study.name, arguments.study.settings, arguments.options);
    complainOf(plan);
    const bool good = targetsAreGood({{"--out", arguments.out}, {"--csv", arguments.csv}, {"--apply", arguments.apply}},
                                     arguments.study.name);
    if (!plan.valid() || !outIsGood(arguments) || !good) return exitWrongInput;

    const StopSignal stop;
    ProgressLine line(arguments.progress);
    StudyReport report =
        plan.perform(arguments.jobs > 0 ? arguments.jobs : coresOfThis(), [&](const StudyProgress& progress) {
            line.show({progress.share, progress.doing});
            return !stop.requested();
        });
    line.end();
    const std::vector<std::string> problems = writeFiles(arguments, plan, report);
    if (!problems.empty()) {
        report.status = StudyStatus::Failed;
        report.message = problems.front();
    }
    print(arguments.json ? studyJson(report) : studyText(report, outputWidth()));
    if (report.status != StudyStatus::Completed) {
        complain(std::string(name(report.status)) + ": " + report.message);
        return exitNoAnswer;
    }
    if (arguments.apply.empty() || report.found) return exitDone;
    complain("--apply: nothing is written to " + arguments.apply +
             ": no case has this answer; the findings name the command that has it");
    return exitNoAnswer;
}

} // namespace touchdown
