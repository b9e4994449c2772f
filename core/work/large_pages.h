// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields of a film are allocated at its construction, a page of 4 kB at a time: for a static state on a fine grid
// this takes a third of the time. Where the system offers pages of 2 MB on request, most of it is saved.
#pragma once

#include <cstddef>

namespace touchdown {

/// Asks for large pages for what the calling thread, the program's first one, allocates from now on, up to so many
/// bytes; memory is taken when it is used. What is freed is kept for later allocations. A hint: without effect on
/// systems that have no such pages, or another allocator than that of the GNU C library.
void preferLargePages(std::size_t bytes);

} // namespace touchdown
