// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// Nothing that a static state and its search depend on differs.
inline bool sameFilm(const Case& a, Case b)
{
    b.title = a.title;
    b.about = a.about;
    b.folder = a.folder;
    b.run = a.run;
    b.spectrum = a.spectrum;
    return a == b;
}

/// `c` with what only a run in time uses as `run` has it: the disk's surface, as a static state is one over a flat
/// disk, the run and its spectra, and how it starts from an attitude.
inline Case withRunOf(Case c, const Case& run)
{
    c.diskSurface = run.diskSurface;
    c.run = run.run;
    c.spectrum = run.spectrum;
    const InitialCase attitude = c.initial;
    c.initial = run.initial;
    c.initial.nominalTrailingEdgeHeight = attitude.nominalTrailingEdgeHeight;
    c.initial.pitch = attitude.pitch;
    c.initial.roll = attitude.roll;
    return c;
}

/// `c` has the static state that was found for `solved`: it differs in nothing that the state depends on. The search
/// may start from the state itself.
inline bool hasStaticState(const Case& c, const Case& solved, const Attitude& found)
{
    Case same = withRunOf(solved, c);
    const InitialCase& start = c.initial;
    if (start.nominalTrailingEdgeHeight == found.height && start.pitch == found.pitch && start.roll == found.roll)
        same.initial = start;
    return sameFilm(c, same);
}

} // namespace touchdown
