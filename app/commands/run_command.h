// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown run`: a case to its end, with results on disk, progress, and a way to stop it.
#pragma once

namespace touchdown {

struct CommandArguments;

int runCommand(const CommandArguments& arguments);

} // namespace touchdown
