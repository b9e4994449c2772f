// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "core/numerics/convection.h"
#include "core/numerics/vector_clones.h"

namespace touchdown {

template <typename T>
Multigrid<T>::Multigrid(const PaddedGrid& pad)
{
    PaddedGrid next = pad;
    for (;;) {
        Level& level = levels_.emplace_back();
        level.pad = next;
        for (int axis = 0; axis < 2; ++axis) {
            level.diffusion[static_cast<std::size_t>(axis)].assign(next.size(), 0.0);
            level.convection[static_cast<std::size_t>(axis)].assign(next.size(), 0.0);
            level.pivot[static_cast<std::size_t>(axis)].assign(next.size(), T{});
        }
        for (auto* field : {&level.west, &level.east, &level.south, &level.north}) field->assign(next.size(), 0.0);
        for (auto* field : {&level.centre, &level.mass}) field->assign(next.size(), T{});
        if (levels_.size() > 1)
            for (auto* field : {&level.ownValue, &level.ownRight}) field->assign(next.size(), T{});
        level.v = level.ownValue.data();
        level.b = level.ownRight.data();
        if (std::min(next.nx, next.ny) <= 4) break;
        next = {(next.nx + 1) / 2, (next.ny + 1) / 2};
    }
    for (auto& field : effective_) field.assign(pad.size(), 0.0);
    row_.assign(pad.stride(), T{});
}

template <typename T>
void Multigrid<T>::setOperator(const std::array<FaceOperator, 2>& faces, std::span<const T> diagonal)
{
    Level& finest = levels_.front();
    for (std::size_t axis = 0; axis < 2; ++axis) {
        std::copy(faces[axis].diffusion.begin(), faces[axis].diffusion.end(), finest.diffusion[axis].begin());
        std::copy(faces[axis].convection.begin(), faces[axis].convection.end(), finest.convection[axis].begin());
    }
    if (diagonal.empty()) std::fill(finest.mass.begin(), finest.mass.end(), T{});
    else std::copy(diagonal.begin(), diagonal.end(), finest.mass.begin());
    stencil(finest, {faces[0].effective, faces[1].effective});
    factor(finest);
    for (std::size_t l = 1; l < levels_.size(); ++l) {
        Level& level = levels_[l];
        coarsen(levels_[l - 1], level);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (int j = 0; j < level.pad.ny + (axis == 1); ++j)
                for (int i = 0; i < level.pad.nx + (axis == 0); ++i) {
                    const std::size_t at = level.pad.at(i, j);
                    effective_[axis][at] =
                        effectiveConductance<ConvectionScheme::Exponential>(level.diffusion[axis][at],
                                                                            level.convection[axis][at])
                            .value;
                }
        stencil(level, {effective_[0], effective_[1]});
        factor(level);
    }
}

template <typename T>
void Multigrid<T>::stencil(Level& level, const std::array<std::span<const double>, 2>& effective)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride();
    const std::vector<double>& cx = level.convection[0];
    const std::vector<double>& cy = level.convection[1];
    const std::span<const double> ex = effective[0], ey = effective[1];
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            level.east[at] = 0.5 * cx[at + 1] - ex[at + 1];
            level.west[at] = -0.5 * cx[at] - ex[at];
            level.north[at] = 0.5 * cy[at + up] - ey[at + up];
            level.south[at] = -0.5 * cy[at] - ey[at];
            const double flow = (0.5 * cx[at + 1] + ex[at + 1]) + (ex[at] - 0.5 * cx[at]) +
                                (0.5 * cy[at + up] + ey[at + up]) + (ey[at] - 0.5 * cy[at]);
            T centre = flow + level.mass[at];
            if (!(std::abs(centre) > 0.0)) centre = 1.0; // a cell without an open face keeps its value
            level.centre[at] = centre;
        }
    // The rings hold zero: what multiplies them is never needed.
}

/// 1/pivots of lines along x, several at once.
template <int lines, typename T>
void factorLines(std::size_t first, std::size_t apart, std::size_t n, const double* west, const double* east, const T* centre,
                 T* pivot)
{
    std::array<T, lines> last{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + k * apart + i;
            const double couple = i > 0 ? west[at] * east[at - 1] : 0.0;
            pivot[at] = last[k] = 1.0 / (centre[at] - couple * last[k]);
        }
}

template <typename T>
void Multigrid<T>::factor(Level& level)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto factor = [&]<int lines>(int j) {
        factorLines<lines>(pad.at(0, j), up, n, level.west.data(), level.east.data(), level.centre.data(), level.pivot[0].data());
    };
    int first = 0;
    for (; first + 3 < pad.ny; first += 4) factor.template operator()<4>(first);
    for (; first < pad.ny; ++first) factor.template operator()<1>(first);
    for (int i = 0; i < pad.nx; ++i) level.pivot[1][pad.at(i, 0)] = 1.0 / level.centre[pad.at(i, 0)];
    for (int j = 1; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            level.pivot[1][at] =
                1.0 / (level.centre[at] - level.south[at] * level.north[at - up] * level.pivot[1][at - up]);
        }
}

