// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/multigrid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <complex>
#include <type_traits>

#include "core/numerics/multigrid_rows.h"
#include "core/work/team.h"

namespace touchdown {

using namespace multigrid_rows;

namespace {

constexpr int leastCells = 2048; // of a block that is worth a thread
/// Lines of that many cells together.
int leastLines(int length) { return std::max(4, leastCells / std::max(1, length)); }

/// Every second line along y: `forward` from each row's first cell on, where below the first row the ring holds zero,
/// then back. Blocks of columns each begin and end with such a line: the columns between them are written by none.
template <typename Real, typename Number, typename Forward>
void solveRows(const PaddedGrid& pad, int colour, const Real* north, const Number* pivot, Number* v,
               const Forward& forward)
{
    const int lines = (pad.nx - colour + 1) / 2;
    Team::mine().items(lines, leastLines(pad.ny), 8, [&](int firstLine, int endLine, int) {
        const int first = colour + 2 * firstLine, count = 2 * (endLine - firstLine) - 1;
        for (int j = 0; j < pad.ny; ++j) forward(pad.at(first, j), count);
        for (int j = pad.ny - 2; j >= 0; --j) {
            const std::size_t at = pad.at(first, j);
            onVectors<Number, backwardRow<Real, Number>>(count, 0, pad.stride(), north + at, pivot + at, v + at);
        }
    });
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
    threads_ = Team::mine().size();
    rows_.assign(static_cast<std::size_t>(threads_) * together * pad.stride(), Number{});
}

template <typename T>
typename Multigrid<T>::Number* Multigrid<T>::rowsOf(int thread)
{
    return &rows_[static_cast<std::size_t>(thread) * together * levels_.front().pad.stride()];
}

template <typename T>
int Multigrid<T>::least(int count, int lines) const
{
    return Team::mine().size() > threads_ ? count : lines;
}

template <typename T>
void Multigrid<T>::take(std::span<const T> b)
{
    Number* right = levels_.front().right.data();
    Team::mine().items(static_cast<int>(b.size()), 4 * leastCells, 64, [&](int first, int end, int) {
        convert(static_cast<std::size_t>(end - first), scale_, b.data() + first, right + first);
    });
}

template <typename T>
void Multigrid<T>::give(std::span<T> v) const
{
    const Number* value = levels_.front().value.data();
    Team::mine().items(static_cast<int>(v.size()), 4 * leastCells, 64,
                       [&](int first, int end, int) { std::copy(value + first, value + end, v.data() + first); });
}

template <typename T>
void Multigrid<T>::solveByFactors()
{
    assert(hasFactors_);
    Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    Team& team = Team::mine();
    if (team.blocksOf(pad.ny, leastLines(pad.nx)) > 1) {
        team.items(pad.ny, leastLines(pad.nx), 4, [&](int begin, int end, int) {
            const auto lines = [&]<std::size_t count>(int j) {
                const std::size_t from = pad.at(0, j);
                solveLines<count>(n, up, up, &level.west[from], &level.east[from], &factors_.pivot[0][from],
                                  &level.right[from], &level.value[from]);
            };
            int j = begin;
            for (; j + 3 < end; j += 4) lines.template operator()<4>(j);
            for (; j < end; ++j) lines.template operator()<1>(j);
        });
        team.items(pad.nx, leastLines(pad.ny), 16, [&](int begin, int end, int) {
            const std::size_t count = static_cast<std::size_t>(end - begin);
            for (int j = 0; j < pad.ny; ++j) {
                const std::size_t at = pad.at(begin, j);
                onVectors<Number, forwardRowAlone<Number>>(count, up, &factors_.centre[at], &factors_.south[at],
                                                           &level.value[at]);
            }
            for (int j = pad.ny - 2; j >= 0; --j) {
                const std::size_t at = pad.at(begin, j);
                onVectors<Number, backwardRowAlone<Number>>(count, up, &factors_.north[at], &level.value[at]);
            }
        });
        return;
    }
    // A few lines along x, and at once these rows of the lines along y, while they are at hand.
    const auto solve = [&]<std::size_t lines>(int first) {
        const std::size_t from = pad.at(0, first);
        solveLines<lines>(n, up, up, &level.west[from], &level.east[from], &factors_.pivot[0][from], &level.right[from],
                          &level.value[from]);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = from + k * up; // below the first row the ring holds zero
            onVectors<Number, forwardRowAlone<Number>>(n, up, &factors_.centre[at], &factors_.south[at],
                                                       &level.value[at]);
        }
    };
    int first = 0;
    for (; first + 3 < pad.ny; first += 4) solve.template operator()<4>(first);
    for (; first < pad.ny; ++first) solve.template operator()<1>(first);
    for (int j = pad.ny - 2; j >= 0; --j) {
        const std::size_t at = pad.at(0, j);
        onVectors<Number, backwardRowAlone<Number>>(n, up, &factors_.north[at], &level.value[at]);
    }
}

template <typename T>
void Multigrid<T>::sweepX(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto solve = [&]<std::size_t lines>(int j, Number* rows) {
        const std::size_t first = pad.at(0, j);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + 2 * k * up;
            setRest(n, up, &level.south[at], &level.north[at], &level.right[at], &level.value[at], rows + k * up);
        }
        solveLines<lines>(n, 2 * up, up, &level.west[first], &level.east[first], &level.pivot[0][first], rows,
                          &level.value[first]);
    };
    forLines(pad, colour, solve);
}

