// SPDX-License-Identifier: GPL-3.0-or-later
//
// Standard output carries results, standard error everything else. Exit codes of the program.
#pragma once

#include <string_view>

namespace touchdown {

enum ExitCode : int {
    exitDone = 0,
    exitNoAnswer = 1,   // the calculation ended without a valid answer, and said why
    exitWrongInput = 2, // every problem is listed
};

/// A line on standard error. As in print(), what a terminal would obey is shown escaped (core/formats/quotation.h):
/// titles, names and quotations come from files of other people.
void complain(std::string_view sentence);
/// Text on standard output, in lines.
void print(std::string_view text);
/// The text of a file on standard output: exact, unless that is a terminal.
void printExactly(std::string_view text);

} // namespace touchdown