template <typename T>
void Multigrid<T>::coarsen(const Level& fine, Level& coarse)
{
    const PaddedGrid& from = fine.pad;
    const PaddedGrid& to = coarse.pad;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t step = from.step(static_cast<int>(axis)), across = from.step(axis == 0 ? 1 : 0);
        const int n = axis == 0 ? from.nx : from.ny, nAcross = axis == 0 ? from.ny : from.nx;
        const std::vector<double>& K = fine.diffusion[axis];
        for (int j = 0; j < to.ny + (axis == 1); ++j)
            for (int i = 0; i < to.nx + (axis == 0); ++i) {
                const int line = axis == 0 ? i : j, side = axis == 0 ? j : i;
                const int fineLine = std::min(2 * line, n);
                const std::size_t first =
                    axis == 0 ? from.at(fineLine, 2 * side) : from.at(2 * side, fineLine);
                double diffusion = 0.0, convection = 0.0;
                for (int k = 0; k < 2 && 2 * side + k < nAcross; ++k) {
                    const std::size_t at = first + static_cast<std::size_t>(k) * across;
                    convection += fine.convection[axis][at];
                    // Half a path inside the coarse cell below, the face itself, half a path inside the one above.
                    const bool open = K[at] > 0.0;
                    const double below = fineLine > 1 ? K[at - step] : 0.0;
                    const double above = fineLine < n - 1 ? K[at + step] : 0.0;
                    const bool pairBelow = fineLine > 1 && (fineLine % 2 == 0); // the coarse cell below has two cells
                    const bool pairAbove = fineLine < n - 1;
                    if (!open || (pairBelow && below <= 0.0) || (pairAbove && above <= 0.0)) continue;
                    diffusion += 1.0 / (1.0 / K[at] + (pairBelow ? 0.5 / below : 0.0) + (pairAbove ? 0.5 / above : 0.0));
                }
                const std::size_t at = to.at(i, j);
                coarse.diffusion[axis][at] = diffusion;
                coarse.convection[axis][at] = convection;
            }
    }
    for (int j = 0; j < to.ny; ++j)
        for (int i = 0; i < to.nx; ++i) {
            T sum{};
            for (int b = 2 * j; b < std::min(2 * j + 2, from.ny); ++b)
                for (int a = 2 * i; a < std::min(2 * i + 2, from.nx); ++a) sum += fine.mass[from.at(a, b)];
            coarse.mass[to.at(i, j)] = sum;
        }
}

/// Solves `lines` lines along x at once, `apart` from each other: each waits for its last result, others fill the time.
template <int lines, typename T>
void solveLines(std::size_t first, std::size_t apart, std::size_t n, std::size_t up, const double* west, const double* east,
                const double* south, const double* north, const T* pivot, const T* b, T* v)
{
    std::array<T, lines> last{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + k * apart + i;
            const T rest = b[at] - south[at] * v[at - up] - north[at] * v[at + up];
            v[at] = last[k] = (rest - west[at] * last[k]) * pivot[at];
        }
    for (std::size_t i = n - 1; i-- > 0;)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + k * apart + i;
            v[at] = last[k] = v[at] - east[at] * pivot[at] * last[k];
        }
}

template <typename T>
void Multigrid<T>::sweepX(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto solve = [&]<int lines>(int j) {
        solveLines<lines>(pad.at(0, j), 2 * up, n, up, level.west.data(), level.east.data(), level.south.data(),
                          level.north.data(), level.pivot[0].data(), level.b, level.v);
    };
    int j = colour;
    for (; j + 6 < pad.ny; j += 8) solve.template operator()<4>(j);
    for (; j < pad.ny; j += 2) solve.template operator()<1>(j);
}

/// Rows of the lines along y, from the first to the last: v = (b - west and east - south) pivot in every second column.
template <typename T>
TOUCHDOWN_VECTOR_CLONES void forwardRow(std::size_t n, std::size_t colour, std::size_t up, const double* west,
                                        const double* east, const double* south, const T* pivot, const T* b, T* v)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const T below = v[i - up], old = v[i];
        const T value = (b[i] - west[i] * v[i - 1] - east[i] * v[i + 1] - south[i] * below) * pivot[i];
        v[i] = (i & 1) == colour ? value : old;
    }
}
template <typename T>
TOUCHDOWN_VECTOR_CLONES void backwardRow(std::size_t n, std::size_t colour, std::size_t up, const double* north,
                                         const T* pivot, T* v)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) {
        const T above = v[i + up], old = v[i];
        v[i] = (i & 1) == colour ? old - north[i] * pivot[i] * above : old;
    }
}

