// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown describe`: the reference of every key, from the one description of the fields.
#pragma once

#include <string>

namespace touchdown {

/// `key` is a key, a group, or "" for all keys of a case; or it is of a study.
int describeCommand(const std::string& key, bool json);

} // namespace touchdown
