// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a key of a TOML text: "method[2].set.\"run.step\"".
#pragma once

#include <string>

namespace touchdown {

/// "run.step" of "set.\"run.step\"" and of "set.run.step", where the table is "set".
std::string settingKey(const std::string& key, const std::string& table);
/// "method.name" of "method[2].name".
std::string withoutNumbers(const std::string& key);
/// "method[2]" of "method[2].name"; "" of a root key.
std::string tableOf(const std::string& key);
/// "name" of "method.name".
std::string leafOf(const std::string& key);
/// "method" of "method[2]", which itself is that of "method[2].name".
std::string ownerOf(const std::string& key);

} // namespace touchdown
