// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the equilibria of a hysteresis study say of its runs, in sentences.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/studies/hysteresis/hysteresis_result.h"

namespace touchdown {

/// Has a valid end.
inline bool ended(const HeldStep& step) { return step.done && step.end.kind != EndKind::Failed; }

/// "1 run", "2 runs"
std::string counted(std::ptrdiff_t count, const char* one, const char* several);

/// Self-excited or forced.
void addAnswer(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings);
/// Where more than one is stable, and how near to one the runs came to rest.
void addEquilibriaReached(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings);

} // namespace touchdown
