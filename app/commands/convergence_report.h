// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of convergence found: as JSON for scripts, as a table for people.
#pragma once

#include <string>

#include "core/studies/convergence/convergence.h"

namespace touchdown {

/// One object; numbers in SI. An order that was not seen is null.
std::string convergenceJson(const ConvergenceStudy& study);
std::string convergenceText(const Case& c, const ConvergenceStudy& study);

} // namespace touchdown
