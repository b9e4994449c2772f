// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program `touchdown`: parses the arguments and calls the command.
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/commands/case_commands.h"
#include "app/commands/describe_command.h"
#include "app/commands/lesson_command.h"
#include "app/commands/modes_command.h"
#include "app/commands/run_command.h"
#include "app/commands/steady_command.h"
#include "app/commands/study_command.h"
#include "app/terminal/console.h"
#include "app/terminal/freed_memory.h"
#include "app/terminal/mistaken_words.h"
#include "app/terminal/refusal.h"
#include "app/terminal/standard_streams.h"
#include "app/terminal/stop_signals.h"
#include "core/formats/quotation.h"
#include "core/formats/words.h"
#include "core/studies/reader_program.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

void addPaths(CLI::App& command, CommandArguments& arguments)
{
    command.add_flag("--allow-paths", arguments.allowPaths,
                     "Also reads files that a case or a study names outside its own folder");
}

void addCase(CLI::App& command, CommandArguments& arguments,
             const char* help = "A case file, or the name of a sample case (see `touchdown list`)")
{
    addPaths(command, arguments);
    command.add_option("CASE", arguments.name, help);
    command.add_option("--set", arguments.settings, "Changes a value of the case, such as springs.cutoff=\"0.3 nm\"")
        ->type_name("KEY=VALUE");
}

/// `--set a=1 fig10a`: the option takes all words that follow, so its last one may be the case.
void findCase(const CLI::App& command, CommandArguments& arguments, const char* wanted)
{
    for (std::vector<std::string>* list : {&arguments.settings, &arguments.options}) {
        if (!arguments.name.empty() || list->empty() || list->back().find('=') != std::string::npos) continue;
        arguments.name = list->back();
        list->pop_back();
    }
    if (arguments.name.empty()) throw CLI::RequiredError(command.get_name() + ": " + wanted);
}

/// An empty name, as of a variable of the shell that is not set, is refused: nothing would be written.
std::string emptyNameProblem(const std::string& file) { return file.empty() ? "the name of a file is empty" : ""; }

/// An option with the name of a file.
void addFile(CLI::App& command, const char* option, std::string& file, const char* help, const char* type)
{
    command.add_option(option, file, help)->type_name(type)->check(emptyNameProblem);
}

void addProgress(CLI::App& command, CommandArguments& arguments)
{
    command.add_flag("--progress", arguments.progress, "Shows progress even when standard error is no terminal");
}

void addJson(CLI::App& command, CommandArguments& arguments)
{
    command.add_flag("--json", arguments.json, "One JSON object on standard output, numbers in SI");
}

/// Arguments of all studies.
void addStudy(CLI::App& command, CommandArguments& arguments, const std::string& name, const StudyKind& kind)
{
    command.add_option(name, arguments.name, "A study, a case, or the name of a sample (see `touchdown list`)");
    addPaths(command, arguments);
    command.add_option("--set", arguments.settings, "Changes a value of the case, such as run.duration=\"1 ms\"")
        ->type_name("KEY=VALUE");
    command.add_option("--option", arguments.options, "Changes a value of the study, such as repeats=3")
        ->type_name("KEY=VALUE");
    addFile(command, "--out", arguments.out, "Writes findings, charts and tables as HDF5", "FILE.h5");
    addFile(command, "--csv", arguments.csv, "Writes the first table as CSV", "FILE.csv");
    command.add_option("--part", arguments.part, "Of a list, such as a sweep: items K, K + N, K + 2 N, ... alone")
        ->type_name("K/N");
    command.add_option("--join", arguments.join, "Of a list: joins the files of all its parts")
        ->type_name("FILE.h5 ...");
    command.add_flag("--resume", arguments.resume, "Of a list: goes on in the file of --out, without the items in it");
    command.add_option("--engine", arguments.engine, "Of a list: solves its parts elsewhere; --out is then a folder")
        ->type_name("local|slurm|command");
    command.add_option("--parts", arguments.parts, "Number of parts for --engine")->check(CLI::Range(1, 100000));
    command.add_option("--sbatch", arguments.sbatch, "Options of sbatch, such as \"--time=1:00:00 --partition=long\"")
        ->type_name("\"...\"");
    command.add_option("--submit", arguments.submit, "For --engine command, such as \"parallel -j8\"")
        ->type_name("\"...\"");
    if (kind.findsCase)
        addFile(command, "--apply", arguments.apply, "Writes the case that the study found", "FILE.toml");
    command.add_option("--jobs", arguments.jobs, "Number of solutions in parallel; default: the number of cores")
        ->check(CLI::Range(1, 64));
    addProgress(command, arguments);
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

/// `touchdown study FILE` where the file names its kind.
void addKind(std::vector<std::string>& words)
{
    if (words.size() < 2 || words.front() != "study") return;
    const auto isKind = [](const std::string& word) {
        return std::ranges::find(studyKinds(), word, &StudyKind::name) != studyKinds().end();
    };
    if (std::ranges::any_of(words, isKind) || (!words[1].starts_with("--join") && words[1].starts_with('-'))) return;
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i - 1].starts_with("--") && words[i - 1] != "--join") continue; // the value of an option
        if (const std::string kind = studyKindIn(words[i]); isKind(kind)) {
            words.insert(words.begin() + 1, kind);
            return;
        }
    }
}

