// SPDX-License-Identifier: GPL-3.0-or-later
//
// A static state with the case that it was found for, and which other cases have the same static state: those that
// differ only in what a run in time alone uses.
#pragma once

#include "core/simulation/static_state/steady.h"

namespace touchdown {

struct StaticSolution {
    Case solved;
    SteadyResult state;
};

/// Nothing that a static state and its search depend on differs. A wall profile that no edge has is nothing.
bool sameFilm(const Case& a, Case b);

/// The film at rest over the mean plane of the disk is the same at any attitude, and no contact deforms the disk: load,
/// inertia, suspension, contact, waves and start may differ, but not the branch of the contact.
bool sameFilmApart(const Case& a, const Case& b);

/// `c` with what only a run in time uses as `run` has it: the disk's surface where no contact at rest sees it, the run
/// and its spectra, and how it starts from an attitude.
Case withRunOf(Case c, const Case& run);

/// `c` has the static state that was found for `solved`: it differs in nothing that the state depends on. The search
/// may start from the state itself.
bool hasStaticState(const Case& c, const Case& solved, const Attitude& found);

/// The state of `solved` is what a run of `c` would find, whatever else was asked about it: a state of the case at an
/// attitude that was not given, or a search from the same start that found none.
bool isRestOf(const Case& c, const Case& solved, const SteadyResult& state);

} // namespace touchdown
