// SPDX-License-Identifier: GPL-3.0-or-later
//
// The findings of a hysteresis study in sentences: whether the slider bounces by itself, touch-down, take-off, the loop
// between them, and how close to equilibria the runs came to rest.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct HeldSteps;
struct HysteresisResult;

std::vector<std::string> hysteresisFindings(const HeldSteps& task, const HysteresisResult& result);

} // namespace touchdown
