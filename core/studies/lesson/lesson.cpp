// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/lesson/lesson.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/case/case.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/formats/quotation.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

/// The text of a key that must be there.
std::string requiredText(StudyReader& reader, const std::string& key)
{
    const bool given = reader.has(key);
    const std::string text = reader.text(key).value_or("");
    if (!given) reader.add(key, "is missing");
    return text;
}

LessonRun readRun(StudyReader& reader, const std::string& table)
{
    LessonRun run;
    run.purpose = requiredText(reader, table + ".purpose");
    const std::string key = table + ".study";
    if (!reader.has(key)) {
        run.name = requiredText(reader, table + ".case");
        run.settings = reader.settings(table + ".set");
        if (std::ranges::find(sampleCases(), run.name, &SampleCase::name) == sampleCases().end())
            reader.add(table + ".case", inQuotes(run.name) + " is no sample case");
        return run;
    }
    run.name = requiredText(reader, key);
    const auto study = std::ranges::find(sampleStudies(), run.name, &SampleStudy::name);
    if (study != sampleStudies().end())
        run.kind = study->kind;
    else
        reader.add(key, inQuotes(run.name) + " is no sample study");
    return run;
}

/// The case of the first run of a step; the default one where there is none.
Case firstCase(StudyReader& reader, const std::string& table, const std::vector<LessonRun>& runs)
{
    if (runs.empty() || !runs.front().kind.empty()) return {};
    Case c = openCase(runs.front().name).value;
    if (const auto problem = changeCase(c, runs.front().settings)) reader.add(table + ".run[1].set", problem->text());
    return c;
}

/// Which of a step's runs a key names, counted from 0; not a study.
std::size_t readNumberOfRun(StudyReader& reader, const std::string& key, const std::vector<LessonRun>& runs)
{
    const double number = reader.number(key, "1", "1", 1.0, static_cast<double>(runs.size())).value_or(1.0);
    const std::size_t run = static_cast<std::size_t>(number) - 1;
    if (number != std::floor(number)) reader.add(key, "is not a whole number");
    if (run < runs.size() && !runs[run].kind.empty()) reader.add(key, "is a study, without curves over time");
    return run;
}

LessonStage readStage(StudyReader& reader, const std::string& table, const std::vector<LessonRun>& runs)
{
    LessonStage stage;
    stage.plots = reader.texts(table + ".plots").value_or(std::vector<std::string>());
    if (!reader.has(table + ".plots")) reader.add(table + ".plots", "is missing");
    stage.from = reader.number(table + ".from", "s", "ms", 0.0, 1.0).value_or(0.0);
    stage.until = reader.number(table + ".until", "s", "ms", 0.0, 1.0).value_or(0.0);
    stage.lowest = reader.number(table + ".lowest", "m", "nm", -1e-6, 1e-6).value_or(0.0);
    stage.highest = reader.number(table + ".highest", "m", "nm", -1e-6, 1e-6).value_or(0.0);
    for (const auto& [low, high, key] :
         {std::tuple(stage.from, stage.until, ".until"), std::tuple(stage.lowest, stage.highest, ".highest")})
        if (high < low) reader.add(table + key, "is below the other end of its axis");
    stage.side = reader.boolean(table + ".side").value_or(false);
    stage.spectrum = reader.boolean(table + ".spectrum").value_or(false);
    if (reader.has(table + ".parts")) stage.parts = readNumberOfRun(reader, table + ".parts", runs);
    return stage;
}