/// `touchdown help run` means `touchdown run --help`.
std::vector<std::string> argumentsOf(int argc, char** argv)
{
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    if (!arguments.empty() && arguments.front() == "help") {
        arguments.erase(arguments.begin());
        arguments.emplace_back("--help");
    }
    return arguments;
}

/// An option of the command line that stands for a key of the study: --tolerance, --levels.
void addShortcut(const std::string& kind, const std::string& key, const std::string& value,
                 std::vector<std::string>& options)
{
    if (value.empty()) return;
    for (const std::string& option : options)
        if (trimmed(std::string_view(option).substr(0, option.find('='))) == key)
            throw CLI::ParseError(kind + ": --" + key + ' ' + value + " and --option " + option +
                                      " are one value; give it once",
                                  CLI::ExitCodes::ExcludesError);
    options.push_back(key + '=' + value);
}

/// The first word must be a command, the word after "study" a kind of study.
void checkWords(const CLI::App& app, const std::vector<std::string>& arguments)
{
    const CommandWords known{namesOf(app), namesOf(*app.get_subcommand("study"))};
    if (arguments.empty()) throw CLI::RequiredError("A command (" + joined(known.commands, ", ") + ")");
    if (arguments == std::vector<std::string>{"study"})
        throw CLI::RequiredError("study: a kind (" + joined(known.kinds, ", ") + ")");
    if (const std::string problem = mistakenWord(arguments, known); !problem.empty())
        throw CLI::ParseError(problem, CLI::ExitCodes::ExtrasError);
}

/// Names the arguments that the command did not take.
std::string notTakenBy(const CLI::App& app)
{
    const CLI::App* command = &app;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    std::vector<std::string> options;
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    return notTaken(command->get_name(), app.remaining(true), options);
}

/// A full disk or a closed pipe behind standard output is noticed only when the last text is written.
int finishOutput(int code)
{
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    complain("cannot write to standard output: " + std::generic_category().message(errno));
    return exitNoAnswer;
}

/// The other commands have no step at which they could stop: a signal ends them at once.
bool runsLong(const std::string& command)
{
    constexpr std::array commands{"run", "steady", "modes", "study", "advise"};
    return std::ranges::find(commands, command) != commands.end();
}

/// Prints what CLI11 has to say to wrong arguments, --help or --version. Returns its exit code.
int showTexts(const CLI::App& app, const CLI::ParseError& error)
{
    std::ostringstream out, lines;
    const int code = app.exit(error, out, lines);
    print(out.str());
    std::istringstream text(lines.str());
    for (std::string line; std::getline(text, line);) complain(line);
    return code;
}

/// The message of CLI11, which also names --help, and the object of `--json`.
int refuseArguments(const CLI::App& app, const CLI::ParseError& error, bool json)
{
    showTexts(app, error);
    if (json) print(refusalJson({{"", 0, "", error.what()}}));
    return finishOutput(exitWrongInput);
}

