// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown describe`: the reference of the keys of a case, and of those of each kind of study.
#pragma once

#include <string>

namespace touchdown {

/// `key`: a key or a group of a case, "" for all of them; or "study", "study.KIND", "KIND" or a key below a kind.
int describeCommand(const std::string& key, bool json);

} // namespace touchdown
