// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a sweep, and what it varies and reads where its file does not say.
#pragma once

#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

inline constexpr int mostSweepValues = 100000, standardSweepCount = 7; // of an axis
inline constexpr int mostSweepSamples = 1000000;

inline const std::vector<std::string> sweepSpacings{"linear", "logarithmic"};
inline const std::vector<std::string> sweepDistributions{"uniform", "normal"};

StudyForm sweepForm(const Case& c);
/// The tables [[axis]] and [[reading]] of a sweep of this case; without an axis where none suits it.
std::string standardSweepLists(const Case& c);
/// The same over another key.
std::string sweepLists(const Case& c, const std::string& key);

} // namespace touchdown
