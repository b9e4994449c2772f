// SPDX-License-Identifier: GPL-3.0-or-later
//
// TOUCHDOWN_VECTOR_CLONES before a function compiles it for the widths of vectors that processors offer, with all that
// it calls; the program picks at its start. Without fused multiply-adds (CMakeLists.txt) and without sums across lanes
// all give the same bits. Sanitizers come too late for the start-up choice, so that they see the default alone.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) &&                        \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOUCHDOWN_VECTOR_CLONES __attribute__((flatten, target_clones("avx512f", "avx2", "default")))
#define TOUCHDOWN_COMPLEX_CLONES __attribute__((flatten, target_clones("avx2", "default")))
#else
#define TOUCHDOWN_VECTOR_CLONES
#define TOUCHDOWN_COMPLEX_CLONES
#endif

namespace touchdown {

/// A loop over rows of Number. Where a processor has fused multiply-adds, which comes with avx512f, GCC 12 takes them
/// for products of complex numbers in the vectors of a loop, but not in what is left at its end: such loops get no
/// clone for it, or their numbers would depend on the processor and on where the row ends.
template <auto loop, typename... Arguments>
TOUCHDOWN_VECTOR_CLONES void onRealVectors(Arguments... arguments)
{
    loop(arguments...);
}
template <auto loop, typename... Arguments>
TOUCHDOWN_COMPLEX_CLONES void onComplexVectors(Arguments... arguments)
{
    loop(arguments...);
}
template <typename Number, auto loop, typename... Arguments>
void onVectors(Arguments... arguments)
{
    if constexpr (std::is_floating_point_v<Number>)
        onRealVectors<loop>(arguments...);
    else
        onComplexVectors<loop>(arguments...);
}

/// Sum of term(k), k < count. Eight sums side by side: a single one would wait for itself at each number, and the order
/// would depend on the width of vectors.
template <typename Term>
auto sumInLanes(std::size_t count, const Term& term)
{
    std::array<decltype(term(count)), 8> sums{};
    const std::size_t whole = count / 8 * 8;
    for (std::size_t i = 0; i < whole; i += 8)
        for (std::size_t k = 0; k < 8; ++k) sums[k] += term(i + k);
    for (std::size_t i = whole; i < count; ++i) sums[0] += term(i);
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

} // namespace touchdown
