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

/// "not converged: why", for a person; a message that begins with the status says it once.
std::string statusText(SteadyStatus status, const std::string& message);

/// The keys of one state; numbers in SI, what is not known as null with the reason in the message.
/// What of the case has no part in a static state or in its modes, in a sentence; empty where all has.
std::string leftOut(const Case& c);

Json steadyObject(const Case& c, const SteadyResult& result);

/// One object: of one state its keys; of a series the status of the whole, and "series" with the keys of each.
std::string steadyJson(const Case& c, const std::vector<SteadyState>& states, SteadyStatus status,
                       const std::string& message);
std::string steadyText(const Case& c, const std::vector<SteadyState>& states);

} // namespace touchdown
