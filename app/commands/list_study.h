// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study that is a list of items, as the command line performs it: whole or a part, joined from parts, or going on in
// its file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/formats/input_problem.h"
#include "core/studies/study/item_journal.h"

namespace touchdown {

struct CommandArguments;
struct StudyPlan;

class ListStudy {
public:
    /// Adds the problems of --part, --join, --resume and --engine, and reads the files that they name.
    void check(const StudyPlan& plan, const CommandArguments& arguments, std::vector<InputProblem>& problems);
    /// Keeps rows from now on. Returns the problem, or "". The study's file is locked.
    std::string open(const CommandArguments& arguments);
    StudyReport perform(const StudyPlan& plan, const CommandArguments& arguments, const StudyCallback& callback);
    /// "12 of 30 items were there already".
    std::string takenText(const StudyPlan& plan) const;
    /// Once the study's file has all rows.
    void close() { journal_.remove(); }

private:
    static void checkEngine(const StudyPlan& plan, const CommandArguments& arguments,
                            std::vector<InputProblem>& problems);
    void take(const std::string& file, const char* option, std::vector<InputProblem>& problems);

    KeptRows kept_;
    ItemOptions options_;
    ItemJournal journal_;
    std::size_t taken_ = 0;
};

} // namespace touchdown
