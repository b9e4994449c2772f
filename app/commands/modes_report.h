// SPDX-License-Identifier: GPL-3.0-or-later
//
// Air bearing modes as JSON for scripts, as text for people.
#pragma once

#include <string>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

std::string modesJson(const Case& c, const ModesResult& result);
std::string modesText(const Case& c, const ModesResult& result);

} // namespace touchdown
