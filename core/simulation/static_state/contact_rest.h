// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static states of a slider with its contact: where film, contact and suspension balance (film_balance.h). The
// suspension exerts its load at the static state of the film alone, as in a run; where there is none, at the initial
// attitude. A law with branches may have several: flying, and in contact.
//
// A contact of surfaces is that over a flat disk, or over one that stands still. Over a disk that moves it is that of
// the mean plane: what a moving surface adds is found by a run.
#pragma once

#include <functional>
#include <optional>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// As `steady`, with the contact: the state is the flying one where there is one, else that in contact; with
/// `initial.branch` "take-off" one in contact where there is a stable one. The others are in
/// SteadyResult::contactStates; of elastic contact with attraction they are sought with "take-off" only. Of a case
/// without contact, or at a fixed attitude: `steady`.
SteadyResult steadyWithContact(const Case& c, const SteadyCallback& callback = {});

/// The state in contact of a case that was changed a little, near to `from`, one in contact, on its grid; nothing where
/// none is found nearby. For the attitude alone, as steadyNear.
std::optional<SteadyResult> touchingNear(const Case& c, const SteadyResult& from, const SteadyCallback& callback = {});
/// Whether the contact of the case at rest is that over the disk's own surface, not over its mean plane.
bool seesStillDisk(const Case& c);
/// Whether the case's contact exerts a force on a slider that flies in this state and came from afar.
bool actsInFlight(const Case& c, const SteadyResult& state, const std::function<bool()>& goOn);

} // namespace touchdown
