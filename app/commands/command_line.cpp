// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/command_line.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/commands/case_commands.h"
#include "app/commands/convergence_command.h"
#include "app/commands/convert_command.h"
#include "app/commands/describe_command.h"
#include "app/commands/design_command.h"
#include "app/commands/modes_command.h"
#include "app/commands/run_command.h"
#include "app/commands/steady_command.h"
#include "app/commands/study_command.h"
#include "app/commands/validate_command.h"
#include "app/terminal/mistaken_words.h"
#include "core/studies/study_plan.h"

namespace touchdown {
namespace {

void addCase(CLI::App& command, CaseArguments& arguments)
{
    command.add_option("CASE", arguments.name, "A case file, or the name of a sample case (see `touchdown list`)");
    command.add_option("--set", arguments.settings, "Changes a value of the case, such as springs.cutoff=\"0.3 nm\"")
        ->type_name("KEY=VALUE");
}

// `--set a=1 fig10a`: the option takes all that follows, so the last one may be the case.
void findCase(const CLI::App& command, std::string& name, const std::vector<std::vector<std::string>*>& lists,
              const char* wanted = "CASE, a file or a sample case of `touchdown list`,")
{
    for (std::vector<std::string>* list : lists) {
        if (!name.empty() || list->empty() || list->back().find('=') != std::string::npos) continue;
        name = list->back();
        list->pop_back();
    }
    if (name.empty()) throw CLI::RequiredError(command.get_name() + ": " + wanted);
}

void findCase(const CLI::App& command, CaseArguments& arguments)
{
    findCase(command, arguments.name, {&arguments.settings});
}

// Arguments of all studies that give a report.
void addStudy(CLI::App& command, StudyArguments& arguments, const std::string& name)
{
    command.add_option(name, arguments.study.name, "A study, a case, or the name of a sample (see `touchdown list`)");
    command.add_option("--set", arguments.study.settings, "Changes a value of the case, such as run.duration=\"1 ms\"")
        ->type_name("KEY=VALUE");
    command.add_option("--option", arguments.options, "Changes a value of the study, such as repeats=3")
        ->type_name("KEY=VALUE");
    command.add_option("--out", arguments.out, "Writes findings, charts and tables as HDF5")->type_name("FILE.h5");
    command.add_option("--csv", arguments.csv, "Writes the first table as CSV")->type_name("FILE.csv");
    command.add_option("--jobs", arguments.jobs, "Number of solutions in parallel; default: the number of cores")
        ->check(CLI::Range(1, 64));
    command.add_flag("--progress", arguments.progress, "Shows progress even when standard error is no terminal");
    command.add_flag("--template", arguments.asTemplate,
                     "Prints the study, or a study of the case with every key, as the start of a file");
}

std::vector<std::string> namesOf(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

std::string joined(const std::vector<std::string>& words, const std::string& between)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

// `touchdown help run` asks as `touchdown run --help` does.
std::vector<std::string> argumentsOf(int argc, char** argv)
{
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    if (!arguments.empty() && arguments.front() == "help") {
        arguments.erase(arguments.begin());
        arguments.emplace_back("--help");
    }
    return arguments;
}

// --tolerance is short for --option tolerance=VALUE.
void addTolerance(const std::string& tolerance, std::vector<std::string>& options)
{
    for (const std::string& option : options) {
        std::string key = option.substr(0, option.find('='));
        key.erase(key.find_last_not_of(' ') + 1);
        if (key == "tolerance")
            throw CLI::ParseError("advise: --tolerance " + tolerance + " and --option " + option +
                                      " are one value; give it once",
                                  CLI::ExitCodes::ExcludesError);
    }
    options.push_back("tolerance=" + tolerance);
}

// The first word must be a command, the word behind "study" a kind of study.
void checkWords(const CLI::App& app, const std::vector<std::string>& arguments)
{
    const CommandWords known{namesOf(app), namesOf(*app.get_subcommand("study"))};
    if (arguments.empty()) throw CLI::RequiredError("A command (" + joined(known.commands, ", ") + ")");
    if (arguments == std::vector<std::string>{"study"})
        throw CLI::RequiredError("study: a kind (" + joined(known.kinds, ", ") + ")");
    if (const std::string problem = mistakenWord(arguments, known); !problem.empty())
        throw CLI::ParseError(problem, CLI::ExitCodes::ExtrasError);
}

// Names the arguments that the command did not take.
std::string notTakenBy(const CLI::App& app)
{
    const CLI::App* command = &app;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    std::vector<std::string> options;
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    return notTaken(command->get_name(), app.remaining(true), options);
}

// A full disk or a closed pipe behind standard output shows only when the last text is written.
int finishOutput(int code)
{
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    complain("cannot write to standard output: " + std::generic_category().message(errno));
    return exitNoAnswer;
}

} // namespace

int commandLine(int argc, char** argv)
{
    CLI::App app("Touchdown: dynamics of hard-disk sliders at the edge of contact", "touchdown");
    app.set_version_flag("--version", "touchdown " TOUCHDOWN_VERSION);
    app.require_subcommand(0, 1); // none is refused below, after what is misspelt
    app.footer("Exit codes: 0 done; 1 the calculation ended without a valid answer; 2 wrong input or arguments.");
    bool json = false;
    const auto addJson = [&json](CLI::App& command) {
        command.add_flag("--json", json, "One JSON object on standard output, numbers in SI");
    };

    RunArguments runArguments;
    CLI::App& run = *app.add_subcommand("run", "Simulates a case");
    addCase(run, runArguments.caseArguments);
    run.add_option("--out", runArguments.out, "Writes all results as HDF5")->type_name("FILE.h5");
    run.add_option("--csv", runArguments.csv, "Writes the time series as CSV")->type_name("FILE.csv");
    run.add_flag("--progress", runArguments.progress, "Shows progress even when standard error is no terminal");
    addJson(run);

    SteadyArguments steadyArguments;
    CLI::App& steady = *app.add_subcommand("steady", "Finds the static flying attitude of a film case");
    addCase(steady, steadyArguments.caseArguments);
    steady.add_option("--out", steadyArguments.out, "Writes forces and fields as HDF5")->type_name("FILE.h5");
    steady.add_flag("--fixed-attitude", steadyArguments.fixedAttitude, "Solves the film at the initial attitude only");
    steady.add_flag("--progress", steadyArguments.progress, "Shows progress even when standard error is no terminal");
    addJson(steady);

    ModesArguments modesArguments;
    CLI::App& modes = *app.add_subcommand("modes", "Finds the air bearing modes about the static attitude");
    addCase(modes, modesArguments.caseArguments);
    modes.add_flag("--progress", modesArguments.progress, "Shows progress even when standard error is no terminal");
    addJson(modes);

    ConvergenceArguments convergenceArguments;
    CLI::App& study = *app.add_subcommand("study", "Solves a case many times and reports what that shows");
    study.require_subcommand(0, 1); // as above
    CLI::App& convergence = *study.add_subcommand(
        "convergence", "How the closest approach of a contact case depends on the cells of its patch");
    addCase(convergence, convergenceArguments.caseArguments);
    convergence.add_option("--out", convergenceArguments.out, "Writes the table as HDF5")->type_name("FILE.h5");
    convergence.add_option("--csv", convergenceArguments.csv, "Writes the table as CSV")->type_name("FILE.csv");
    convergence
        .add_option("--levels", convergenceArguments.options.levels, "Levels of cells, the finest half of elastic.cell")
        ->check(CLI::Range(fewestLevels, mostLevels));
    convergence.add_option("--jobs", convergenceArguments.options.jobs, "Levels that are solved at a time")
        ->check(CLI::Range(1, 64));
    addJson(convergence);
    DesignArguments designArguments;
    CLI::App& design =
        *study.add_subcommand("design", "Searches for values of a film case with which it flies as wanted");
    design.add_option("FILE", designArguments.study.name, "A study: its case, what may change, and what is wanted");
    design
        .add_option("--set", designArguments.study.settings,
                    "Changes a value of the case, such as film.nodes=\"97, 97\"")
        ->type_name("KEY=VALUE");
    design.add_option("--out", designArguments.out, "Writes the case with the values that were found")
        ->type_name("FILE.toml");
    design.add_option("--csv", designArguments.csv, "Writes the steps of the search as CSV")->type_name("FILE.csv");
    design.add_flag("--template", designArguments.asTemplate, "Prints the study, to begin a file with");
    design.add_flag("--progress", designArguments.progress, "Shows progress even when standard error is no terminal");
    addJson(design);

    StudyArguments studyArguments;
    std::vector<CLI::App*> kinds;
    for (const StudyKind& kind : studyKinds()) {
        CLI::App& command = *study.add_subcommand(kind.name, kind.help);
        addStudy(command, studyArguments, "FILE");
        addJson(command);
        kinds.push_back(&command);
    }
    std::string tolerance;
    CLI::App& advise = *app.add_subcommand("advise", "Finds the simplest model of a film case whose error is within a tolerance");
    addStudy(advise, studyArguments, "CASE");
    advise.add_option("--tolerance", tolerance, "Largest error of the advised model, such as 1%");
    advise.add_option("--apply", studyArguments.apply, "Writes the advised case")->type_name("FILE.toml");
    addJson(advise);

    std::string from;
    std::string to;
    CLI::App& convert = *app.add_subcommand(
        "convert", "Converts between case files and files of the established program (rail.dat, run.dat, .cml)");
    convert.add_option("FROM", from, "A case file, a sample case, a folder with a rail.dat, or a .cml archive")
        ->required();
    convert.add_option("TO", to, "A .toml case file, a .cml archive, or a folder for rail.dat and run.dat")->required();

    CaseArguments validated;
    CLI::App& validate = *app.add_subcommand("validate", "Checks a case or a study and lists every problem");
    addCase(validate, validated);
    addJson(validate);

    CLI::App& list = *app.add_subcommand("list", "Lists the sample cases and sample studies");
    addJson(list);

    std::vector<std::string> key;
    CLI::App& describe =
        *app.add_subcommand("describe", "Explains the keys of a case and of studies: unit, range, default, source");
    describe.add_option("KEY", key, "A key such as springs.cutoff, a group such as springs, or study.KIND")
        ->expected(0, 3);
    addJson(describe);

    try {
        std::vector<std::string> arguments = argumentsOf(argc, argv);
        checkWords(app, arguments);
        std::ranges::reverse(arguments); // as CLI11 wants them
        app.parse(std::move(arguments));
        if (app.get_subcommands().empty()) checkWords(app, {});
        if (run.parsed()) findCase(run, runArguments.caseArguments);
        if (steady.parsed()) findCase(steady, steadyArguments.caseArguments);
        if (modes.parsed()) findCase(modes, modesArguments.caseArguments);
        if (study.parsed() && study.get_subcommands().empty()) checkWords(app, {"study"});
        if (convergence.parsed()) findCase(convergence, convergenceArguments.caseArguments);
        if (design.parsed()) findCase(design, designArguments.study.name, {&designArguments.study.settings}, "FILE");
        kinds.push_back(&advise);
        for (const CLI::App* kind : kinds) {
            if (!kind->parsed()) continue;
            studyArguments.kind = kind->get_name();
            findCase(*kind, studyArguments.study.name, {&studyArguments.study.settings, &studyArguments.options},
                     "FILE, a study or a case, or a sample of `touchdown list`,");
        }
        if (!tolerance.empty()) addTolerance(tolerance, studyArguments.options);
        if (validate.parsed()) findCase(validate, validated);
    } catch (const CLI::ExtrasError& error) {
        app.exit(CLI::ParseError(notTakenBy(app), error.get_exit_code()));
        return exitWrongInput;
    } catch (const CLI::ParseError& error) {
        return finishOutput(app.exit(error) == 0 ? exitDone : exitWrongInput);
    }
    runArguments.json = steadyArguments.json = modesArguments.json = convergenceArguments.json = designArguments.json =
        studyArguments.json = json;
    if (run.parsed()) return finishOutput(runCommand(runArguments));
    if (steady.parsed()) return finishOutput(steadyCommand(steadyArguments));
    if (modes.parsed()) return finishOutput(modesCommand(modesArguments));
    if (convergence.parsed()) return finishOutput(convergenceCommand(convergenceArguments));
    if (design.parsed()) return finishOutput(designCommand(designArguments));
    if (!studyArguments.kind.empty()) return finishOutput(studyCommand(studyArguments));
    if (convert.parsed()) return finishOutput(convertCommand(from, to));
    if (validate.parsed()) return finishOutput(validateCommand(validated, json));
    if (list.parsed()) return finishOutput(listCommand(json));
    return finishOutput(describeCommand(joined(key, "."), json));
}

} // namespace touchdown
