// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several keys of a case that all take the same value, as one.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/case/case_key.h"
#include "core/studies/runs/value_ranges.h"

namespace touchdown {

struct JointKey {
    Parameter key;      // its name is that of all, with commas between them; its range is allowed for each
    ParameterText text; // "Front stiffness and rear stiffness"
};

/// A key of the case, or why it cannot be one, in a sentence without the key.
using FindKey = std::function<std::variant<Parameter, std::string>(std::string_view key)>;

/// One key or more as one; else why not, in a sentence with the key.
std::variant<JointKey, std::string> jointKey(const std::vector<std::string>& keys, const FindKey& find);

} // namespace touchdown
