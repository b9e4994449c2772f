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
//   [step.stage]       # what the window shows of the step's runs
//   plots = ["spacing", "energy"]       # names of plots over time
//   from = "0 ms", until = "0.3 ms"     # of the time axis; may be left out
//   lowest = "-6 nm", highest = "20 nm" # of the minimum spacing; may be left out
//   side = true, spectrum = true        # the side view above the plots, the spectrum below; false if left out
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

/// Where two ends are equal, an axis follows the data.
struct LessonStage {
    std::vector<std::string> plots;
    double from = 0.0, until = 0.0;     // [s]
    double lowest = 0.0, highest = 0.0; // [m]
    bool side = false, spectrum = false;
};

struct LessonStep {
    std::string title;
    std::string text;
    std::string question;
    std::string change;
    std::string answer;
    LessonStage stage;
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