/// Parses the arguments, runs the command and returns an ExitCode.
int commandLine(int argc, char** argv)
{
    std::vector<std::string> words = argumentsOf(argc, argv);
    addKind(words);
    std::optional<StopSignals> signals;
    if (!words.empty() && runsLong(words.front())) {
        signals.emplace();
        std::signal(SIGPIPE, SIG_IGN); // a reader that leaves is a problem of its writer: other files are completed
    }
    CLI::App app("Touchdown: dynamics of hard-disk sliders at the edge of contact", "touchdown");
    app.set_version_flag("--version", "touchdown " TOUCHDOWN_VERSION);
    app.require_subcommand(0, 1); // a missing one is refused below, after misspelt words
    app.footer("Exit codes: 0 done; 1 the calculation ended without a valid answer; 2 wrong input or arguments.");
    CommandArguments arguments;

    CLI::App& run = *app.add_subcommand("run", "Simulates a case");
    addCase(run, arguments, "A case file, the name of a sample case (see `touchdown list`), or the results of a run");
    addFile(run, "--out", arguments.out, "Writes all results as HDF5", "FILE.h5");
    addFile(run, "--csv", arguments.csv, "Writes the time series as CSV, when the run ends", "FILE.csv");
    run.add_option("--checkpoint", arguments.checkpointEach,
                   "Seconds between the states in --out, from which the run can be continued; default: 1")
        ->type_name("SECONDS");
    run.add_flag("--resume", arguments.resumeRun,
                 "Continues the run of a results file; --resume=anyway: also one of another version or machine");
    addProgress(run, arguments);
    addJson(run, arguments);

    CLI::App& steady = *app.add_subcommand("steady", "Finds the static flying attitude of a film case");
    addCase(steady, arguments);
    addFile(steady, "--out", arguments.out, "Writes forces and fields as HDF5", "FILE.h5");
    steady.add_flag(
        "--fixed-attitude", arguments.fixedAttitude,
        "Solves the film at the initial attitude only; refused with rails inside the disk and no contact law");
    addProgress(steady, arguments);
    addJson(steady, arguments);

    CLI::App& modes = *app.add_subcommand("modes", "Finds the air bearing modes about the static attitude");
    addCase(modes, arguments);
    addProgress(modes, arguments);
    addJson(modes, arguments);

    std::string tolerance, levels;
    CLI::App& study = *app.add_subcommand("study", "Solves a case many times and reports what that shows");
    study.require_subcommand(0, 1); // as above
    std::vector<CLI::App*> kinds;
    const auto addKind = [&](CLI::App& parent, const StudyKind& kind, const std::string& help) {
        CLI::App& command = *parent.add_subcommand(kind.name, help);
        addStudy(command, arguments, &parent == &app ? "CASE" : "FILE", kind);
        if (kind.name == "advise" && &parent == &app)
            command.add_option("--tolerance", tolerance, "Largest error of the advised model, such as 1%");
        if (kind.name == "convergence")
            command.add_option("--levels", levels,
                               "Levels of cells of a contact case, the finest half of elastic.cell");
        addJson(command, arguments);
        kinds.push_back(&command);
    };
    for (const StudyKind& kind : studyKinds()) addKind(study, kind, kind.help);
    for (const StudyKind& kind : studyKinds())
        if (kind.name == "advise")
            addKind(app, kind, "Finds the cheapest model of a film case whose error is within a tolerance");

    std::string to;
    CLI::App& convert = *app.add_subcommand(
        "convert", "Converts between case files and files of the established program (rail.dat, run.dat, .cml)");
    addPaths(convert, arguments);
    convert
        .add_option("FROM", arguments.name, "A case file, a sample case, a folder with a rail.dat, or a .cml archive")
        ->required();
    convert
        .add_option("TO", to,
                    "A .toml case file, a .cml archive, a .dxf drawing of the surface, or a folder for rail.dat and "
                    "run.dat")
        ->required()
        ->check(emptyNameProblem);
    bool force = false;
    convert.add_flag("--force", force, "Replaces the archive, or the rail.dat and run.dat, that TO names");

    CLI::App& validate = *app.add_subcommand("validate", "Checks a case or a study and lists every problem");
    addCase(validate, arguments);
    addJson(validate, arguments);

    std::string listed;
    CLI::App& list =
        *app.add_subcommand("list", "Lists the sample cases and sample studies, the lesson, or the demonstrations");
    list.add_option("WHAT", listed,
                    "\"lesson\" for a lesson in six steps, \"demonstrations\" for the figures of the paper; without it "
                    "the samples")
        ->check([](const std::string& word) {
            return word == "lesson" || word == "demonstrations"
                       ? std::string()
                       : inQuotes(word) + " is no list; `touchdown list lesson` prints the lesson, `touchdown list "
                                          "demonstrations` the figures of the paper";
        });
    addJson(list, arguments);

    std::vector<std::string> key;
    CLI::App& describe =
        *app.add_subcommand("describe", "Explains the keys of a case and of studies: unit, range, default, source");
    describe.add_option("KEY", key, "A key such as springs.cutoff, a group such as springs, or study.KIND")
        ->expected(0, 3);
    addJson(describe, arguments);

    // An option that is not understood may stand before --json.
    const bool json = std::ranges::find(words, "--json") != words.end();
    try {
        checkWords(app, words);
        app.parse(std::vector<std::string>(words.rbegin(), words.rend())); // as CLI11 wants them
        if (app.get_subcommands().empty()) checkWords(app, {});
        for (const CLI::App* command : {&run, &steady, &modes, &validate})
            if (command->parsed()) findCase(*command, arguments, "CASE, a file or a sample case of `touchdown list`,");
        if (study.parsed() && study.get_subcommands().empty()) checkWords(app, {"study"});
        for (const CLI::App* kind : kinds) {
            if (!kind->parsed()) continue;
            arguments.kind = kind->get_name();
            // The parts hold the study.
            if (arguments.name.empty() && !arguments.join.empty()) arguments.name = arguments.join.front();
            findCase(*kind, arguments, "FILE, a study or a case, or a sample of `touchdown list`,");
        }
        addShortcut(arguments.kind, "tolerance", tolerance, arguments.options);
        addShortcut(arguments.kind, "levels", levels, arguments.options);
    } catch (const CLI::ExtrasError& error) {
        return refuseArguments(app, CLI::ParseError(notTakenBy(app), error.get_exit_code()), json);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return finishOutput(showTexts(app, error)); // --help, --version
        return refuseArguments(app, error, json);
    }
    const auto perform = [&] {
        if (run.parsed()) return runCommand(arguments);
        if (steady.parsed()) return steadyCommand(arguments);
        if (modes.parsed()) return modesCommand(arguments);
        if (!arguments.kind.empty()) return studyCommand(arguments);
        if (convert.parsed()) return convertCommand(arguments, to, force);
        if (validate.parsed()) return validateCommand(arguments);
        if (list.parsed()) {
            if (listed.empty()) return listCommand(arguments.json);
            return listed == "lesson" ? lessonCommand(arguments.json) : demonstrationsCommand(arguments.json);
        }
        return describeCommand(joined(key, "."), arguments.json);
    };
    int code = exitDone;
    try {
        if (!fitsInMemory([&] { code = perform(); })) code = fail(outOfMemory(arguments.name), json);
    } catch (const std::exception& error) {
        code = fail(error.what(), json);
    }
    return finishOutput(code);
}

} // namespace
} // namespace touchdown

int main(int argc, char** argv)
{
    if (const auto code = touchdown::runReader(argc, argv)) return *code;
    touchdown::keepStandardStreams();
    touchdown::keepFreedMemory();
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond the limit of its size is a problem of its writer, as a full disk is
    try {
        return touchdown::commandLine(argc, argv);
    } catch (const std::exception& error) {
        touchdown::complain(std::string("touchdown: ") + error.what());
        return touchdown::exitNoAnswer;
    }
}
