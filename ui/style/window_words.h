// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sentences of the core, which the command line prints too, in the words of the window.
#pragma once

#include <string>
#include <string_view>

#include <QString>

namespace touchdown {

/// readable(), with labels in place of keys of the case and names of quantities, "preload" for suspension.preload, and
/// the button in place of an option of the command line.
QString inWindowWords(std::string_view sentence);
/// "Preload" of suspension.preload, "Rail 1: width" of abs.rail[1].width; empty where it is no key of a case.
QString labelOfKey(const std::string& key);

} // namespace touchdown
