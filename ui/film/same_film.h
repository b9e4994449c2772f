// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/case/case.h"

namespace touchdown {

/// A static solution of one is one of the other. Where the attitude is not held, the search for it may start elsewhere.
inline bool sameFilm(const Case& a, Case b)
{
    b.title = a.title;
    b.about = a.about;
    b.folder = a.folder;
    b.run = a.run;
    b.spectrum = a.spectrum;
    if (!a.steady.fixedAttitude) b.initial = a.initial;
    return a == b;
}

} // namespace touchdown
