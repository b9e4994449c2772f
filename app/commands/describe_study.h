// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown describe` of a kind of study: the reference of its keys.
#pragma once

#include <optional>
#include <string>

namespace touchdown {

/// Describes "study", "study.KIND" or "KIND", or a key below it, and returns the exit code. Nothing where the key is no
/// key of a study.
std::optional<int> describeStudy(const std::string& key, bool json);

} // namespace touchdown
