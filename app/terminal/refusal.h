// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a command refuses wrong input or arguments.
#pragma once

#include <string>
#include <vector>

#include "app/terminal/json_text.h"
#include "core/formats/input_problem.h"

namespace touchdown {

/// "problems" of an object: file, line (null where there is none), key and message of each.
Json problemsJson(const std::vector<InputProblem>& problems);

/// One object: "status" ("wrong input"), "message" and "problems". There is one problem or more.
std::string refusalJson(const std::vector<InputProblem>& problems);

/// Writes each problem as a line on standard error and, with `json`, the object on standard output. Returns
/// exitWrongInput. There is one problem or more.
int refuse(const std::vector<InputProblem>& problems, bool json);

} // namespace touchdown
