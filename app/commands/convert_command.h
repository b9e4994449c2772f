// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown convert`: between case files and the files of the established slider program (CML), both ways.
#pragma once

#include <string>

namespace touchdown {

/// `from` is any case; `to` is a case file if it ends with .toml, an archive if it ends with .cml, else a folder.
int convertCommand(const std::string& from, const std::string& to);

} // namespace touchdown
