// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/lesson_command.h"

#include <ranges>

#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/report_text.h"
#include "app/terminal/text_table.h"
#include "core/formats/words.h"
#include "core/studies/lesson/lesson.h"

namespace touchdown {

namespace {

constexpr std::size_t indent = 3;

std::string paragraphs(const std::string& text, std::size_t width)
{
    std::string lines;
    for (const auto part : std::views::split(text, '\n')) lines += wrapped({part.begin(), part.end()}, indent, width);
    return lines;
}

/// The command stands on one line, so that it can be copied.
std::string runText(const LessonRun& run, std::size_t width)
{
    return wrapped("# " + run.purpose, 2 * indent, width) + std::string(2 * indent, ' ') + commandOf(run) + '\n';
}

Json jsonStep(const LessonStep& step)
{
    Json runs = Json::array();
    for (const LessonRun& run : step.runs) runs.push_back({{"purpose", run.purpose}, {"command", commandOf(run)}});
    return {{"title", step.title}, {"text", step.text},     {"question", step.question},
            {"runs", runs},        {"change", step.change}, {"answer", step.answer}};
}

int printJson(const std::vector<LessonStep>& steps)
{
    Json all = Json::array();
    for (const LessonStep& step : steps) all.push_back(jsonStep(step));
    print(jsonText({{"steps", all}}));
    return exitDone;
}

} // namespace

int lessonCommand(bool json)
{
    const std::vector<LessonStep>& steps = lessonSteps();
    if (json) return printJson(steps);
    const std::size_t width = std::min(outputWidth(), std::size_t(100));
    std::string text = "The lesson: " + counted(steps.size(), "step") +
                       ". Each asks a question. The commands help you to answer it. The answers are at the end.\n";
    std::string answers = "\nAnswers\n";
    int number = 0;
    for (const LessonStep& step : steps) {
        const std::string title = '\n' + std::to_string(++number) + ". " + step.title + '\n';
        text += title + paragraphs(step.text, width) + wrapped("Question: " + step.question, indent, width);
        for (const LessonRun& run : step.runs) text += runText(run, width);
        text += wrapped("What to change: " + step.change, indent, width);
        answers += title + paragraphs(step.answer, width);
    }
    print(text + answers);
    return exitDone;
}

int demonstrationsCommand(bool json)
{
    const std::vector<LessonStep>& steps = demonstrationSteps();
    if (json) return printJson(steps);
    const std::size_t width = std::min(outputWidth(), std::size_t(100));
    std::string text = counted(steps.size(), "demonstration") +
                       ": the figures of Chen and Bogy's paper, and what follows from them.\n";
    for (const LessonStep& step : steps) {
        text += '\n' + step.title + '\n' + wrapped("What the paper reports: " + step.text, indent, width);
        for (const LessonRun& run : step.runs) text += runText(run, width);
        text += wrapped("What to watch: " + step.question, indent, width) +
                wrapped("How sure it is: " + step.answer, indent, width) +
                wrapped("What to try: " + step.change, indent, width);
    }
    print(text);
    return exitDone;
}

} // namespace touchdown
