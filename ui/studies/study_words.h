// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sentences of a study's report, which the command line prints too, in the words of the window.
#pragma once

#include <string_view>

#include <QString>

namespace touchdown {

/// readable(), with labels in place of keys of the case and names of quantities, "preload" for suspension.preload, and
/// the button in place of an option of the command line.
QString inWindowWords(std::string_view sentence);

} // namespace touchdown
