// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace touchdown {

/// Times static films against the number of grid lines, then implicit steps of moving ones with what they leave, one
/// CSV row each: sample sliders, and a case or folder of files of the established program if one is named. Returns an
/// exit code.
int benchmarkFilm(const std::string& fileOrFolder, int repeats);

} // namespace touchdown
