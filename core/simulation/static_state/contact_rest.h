// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static states of a slider with its contact: where film, contact and suspension balance (film_balance.h). The
// suspension exerts its load at the static state of the film alone, as in a run; where there is none, at the initial
// attitude. A law with branches may have several: flying, and in contact.
//
// A contact of surfaces is that over a flat disk, or over one that stands still. Over a disk that moves it is that of
// the mean plane: what a moving surface adds is found by a run.
#pragma once

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// As `steady`, with the contact: the state is the flying one where there is one, else that in contact; the others are
/// in SteadyResult::contactStates. Of a case without contact, or at a fixed attitude: `steady`.
SteadyResult steadyWithContact(const Case& c, const SteadyCallback& callback = {});

} // namespace touchdown
