// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown steady`: the static state of a film case, or of each of its series; the parts of its report that other
// commands share.
#pragma once

#include <string>

#include "app/terminal/json_text.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

struct CommandArguments;

/// A sentence about the parts of the case that a static state and its modes leave out; "" if there are none.
std::string leftOut(const Case& c, const SteadyResult& state);
/// The rows of the matrix.
Json matrixJson(const Matrix3& m);
/// The keys of one state; numbers in SI, unknown values as null with the reason in the message.
Json steadyObject(const Case& c, const SteadyResult& result);

int steadyCommand(CommandArguments arguments);

} // namespace touchdown
