// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static states as JSON for scripts, as text for people.
#pragma once

#include <string>
#include <vector>

#include "app/terminal/json_text.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// A state of a series with its result; the fields may have been dropped.
struct SteadyState {
    SteadySeriesPoint point;
    SteadyResult result;
};

/// The worst status of several, and its message.
SteadyStatus worstStatus(const std::vector<SteadyState>& states);
std::string worstMessage(const std::vector<SteadyState>& states);

/// A sentence about the parts of the case that a static state and its modes leave out; "" if there are none.
std::string leftOut(const Case& c);

/// The rows of the matrix.
Json matrixJson(const Matrix3& m);

/// The keys of one state; numbers in SI, unknown values as null with the reason in the message.
Json steadyObject(const Case& c, const SteadyResult& result);

/// One object: the keys of a single state; for a series its status, and "series" with the keys of each state.
std::string steadyJson(const Case& c, const std::vector<SteadyState>& states, SteadyStatus status,
                       const std::string& message);
std::string steadyText(const Case& c, const std::vector<SteadyState>& states);

} // namespace touchdown
