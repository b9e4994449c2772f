// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace touchdown {

/// From now on freed memory stays with the program for its next grid: a film on three grids touches 100 MB, and what
/// the system takes back it has to clear and map again, page by page.
inline void keepFreedMemory()
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20); // the most that glibc takes [B]
    mallopt(M_TRIM_THRESHOLD, 1 << 30);  // [B]
#endif
}

} // namespace touchdown
