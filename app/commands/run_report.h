// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a run ended: as JSON for scripts, as text for people.
#pragma once

#include <string>
#include <vector>

#include "core/simulation/run.h"

namespace touchdown {

/// One object; numbers in SI, quantities that the model does not have as null.
std::string runJson(const Summary& summary, const std::vector<Quantity>& quantities);
std::string runText(const Case& c, const Summary& summary, const std::vector<Quantity>& quantities);

} // namespace touchdown