/// `c`: the case of the step's first run.
LiveValue readLive(StudyReader& reader, const std::string& table, const Case& c)
{
    LiveValue live;
    const std::string keys = table + ".keys";
    live.keys = reader.texts(keys).value_or(std::vector<std::string>());
    if (live.keys.empty()) {
        if (!reader.has(keys)) reader.add(keys, "is missing");
        return live;
    }
    for (const std::string& key : live.keys)
        if (const Parameter* parameter = findParameter(key); !parameter || !std::isfinite(numberOf(*parameter, c)))
            reader.add(keys, inQuotes(key) + " is no parameter with a number");
        else if (!parameter->used(c))
            reader.add(keys, unusedMessage(c, *parameter));
    const Parameter* parameter = findParameter(live.keys.front());
    if (!parameter) return live;
    const auto end = [&](const std::string& key) {
        if (!reader.has(table + key)) reader.add(table + key, "is missing");
        return reader
            .number(table + key, parameter->unit, parameter->displayUnit, parameter->minimum, parameter->maximum)
            .value_or(0.0);
    };
    live.from = end(".from");
    live.until = end(".until");
    live.label = reader.text(table + ".label").value_or("");
    if (const double own = numberOf(*parameter, c); own < live.from || own > live.until)
        reader.add(table + ".from", "and the other end do not enclose the value of the case");
    return live;
}

LessonMark readMark(StudyReader& reader, const std::string& table, const LessonStep& step)
{
    LessonMark mark;
    mark.run = readNumberOfRun(reader, table + ".run", step.runs);
    mark.plot = requiredText(reader, table + ".plot");
    if (!mark.plot.empty() && std::ranges::find(step.stage.plots, mark.plot) == step.stage.plots.end())
        reader.add(table + ".plot", inQuotes(mark.plot) + " is not a plot of the stage");
    if (!reader.has(table + ".at")) reader.add(table + ".at", "is missing");
    const LessonStage& stage = step.stage;
    mark.at = reader.number(table + ".at", "s", "ms", stage.from, stage.until > 0.0 ? stage.until : 1.0).value_or(0.0);
    mark.text = requiredText(reader, table + ".text");
    return mark;
}

LessonStep readStep(StudyReader& reader, const std::string& table)
{
    LessonStep step;
    step.title = requiredText(reader, table + ".title");
    for (const std::string& run : reader.tables(table + ".run")) step.runs.push_back(readRun(reader, run));
    const Case c = firstCase(reader, table, step.runs);
    const auto textOrThat = [&](const std::string& key, const std::string& ofCase) {
        return ofCase.empty() || reader.has(key) ? requiredText(reader, key) : ofCase;
    };
    step.text = textOrThat(table + ".text", c.about.paper);
    step.question = textOrThat(table + ".question", c.about.watch);
    step.change = requiredText(reader, table + ".change");
    step.answer = requiredText(reader, table + ".answer");
    step.stage = readStage(reader, table + ".stage", step.runs);
    for (const std::string& mark : reader.tables(table + ".mark")) step.marks.push_back(readMark(reader, mark, step));
    for (const std::string& live : reader.tables(table + ".live")) step.live.push_back(readLive(reader, live, c));
    return step;
}

std::vector<LessonStep> builtIn(std::string_view name)
{
    const auto found = std::ranges::find(lessonTexts(), name, &LessonText::name);
    return readLesson(found->text, found->name).steps;
}

} // namespace

Lesson readLesson(std::string_view text, const std::string& name)
{
    Lesson lesson;
    const TomlDocument toml = readToml(text);
    if (!toml.problem.empty()) {
        lesson.problems.push_back({name, toml.problemLine, "", toml.problem});
        return lesson;
    }
    const Case none;
    StudyReader reader(toml, name, none, lesson.problems);
    for (const std::string& step : reader.tables("step")) lesson.steps.push_back(readStep(reader, step));
    reader.finish();
    return lesson;
}

const std::vector<LessonStep>& lessonSteps()
{
    static const std::vector<LessonStep> steps = builtIn("lesson");
    return steps;
}

const std::vector<LessonStep>& demonstrationSteps()
{
    static const std::vector<LessonStep> steps = builtIn("demonstrations");
    return steps;
}

Case caseOf(const LessonRun& run)
{
    Case c = openCase(run.name).value;
    changeCase(c, run.settings);
    return c;
}

std::string commandOf(const LessonRun& run)
{
    if (!run.kind.empty()) return "touchdown study " + run.kind + ' ' + run.name;
    std::string command = "touchdown run " + run.name;
    for (const CaseSetting& setting : run.settings) command += " --set '" + setting.key + '=' + setting.value + '\'';
    return command;
}

} // namespace touchdown
