// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a design study found: as JSON for scripts, as a table for people.
#pragma once

#include <string>

#include "core/studies/design/design.h"

namespace touchdown {

/// One object; numbers in SI.
std::string designJson(const DesignTask& task, const DesignStudy& study);
std::string designText(const DesignTask& task, const DesignStudy& study);

} // namespace touchdown
