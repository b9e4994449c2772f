// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lesson for a newcomer: steps with a text, a question, runs and an answer. It is data, in
// sample_cases/lesson/lesson.toml:
//
//   [[step]]
//   title = "..."
//   text = "..."       # what to know; paragraphs end with a line break
//   question = "..."
//   change = "..."     # what to change next
//   answer = "..."     # with the numbers that the program gives
//
//   [[step.run]]
//   purpose = "..."
//   case = "fig10a"    # a sample case, or
//   set = { "springs.flying_height" = "5 nm" }   # changes of the case; may be left out
//   study = "..."      # instead of a case: a sample study
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/case_files/case_settings.h"
#include "core/formats/input_problem.h"

namespace touchdown {

struct LessonRun {
    std::string purpose;
    std::string name;                  // of a sample case, or of a sample study
    std::string kind;                  // of the study; "" for a run
    std::vector<CaseSetting> settings; // of the case
};

struct LessonStep {
    std::string title;
    std::string text;
    std::string question;
    std::string change;
    std::string answer;
    std::vector<LessonRun> runs;
};

struct Lesson {
    std::vector<LessonStep> steps;
    std::vector<InputProblem> problems;
};
Lesson readLesson(std::string_view text, const std::string& name);

/// The lesson that is built into the program.
const std::vector<LessonStep>& lessonSteps();

/// "touchdown run fig10a --set 'springs.flying_height=5 nm'", as a shell takes it.
std::string commandOf(const LessonRun& run);

/// Names and texts, as the build put them in.
struct LessonText {
    std::string name;
    std::string text;
};
const std::vector<LessonText>& lessonTexts();

} // namespace touchdown
