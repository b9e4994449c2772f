// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/multigrid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <complex>
#include <type_traits>

#include "core/numerics/vector_clones.h"

namespace touchdown {

namespace {

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
TOUCHDOWN_VECTOR_CLONES void setNineRest(std::size_t count, std::size_t up, const std::array<const Real*, 8> beside,
                                         const Number* b, const Number* v, Number* rest)
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
TOUCHDOWN_VECTOR_CLONES void forwardRow(int count, int colour, std::size_t up, const Real* west, const Real* east,
                                        const Real* south, const Number* pivot, const Number* b, Number* v)
{
    const Number *before = v - 1, *after = v + 1, *below = v - up;
    updateEverySecond(count, colour, v, [=](int i) {
        return (b[i] - west[i] * before[i] - east[i] * after[i] - south[i] * below[i]) * pivot[i];
    });
}
template <typename Real, typename Number>
TOUCHDOWN_VECTOR_CLONES void forwardNineRow(int count, int colour, std::size_t up,
                                            const std::array<const Real*, 8> beside, const Number* pivot,
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
TOUCHDOWN_VECTOR_CLONES void backwardRow(int count, int colour, std::size_t up, const Real* north, const Number* pivot,
                                         Number* v)
{
    const Number* above = v + up;
    updateEverySecond(count, colour, v, [=](int i) { return v[i] - north[i] * pivot[i] * above[i]; });
}

/// Every second line along y: `forward` from each row's first cell on, where below the first row the ring holds zero,
/// then back.
template <typename Real, typename Number, typename Forward>
void solveRows(const PaddedGrid& pad, int colour, const Real* north, const Number* pivot, Number* v,
               const Forward& forward)
{
    for (int j = 0; j < pad.ny; ++j) forward(pad.at(0, j));
    for (int j = pad.ny - 2; j >= 0; --j) {
        const std::size_t at = pad.at(0, j);
        backwardRow(pad.nx, colour, pad.stride(), north + at, pivot + at, v + at);
    }
}

/// Rows of the lines along y of a factored operator.
template <typename Number>
TOUCHDOWN_VECTOR_CLONES void forwardRowAlone(std::size_t count, std::size_t up, const Number* centre,
                                             const Number* south, Number* v)
{
    const Number* below = v - up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) v[k] = centre[k] * v[k] - south[k] * below[k];
}
template <typename Number>
TOUCHDOWN_VECTOR_CLONES void backwardRowAlone(std::size_t count, std::size_t up, const Number* north, Number* v)
{
    const Number* above = v + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) v[k] -= north[k] * above[k];
}

/// The residual of b in a row, by itself or added to what is there.
template <bool add, typename Real, typename Number>
TOUCHDOWN_VECTOR_CLONES void setResidual(std::size_t count, std::size_t up, const Real* west, const Real* east,
                                         const Real* south, const Real* north, const Number* centre, const Number* b,
                                         const Number* v, Number* out)
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

} // namespace

template <typename T>
Multigrid<T>::Multigrid(const PaddedGrid& pad)
{
    PaddedGrid next = pad;
    for (;;) {
        Level& level = levels_.emplace_back();
        level.pad = next;
        for (auto* field : {&level.west, &level.east, &level.south, &level.north}) field->assign(next.size(), Real{});
        for (auto* field : {&level.centre, &level.pivot[0], &level.pivot[1], &level.value, &level.right})
            field->assign(next.size(), Number{});
        if (levels_.size() > 1) {
            CoarseSource& source = sources_.emplace_back();
            for (auto* pair : {&source.diffusion, &source.effective, &source.convection})
                for (auto& field : *pair) field.assign(next.size(), 0.0);
            source.mass.assign(next.size(), T{});
        }
        if (std::min(next.nx, next.ny) <= 4) break;
        next = {(next.nx + 1) / 2, (next.ny + 1) / 2};
    }
    noMass_.assign(pad.size(), T{});
    rows_.assign(together * pad.stride(), Number{});
}

template <typename T>
void Multigrid<T>::take(std::span<const T> b)
{
    convert(b.size(), scale_, b.data(), levels_.front().right.data());
}

template <typename T>
void Multigrid<T>::solveByFactors()
{
    assert(hasFactors_);
    Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    // A few lines along x, and at once these rows of the lines along y, while they are at hand.
    const auto solve = [&]<std::size_t lines>(int first) {
        const std::size_t from = pad.at(0, first);
        solveLines<lines>(n, up, up, &level.west[from], &level.east[from], &factors_.pivot[0][from], &level.right[from],
                          &level.value[from]);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = from + k * up; // below the first row the ring holds zero
            forwardRowAlone(n, up, &factors_.centre[at], &factors_.south[at], &level.value[at]);
        }
    };
    int first = 0;
    for (; first + 3 < pad.ny; first += 4) solve.template operator()<4>(first);
    for (; first < pad.ny; ++first) solve.template operator()<1>(first);
    for (int j = pad.ny - 2; j >= 0; --j) {
        const std::size_t at = pad.at(0, j);
        backwardRowAlone(n, up, &factors_.north[at], &level.value[at]);
    }
}

template <typename T>
void Multigrid<T>::sweepX(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto solve = [&]<std::size_t lines>(int j) {
        const std::size_t first = pad.at(0, j);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + 2 * k * up;
            setRest(n, up, &level.south[at], &level.north[at], &level.right[at], &level.value[at], &rows_[k * up]);
        }
        solveLines<lines>(n, 2 * up, up, &level.west[first], &level.east[first], &level.pivot[0][first], rows_.data(),
                          &level.value[first]);
    };
    forEverySecond(colour, pad.ny, solve);
}

