// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown list lesson`: the steps of the lesson with the commands of their runs; the answers stand at the end.
#pragma once

namespace touchdown {

int lessonCommand(bool json);

} // namespace touchdown
