// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/film_convergence_task.h"

#include <algorithm>
#include <optional>

#include "core/case/case_document.h"
#include "core/case/parameters.h"
#include "core/formats/input_problem.h"
#include "core/formats/quotation.h"
#include "core/studies/convergence/established_film.h"
#include "core/studies/study/study_head.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int fewestLines = 33, mostLines = 2049;
constexpr int coarsestOwn = 16; // the lines of a grid are a multiple of this, and one

const std::vector<std::string> defaultGrids{"49", "65", "97", "129", "193", "257", "385"};

const char* uniformPowerLaw = "power-law, uniform";

std::string linesText() { return "must be 16 k + 1 lines, " + wholeRangeText(fewestLines, mostLines); }

std::string text(const Case& c, const char* key) { return toText(c, *findParameter(key)); }

void readSliders(StudyReader& reader, FilmConvergenceTask& task)
{
    task.sliders = {reader.start()};
    for (const std::string& name : reader.texts("cases").value_or(std::vector<std::string>{})) {
        const CaseDocument further = openFurtherCase(reader, name);
        for (const InputProblem& problem : further.problems) reader.add("cases", problem.text());
        if (!further.valid()) continue;
        if (further.value.model == ModelKind::Film)
            task.sliders.push_back(further.value);
        else
            reader.add("cases", inQuotes(name) + " is no case of model \"film\"");
    }
}

void readGrids(StudyReader& reader, FilmConvergenceTask& task)
{
    const auto isGood = [](int lines) { return (lines - 1) % coarsestOwn == 0; };
    std::vector<double> grids;
    if (reader.has("grids"))
        grids = reader.numbers("grids", "", "", fewestLines, mostLines).value_or(std::vector<double>{});
    else
        for (const std::string& each : defaultGrids) grids.push_back(std::stod(each));
    for (const double lines : grids) {
        task.grids.push_back(static_cast<int>(lines));
        if (task.grids.back() != lines || !isGood(task.grids.back())) {
            reader.add("grids", linesText());
            return;
        }
    }
    std::ranges::sort(task.grids);
    task.grids.erase(std::unique(task.grids.begin(), task.grids.end()), task.grids.end());
    task.reference = reader.integer("reference");
    if (!isGood(task.reference))
        reader.add("reference", linesText());
    else if (!task.grids.empty() && task.reference <= task.grids.back())
        reader.add("reference", "must have more lines than each of the grids, of which one has " +
                                    std::to_string(task.grids.back()));
}

/// The problem of a slider that does not allow the changes.
std::optional<InputProblem> problemOf(const FilmConvergenceTask& task, const std::vector<CaseSetting>& changes,
                                      OutsidePaths outside)
{
    for (Case slider : task.sliders)
        if (auto problem = changeCase(slider, changes, outside)) {
            if (task.sliders.size() > 1) problem->message += " (" + slider.title + ")";
            return problem;
        }
    for (const CaseSetting& change : changes)
        if (change.key == "film.nodes" || change.key == "steady.fixed_attitude")
            return InputProblem{"", 0, change.key, "is what the study itself sets; take grids and fixed_attitude"};
    return {};
}

void readMethodsOf(StudyReader& reader, FilmConvergenceTask& task)
{
    const Case& c = reader.start();
    const std::string own = text(c, "film.scheme") + ", " + text(c, "film.grid");
    task.methods = {steadyMethod(own, {})};
    const std::vector<std::string> tables = reader.tables("method");
    for (const std::string& table : tables) {
        const std::string name = reader.text(table + ".name").value_or("");
        const std::vector<CaseSetting> changes = reader.settings(table + ".set");
        if (name.empty())
            reader.add(table, "has no name");
        else if (std::ranges::find(task.methods, name, &FilmMethod::name) != task.methods.end())
            reader.add(table + ".name", inQuotes(name) + " is the name of another method, too");
        if (const auto problem = problemOf(task, changes, reader.outsidePaths()))
            reader.addOfSettings(table, {table + ".set"}, *problem);
        task.methods.push_back(steadyMethod(name, changes));
    }
    if (tables.empty() && own != uniformPowerLaw)
        task.methods.push_back(steadyMethod(uniformPowerLaw, {{"film.scheme", "power-law"}, {"film.grid", "uniform"}}));
    if (reader.flag("established")) task.methods.push_back(establishedMethod());
}

} // namespace

FilmConvergenceTask readFilmConvergence(StudyReader& reader)
{
    FilmConvergenceTask task;
    task.fixedAttitude = reader.flag("fixed_attitude");
    readSliders(reader, task);
    readGrids(reader, task);
    readMethodsOf(reader, task);
    return task;
}

StudyForm filmConvergenceForm(const Case& c)
{
    return {.keys = {
                booleanKey("fixed_attitude", c.steady.fixedAttitude,
                           "true: errors of the net force at the initial attitude; false: of the minimum spacing of "
                           "the flying slider"),
                listKey("grids", defaultGrids, "grids that are compared: lines in each direction, 16 k + 1"),
                integerKey("reference", FilmConvergenceTask{}.reference, fewestLines, mostLines,
                           "lines of the grid against which errors are measured"),
                booleanKey("established", true,
                           "true: also the discretisation of the established program, which states no error"),
                listKey("cases", {},
                        "further sliders: files of cases, relative to the study's file, or names of "
                        "sample cases; errors are then summarized over all sliders"),
                inList(textKey("method.name", {}, "", "name in charts and tables")),
                inList(settingsKey("method.set", "changes of the cases, such as { \"film.scheme\" = \"upwind\" }")),
            }};
}

} // namespace touchdown