template <typename T>
void Multigrid<T>::sweepY(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx), c = static_cast<std::size_t>(colour);
    for (int j = 0; j < pad.ny; ++j) {
        const std::size_t at = pad.at(0, j); // below the first row the ring holds zero
        forwardRow(n, c, up, &level.west[at], &level.east[at], &level.south[at], &level.pivot[1][at], level.b + at, level.v + at);
    }
    for (int j = pad.ny - 2; j >= 0; --j) {
        const std::size_t at = pad.at(0, j);
        backwardRow(n, c, up, &level.north[at], &level.pivot[1][at], level.v + at);
    }
}

template <typename T>
void Multigrid<T>::sweep(Level& level)
{
    for (int colour = 0; colour < 2; ++colour) sweepX(level, colour);
    for (int colour = 0; colour < 2; ++colour) sweepY(level, colour);
}

template <typename T>
void Multigrid<T>::restrictResidual(const Level& fine, Level& coarse, bool swept)
{
    const std::size_t up = fine.pad.stride();
    const auto residual = [&](std::size_t at) {
        return fine.b[at] - fine.centre[at] * fine.v[at] - fine.west[at] * fine.v[at - 1] - fine.east[at] * fine.v[at + 1] -
               fine.south[at] * fine.v[at - up] - fine.north[at] * fine.v[at + up];
    };
    for (int j = 0; j < coarse.pad.ny; ++j) {
        T* out = coarse.ownRight.data() + coarse.pad.at(0, j);
        std::fill(out, out + coarse.pad.nx, T{});
        for (int b = 2 * j; b < std::min(2 * j + 2, fine.pad.ny); ++b) {
            const std::size_t first = fine.pad.at(0, b);
            for (int i = 0; i < coarse.pad.nx; ++i) out[i] += residual(first + 2 * static_cast<std::size_t>(i));
            // After a sweep nothing is left in the odd columns, which were solved last.
            for (int i = 0; !swept && 2 * i + 1 < fine.pad.nx; ++i) out[i] += residual(first + 2 * static_cast<std::size_t>(i) + 1);
        }
    }
}

/// Bilinear: a fine cell takes nine, three, three and one sixteenths of the four coarse cells around its centre.
template <typename T>
void Multigrid<T>::prolong(const Level& coarse, Level& fine)
{
    const int n = coarse.pad.nx;
    for (int j = 0; j < fine.pad.ny; ++j) {
        const T* own = coarse.v + coarse.pad.at(-1, j / 2);
        const T* next = coarse.v + coarse.pad.at(-1, j % 2 == 0 ? j / 2 - 1 : j / 2 + 1);
        for (int i = 0; i < n + 2; ++i) row_[static_cast<std::size_t>(i)] = 0.1875 * own[i] + 0.0625 * next[i];
        const T* row = row_.data() + 1;
        T* v = fine.v + fine.pad.at(0, j);
        for (int i = 0; i < n; ++i) {
            v[2 * i] += 3.0 * row[i] + row[i - 1];
            if (2 * i + 1 < fine.pad.nx) v[2 * i + 1] += 3.0 * row[i] + row[i + 1];
        }
    }
}

template <typename T>
void Multigrid<T>::cycle(std::size_t l)
{
    Level& level = levels_[l];
    if (l + 1 == levels_.size()) {
        for (int k = 0; k < 6; ++k) sweep(level);
        return;
    }
    Level& coarse = levels_[l + 1];
    sweep(level);
    restrictResidual(level, coarse, true);
    std::fill(coarse.ownValue.begin(), coarse.ownValue.end(), T{});
    cycle(l + 1);
    prolong(coarse, level);
    sweep(level);
}

template <typename T>
void Multigrid<T>::precondition(std::span<const T> b, std::span<T> v)
{
    levels_.front().b = b.data();
    levels_.front().v = v.data();
    std::fill(v.begin(), v.end(), T{});
    cycle(0);
}

template <typename T>
void Multigrid<T>::halfCycle(std::span<const T> b, std::span<T> v)
{
    solveFactors(b, v);
    Level& finest = levels_.front();
    finest.b = b.data();
    finest.v = v.data();
    if (levels_.size() == 1) return;
    restrictResidual(finest, levels_[1], false);
    std::fill(levels_[1].ownValue.begin(), levels_[1].ownValue.end(), T{});
    cycle(1);
    prolong(levels_[1], finest);
}

template class Multigrid<double>;
template class Multigrid<std::complex<double>>;

} // namespace touchdown
