// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program teaches with, in steps with a text, a question, runs and an answer: the lesson for a newcomer, and a
// demonstration of each figure of the paper. Both are data, in sample_cases/lesson:
//
//   [[step]]
//   title = "..."
//   text = "..."       # what to know; paragraphs end with a line break
//   question = "..."
//   change = "..."     # what to change next
//   answer = "..."     # with the numbers that the program gives
//
// The texts of a demonstration are what the paper reports, what to watch, what to try, and how sure the result is. It
// leaves out `text` and `question`: they are those of the case of its first run.
//
//   [step.stage]       # what the window shows of the step's runs
//   plots = ["spacing", "energy"]       # names of plots over time
//   from = "0 ms", until = "0.3 ms"     # of the time axis; may be left out
//   lowest = "-6 nm", highest = "20 nm" # of the minimum spacing; may be left out
//   side = true, spectrum = true        # the side view above the plots, the spectrum below; false if left out
//   parts = 1          # on paper a plot of several curves shows this run, of the runs below; the last if left out
//
//   [[step.mark]]      # a word at a place of a curve: where to look
//   run = 1            # whose curve, of the runs below
//   plot = "spacing", at = "25 us", text = "first touch"
//
//   [[step.live]]      # a value that the reader moves; the case of the first run has it within these ends
//   keys = ["springs.front_damping_ratio", "springs.rear_damping_ratio"]   # that get the same number
//   from = "0.001", until = "0.1"
//   label = "..."      # of several keys; may be left out
//
//   [[step.run]]
//   purpose = "..."
//   case = "fig10a"    # a sample case, or
//   set = { "springs.flying_height" = "5 nm" }   # changes of the case; may be left out
//   study = "..."      # instead of a case: a sample study
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case.h"
#include "core/case_files/case_settings.h"
#include "core/formats/input_problem.h"

namespace touchdown {

struct LessonRun {
    std::string purpose;
    std::string name;                  // of a sample case, or of a sample study
    std::string kind;                  // of the study; "" for a run
    std::vector<CaseSetting> settings; // of the case
    bool operator==(const LessonRun&) const = default;
};

/// A number that the reader moves between two ends, so that the case runs again at once.
struct LiveValue {
    std::vector<std::string> keys;  // of parameters with the same unit: they get the same number
    double from = 0.0, until = 0.0; // [unit of the parameters]; from < until
    std::string label{};            // empty: that of the first parameter

    /// Where a movement has steps of equal ratio: the ends are positive and at least a factor of 20 apart.
    bool logarithmic() const { return from > 0.0 && until >= 20.0 * from; }
};

/// Where two ends are equal, an axis follows the data.
struct LessonStage {
    std::vector<std::string> plots;
    double from = 0.0, until = 0.0;     // [s]
    double lowest = 0.0, highest = 0.0; // [m]
    bool side = false, spectrum = false;
    std::optional<std::size_t> parts; // the first run is 0
};

/// A word at a place of the curve of a run.
struct LessonMark {
    std::size_t run = 0; // of the step, the first is 0
    std::string plot;    // one of those of the stage
    double at = 0.0;     // [s]
    std::string text;
};

struct LessonStep {
    std::string title;
    std::string text;
    std::string question;
    std::string change;
    std::string answer;
    LessonStage stage;
    std::vector<LessonRun> runs;
    std::vector<LiveValue> live;
    std::vector<LessonMark> marks{};
};

struct Lesson {
    std::vector<LessonStep> steps;
    std::vector<InputProblem> problems;
};
Lesson readLesson(std::string_view text, const std::string& name);

/// Built into the program: the lesson, and the figures of the paper.
const std::vector<LessonStep>& lessonSteps();
const std::vector<LessonStep>& demonstrationSteps();

/// The case that a run of a sample case performs.
Case caseOf(const LessonRun& run);

/// "touchdown run fig10a --set 'springs.flying_height=5 nm'", as a shell takes it.
std::string commandOf(const LessonRun& run);

/// Names and texts, as the build put them in.
struct LessonText {
    std::string name;
    std::string text;
};
const std::vector<LessonText>& lessonTexts();

} // namespace touchdown
