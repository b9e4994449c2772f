// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown steady`: the static state of a film case, or of each of its series.
#pragma once

namespace touchdown {

struct CommandArguments;

int steadyCommand(CommandArguments arguments);

} // namespace touchdown
