// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program `touchdown`. Standard output carries results, standard error everything else.
#pragma once

namespace touchdown {

/// Parses the arguments and does what they say. Returns an ExitCode.
int commandLine(int argc, char** argv);

} // namespace touchdown
