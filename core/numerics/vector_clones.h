// SPDX-License-Identifier: GPL-3.0-or-later
//
// TOUCHDOWN_VECTOR_CLONES before a function compiles it for the widths of vectors that processors offer, with all that
// it calls; the program picks at its start. Without fused multiply-adds (CMakeLists.txt) and without sums across lanes
// all give the same bits. Sanitizers come too late for the start-up choice, so that they see the default alone.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) &&                        \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOUCHDOWN_VECTOR_CLONES __attribute__((flatten, target_clones("avx512f", "avx2", "default")))
#else
#define TOUCHDOWN_VECTOR_CLONES
#endif
