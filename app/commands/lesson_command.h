// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown list lesson`: the steps of the lesson with the commands of their runs; the answers stand at the end.
// `touchdown list demonstrations`: the figures of the paper, each with its run, what to watch, and how sure it is.
#pragma once

namespace touchdown {

int lessonCommand(bool json);
int demonstrationsCommand(bool json);

} // namespace touchdown
