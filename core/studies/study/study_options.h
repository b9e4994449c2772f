// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of a study that are given beside its file.
#pragma once

#include <string>
#include <vector>

#include "core/case_files/case_file.h"
#include "core/formats/toml_document.h"

namespace touchdown {

/// Puts "key=value", as given to --option, over what the file says; the last of one key counts. A key of a table has
/// its name before it: ensemble.starts. A value is TOML or bare text: 3, [1, 2], "10 ns", 10 ns. Returns what is no
/// option at all; whether the study knows a key is its reader's to say.
std::vector<InputProblem> applyOptions(TomlDocument& toml, const std::vector<std::string>& options);

} // namespace touchdown
