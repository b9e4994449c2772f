// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown modes`: air bearing frequencies, damping ratios and mode shapes of a film case.
#pragma once

namespace touchdown {

struct CommandArguments;

int modesCommand(const CommandArguments& arguments);

} // namespace touchdown
