// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown describe` of a kind of study: the reference of its keys.
#pragma once

#include <optional>
#include <string>

namespace touchdown {

/// Describes "study", "study.KIND" or "KIND", or a key of it; returns the exit code. Nothing where the key does not
/// belong to a study.
std::optional<int> describeStudy(const std::string& key, bool json);

} // namespace touchdown
