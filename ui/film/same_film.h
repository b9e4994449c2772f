// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/case/case.h"

namespace touchdown {

/// Nothing that a static solution depends on differs.
inline bool sameFilm(const Case& a, Case b)
{
    b.title = a.title;
    b.about = a.about;
    b.folder = a.folder;
    return a == b;
}

} // namespace touchdown