template <typename T>
void Multigrid<T>::sweepY(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    solveRows(pad, colour, level.north.data(), level.pivot[1].data(), level.value.data(), [&](std::size_t at) {
        forwardRow(pad.nx, colour, pad.stride(), &level.west[at], &level.east[at], &level.south[at],
                   &level.pivot[1][at], &level.right[at], &level.value[at]);
    });
}

template <typename T>
void Multigrid<T>::sweep(Level& level)
{
    for (int colour = 0; colour < 2; ++colour) sweepX(level, colour);
    for (int colour = 0; colour < 2; ++colour) sweepY(level, colour);
}

template <typename T>
void Multigrid<T>::sweepNineX(int colour)
{
    Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto solve = [&]<std::size_t lines>(int j) {
        const std::size_t first = pad.at(0, j);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + 2 * k * up;
            setNineRest<Number>(n, up, besideAt(at), &level.right[at], &level.value[at], &rows_[k * up]);
        }
        solveLines<lines>(n, 2 * up, up, &nine_.beside[3][first], &nine_.beside[4][first], &nine_.pivot[0][first],
                          rows_.data(), &level.value[first]);
    };
    forEverySecond(colour, pad.ny, solve);
}

template <typename T>
void Multigrid<T>::sweepNineY(int colour)
{
    Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    solveRows(pad, colour, nine_.beside[6].data(), nine_.pivot[1].data(), level.value.data(), [&](std::size_t at) {
        forwardNineRow<Number>(pad.nx, colour, pad.stride(), besideAt(at), &nine_.pivot[1][at], &level.right[at],
                               &level.value[at]);
    });
}

template <typename T>
std::array<const typename Multigrid<T>::Number*, 8> Multigrid<T>::besideAt(std::size_t at) const
{
    std::array<const Number*, 8> beside;
    for (std::size_t k = 0; k < 8; ++k) beside[k] = &nine_.beside[k][at];
    return beside;
}

template <typename T>
void Multigrid<T>::restrictResidual(const Level& fine, Level& coarse)
{
    const std::size_t up = fine.pad.stride(), n = static_cast<std::size_t>(fine.pad.nx);
    Number* row = rows_.data();
    row[n] = Number{}; // beside the last column of an odd number
    const auto leave = [&]<bool add>(int j) {
        const std::size_t at = fine.pad.at(0, j);
        setResidual<add>(n, up, &fine.west[at], &fine.east[at], &fine.south[at], &fine.north[at], &fine.centre[at],
                         &fine.right[at], &fine.value[at], row);
    };
    for (int j = 0; j < coarse.pad.ny; ++j) {
        leave.template operator()<false>(2 * j);
        if (2 * j + 1 < fine.pad.ny) leave.template operator()<true>(2 * j + 1);
        addPairs(static_cast<std::size_t>(coarse.pad.nx), row, &coarse.right[coarse.pad.at(0, j)]);
    }
}

template <typename T>
void Multigrid<T>::prolong(const Level& coarse, Level& fine)
{
    for (int j = 0; j < fine.pad.ny; ++j) {
        const int beside = j % 2 == 0 ? j / 2 - 1 : j / 2 + 1;
        addBilinear<Real>(static_cast<std::size_t>(coarse.pad.nx), &coarse.value[coarse.pad.at(-1, j / 2)],
                          &coarse.value[coarse.pad.at(-1, beside)], rows_.data(), &fine.value[fine.pad.at(0, j)]);
        fine.value[fine.pad.at(fine.pad.nx, j)] = Number{}; // of an odd number of columns, written above
    }
}

template <typename T>
void Multigrid<T>::cycle(std::size_t l)
{
    Level& level = levels_[l];
    std::fill(level.value.begin(), level.value.end(), Number{});
    const bool endsWithNine = l == 0 && hasNine_;
    if (l + 1 == levels_.size()) {
        for (int k = 0; k < 6; ++k) sweep(level);
    } else {
        if (l == 0 && hasFactors_)
            solveByFactors();
        else
            sweep(level);
        restrictResidual(level, levels_[l + 1]);
        cycle(l + 1);
        prolong(levels_[l + 1], level);
        if (!endsWithNine) sweep(level);
    }
    if (!endsWithNine) return;
    for (int colour = 0; colour < 2; ++colour) sweepNineX(colour);
    for (int colour = 0; colour < 2; ++colour) sweepNineY(colour);
}

template <typename T>
void Multigrid<T>::precondition(std::span<const T> b, std::span<T> v)
{
    take(b);
    cycle(0);
    std::ranges::copy(levels_.front().value, v.begin());
}

template <typename T>
void Multigrid<T>::solveFactors(std::span<const T> b, std::span<T> v)
{
    take(b);
    solveByFactors();
    std::ranges::copy(levels_.front().value, v.begin());
}

template <typename T>
void Multigrid<T>::halfCycle(std::span<const T> b, std::span<T> v)
{
    take(b);
    solveByFactors();
    if (levels_.size() > 1) {
        restrictResidual(levels_[0], levels_[1]);
        cycle(1);
        prolong(levels_[1], levels_[0]);
    }
    std::ranges::copy(levels_.front().value, v.begin());
}

template class Multigrid<double>;
template class Multigrid<std::complex<double>>;

} // namespace touchdown
