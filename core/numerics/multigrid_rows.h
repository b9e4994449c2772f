// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of the multigrid's finest and coarser grids, from their first cells: what multigrid.cpp does on all of them.
// Those with products of complex numbers are called by onVectors() (vector_clones.h).
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "core/numerics/vector_clones.h"

namespace touchdown::multigrid_rows {

constexpr std::size_t together = 4; // lines solved at once: each waits for its last result, others fill the time

/// b less what comes from the rows beside.
template <typename Real, typename Number>
TOUCHDOWN_VECTOR_CLONES void setRest(std::size_t count, std::size_t up, const Real* south, const Real* north,
                                     const Number* b, const Number* v, Number* rest)
{
    const Number *below = v - up, *above = v + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) rest[k] = b[k] - south[k] * below[k] - north[k] * above[k];
}

/// The same where the rows beside count with three cells each.
template <typename Real, typename Number>
void setNineRest(std::size_t count, std::size_t up, const std::array<const Real*, 8> beside, const Number* b,
                 const Number* v, Number* rest)
{
    const Real *c0 = beside[0], *c1 = beside[1], *c2 = beside[2], *c5 = beside[5], *c6 = beside[6], *c7 = beside[7];
    const Number *below = v - up, *above = v + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k)
        rest[k] = b[k] - (c0[k] * below[k - 1] + c1[k] * below[k] + c2[k] * below[k + 1]) -
                  (c5[k] * above[k - 1] + c6[k] * above[k] + c7[k] * above[k + 1]);
}

/// Solves lines along x, `apart` from each other, their right-hand sides in rows a stride apart.
template <std::size_t lines, typename Beside, typename Number>
void solveLines(std::size_t count, std::size_t apart, std::size_t stride, const Beside* west, const Beside* east,
                const Number* pivot, const Number* right, Number* v)
{
    std::array<Number, lines> last{};
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = k * apart + i;
            v[at] = last[k] = right[k * stride + i] * pivot[at] - (west[at] * pivot[at]) * last[k];
        }
    for (std::size_t i = count - 1; i-- > 0;)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = k * apart + i;
            v[at] = last[k] = v[at] - (east[at] * pivot[at]) * last[k];
        }
}

/// Calls solve<lines>(first one) for every second line, a few together.
template <typename Solve>
void forEverySecond(int first, int count, const Solve& solve)
{
    int j = first;
    for (; j + 6 < count; j += 8) solve.template operator()<together>(j);
    for (; j < count; j += 2) solve.template operator()<1>(j);
}

/// v = value(i) in every second column: real numbers in all columns at once, where vectors keep what the others have.
template <typename Number, typename Value>
inline void updateEverySecond(int count, int colour, Number* v, const Value& value)
{
    if constexpr (std::is_floating_point_v<Number>) {
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            const Number old = v[i], next = value(i);
            v[i] = (i & 1) == colour ? next : old;
        }
    } else
        for (int i = colour; i < count; i += 2) v[i] = value(i);
}

/// Rows of the lines along y, from the first to the last: v = (b - west and east - south) pivot in every second column.
template <typename Real, typename Number>
void forwardRow(int count, int colour, std::size_t up, const Real* west, const Real* east, const Real* south,
                const Number* pivot, const Number* b, Number* v)
{
    const Number *before = v - 1, *after = v + 1, *below = v - up;
    updateEverySecond(count, colour, v, [=](int i) {
        return (b[i] - west[i] * before[i] - east[i] * after[i] - south[i] * below[i]) * pivot[i];
    });
}
template <typename Real, typename Number>
void forwardNineRow(int count, int colour, std::size_t up, const std::array<const Real*, 8> beside, const Number* pivot,
                    const Number* b, Number* v)
{
    const Real *c0 = beside[0], *c1 = beside[1], *c2 = beside[2], *c3 = beside[3], *c4 = beside[4], *c5 = beside[5],
               *c7 = beside[7];
    const Number *below = v - up, *above = v + up;
    updateEverySecond(count, colour, v, [=](int i) {
        return (b[i] - (c0[i] * below[i - 1] + c1[i] * below[i] + c2[i] * below[i + 1]) -
                (c3[i] * v[i - 1] + c4[i] * v[i + 1]) - (c5[i] * above[i - 1] + c7[i] * above[i + 1])) *
               pivot[i];
    });
}
template <typename Real, typename Number>
void backwardRow(int count, int colour, std::size_t up, const Real* north, const Number* pivot, Number* v)
{
    const Number* above = v + up;
    updateEverySecond(count, colour, v, [=](int i) { return v[i] - north[i] * pivot[i] * above[i]; });
}

/// Rows of the lines along y of a factored operator.
template <typename Number>
void forwardRowAlone(std::size_t count, std::size_t up, const Number* centre, const Number* south, Number* v)
{
    const Number* below = v - up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) v[k] = centre[k] * v[k] - south[k] * below[k];
}
template <typename Number>
void backwardRowAlone(std::size_t count, std::size_t up, const Number* north, Number* v)
{
    const Number* above = v + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) v[k] -= north[k] * above[k];
}

/// The residual of b in a row, by itself or added to what is there.
template <bool add, typename Real, typename Number>
void setResidual(std::size_t count, std::size_t up, const Real* west, const Real* east, const Real* south,
                 const Real* north, const Number* centre, const Number* b, const Number* v, Number* out)
{
    const Number *before = v - 1, *after = v + 1, *below = v - up, *above = v + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const Number left = (b[k] - centre[k] * v[k]) - (west[k] * before[k] + east[k] * after[k]) -
                            (south[k] * below[k] + north[k] * above[k]);
        out[k] = add ? out[k] + left : left;
    }
}

template <typename Number>
TOUCHDOWN_VECTOR_CLONES void addPairs(std::size_t count, const Number* in, Number* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = in[2 * k] + in[2 * k + 1];
}

/// A fine cell takes nine, three, three and one sixteenths of the four coarse cells around its centre.
template <typename Real, typename Number>
TOUCHDOWN_VECTOR_CLONES void addBilinear(std::size_t count, const Number* own, const Number* next, Number* row,
                                         Number* v)
{
    const Real near = Real(0.1875), far = Real(0.0625), three = Real(3);
#pragma GCC ivdep
    for (std::size_t k = 0; k < count + 2; ++k) row[k] = near * own[k] + far * next[k];
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        v[2 * k] += three * row[k + 1] + row[k];
        v[2 * k + 1] += three * row[k + 1] + row[k + 2];
    }
}

template <typename From, typename To>
TOUCHDOWN_VECTOR_CLONES void convert(std::size_t count, double scale, const From* in, To* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = static_cast<To>(scale * in[k]);
}

} // namespace touchdown::multigrid_rows