/// solve<lines>(first one, work space) for the lines along x of a colour.
template <typename T>
template <typename Solve>
void Multigrid<T>::forLines(const PaddedGrid& pad, int colour, const Solve& solve)
{
    const int count = (pad.ny - colour + 1) / 2;
    Team::mine().items(count, least(count, leastLines(pad.nx)), 4, [&](int first, int end, int thread) {
        forEverySecond(colour + 2 * first, colour + 2 * end - 1,
                       [&]<std::size_t lines>(int j) { solve.template operator()<lines>(j, rowsOf(thread)); });
    });
}

template <typename T>
void Multigrid<T>::sweepY(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    solveRows(pad, colour, level.north.data(), level.pivot[1].data(), level.value.data(),
              [&](std::size_t at, int count) {
                  onVectors<Number, forwardRow<Real, Number>>(count, 0, pad.stride(), &level.west[at], &level.east[at],
                                                              &level.south[at], &level.pivot[1][at], &level.right[at],
                                                              &level.value[at]);
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
    const auto solve = [&]<std::size_t lines>(int j, Number* rows) {
        const std::size_t first = pad.at(0, j);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + 2 * k * up;
            onVectors<Number, setNineRest<Number, Number>>(n, up, besideAt(at), &level.right[at], &level.value[at],
                                                           rows + k * up);
        }
        solveLines<lines>(n, 2 * up, up, &nine_.beside[3][first], &nine_.beside[4][first], &nine_.pivot[0][first], rows,
                          &level.value[first]);
    };
    forLines(pad, colour, solve);
}

template <typename T>
void Multigrid<T>::sweepNineY(int colour)
{
    Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    solveRows(pad, colour, nine_.beside[6].data(), nine_.pivot[1].data(), level.value.data(),
              [&](std::size_t at, int count) {
                  onVectors<Number, forwardNineRow<Number, Number>>(
                      count, 0, pad.stride(), besideAt(at), &nine_.pivot[1][at], &level.right[at], &level.value[at]);
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
    const auto leave = [&]<bool add>(int j, Number* row) {
        const std::size_t at = fine.pad.at(0, j);
        onVectors<Number, setResidual<add, Real, Number>>(n, up, &fine.west[at], &fine.east[at], &fine.south[at],
                                                          &fine.north[at], &fine.centre[at], &fine.right[at],
                                                          &fine.value[at], row);
    };
    Team::mine().items(
        coarse.pad.ny, least(coarse.pad.ny, leastLines(fine.pad.nx)), 1, [&](int begin, int end, int thread) {
            Number* row = rowsOf(thread);
            row[n] = Number{}; // beside the last column of an odd number
            for (int j = begin; j < end; ++j) {
                leave.template operator()<false>(2 * j, row);
                if (2 * j + 1 < fine.pad.ny) leave.template operator()<true>(2 * j + 1, row);
                addPairs(static_cast<std::size_t>(coarse.pad.nx), row, &coarse.right[coarse.pad.at(0, j)]);
            }
        });
}

template <typename T>
void Multigrid<T>::prolong(const Level& coarse, Level& fine)
{
    const auto add = [&](int j, Number* row) {
        const int beside = j % 2 == 0 ? j / 2 - 1 : j / 2 + 1;
        addBilinear<Real>(static_cast<std::size_t>(coarse.pad.nx), &coarse.value[coarse.pad.at(-1, j / 2)],
                          &coarse.value[coarse.pad.at(-1, beside)], row, &fine.value[fine.pad.at(0, j)]);
        fine.value[fine.pad.at(fine.pad.nx, j)] = Number{}; // of an odd number of columns, written above
    };
    Team::mine().items(fine.pad.ny, least(fine.pad.ny, 2 * leastLines(fine.pad.nx)), 1,
                       [&](int first, int end, int thread) {
                           for (int j = first; j < end; ++j) add(j, rowsOf(thread));
                       });
}

template <typename T>
void Multigrid<T>::cycle(std::size_t l)
{
    Level& level = levels_[l];
    Team::mine().items(static_cast<int>(level.value.size()), 4 * leastCells, 64, [&](int first, int end, int) {
        std::fill(level.value.begin() + first, level.value.begin() + end, Number{});
    });
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
    give(v);
}

template <typename T>
void Multigrid<T>::solveFactors(std::span<const T> b, std::span<T> v)
{
    take(b);
    solveByFactors();
    give(v);
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
    give(v);
}

template class Multigrid<double>;
template class Multigrid<std::complex<double>>;

} // namespace touchdown
