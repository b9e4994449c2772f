// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/lesson/lesson.h"

#include <algorithm>
#include <tuple>

#include "core/case/case.h"
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

LessonStage readStage(StudyReader& reader, const std::string& table)
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
    return stage;
}

LessonStep readStep(StudyReader& reader, const std::string& table)
{
    LessonStep step;
    step.title = requiredText(reader, table + ".title");
    step.text = requiredText(reader, table + ".text");
    step.question = requiredText(reader, table + ".question");
    step.change = requiredText(reader, table + ".change");
    step.answer = requiredText(reader, table + ".answer");
    step.stage = readStage(reader, table + ".stage");
    for (const std::string& run : reader.tables(table + ".run")) step.runs.push_back(readRun(reader, run));
    return step;
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
    static const std::vector<LessonStep> steps = readLesson(lessonTexts().front().text, "the lesson").steps;
    return steps;
}

std::string commandOf(const LessonRun& run)
{
    if (!run.kind.empty()) return "touchdown study " + run.kind + ' ' + run.name;
    std::string command = "touchdown run " + run.name;
    for (const CaseSetting& setting : run.settings) command += " --set '" + setting.key + '=' + setting.value + '\'';
    return command;
}

} // namespace touchdown
