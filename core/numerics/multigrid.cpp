// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/multigrid.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/numerics/convection.h"

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
        for (auto* field : {&level.centre, &level.mass, &level.v, &level.b, &level.r}) field->assign(next.size(), T{});
        if (std::min(next.nx, next.ny) <= 4) break;
        next = {(next.nx + 1) / 2, (next.ny + 1) / 2};
    }
    for (auto& field : effective_) field.assign(pad.size(), 0.0);
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

template <typename T>
void Multigrid<T>::factor(Level& level)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride();
    for (int j = 0; j < pad.ny; ++j) {
        T before{};
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const T pivot = level.centre[at] - level.west[at] * (i > 0 ? level.east[at - 1] : 0.0) * before;
            before = level.pivot[0][at] = 1.0 / pivot;
        }
    }
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

template <typename T>
void Multigrid<T>::sweepX(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride();
    const std::size_t n = static_cast<std::size_t>(pad.nx);
    for (int j = colour; j < pad.ny; j += 2) {
        const std::size_t row = pad.at(0, j);
        const double* west = level.west.data() + row;
        const double* east = level.east.data() + row;
        const double* south = level.south.data() + row;
        const double* north = level.north.data() + row;
        const T* pivot = level.pivot[0].data() + row;
        const T* b = level.b.data() + row;
        T* v = level.v.data() + row;
        T before{};
        for (std::size_t i = 0; i < n; ++i) {
            const T rest = b[i] - south[i] * v[i - up] - north[i] * v[i + up];
            before = (rest - west[i] * before) * pivot[i];
            v[i] = before;
        }
        for (std::size_t i = n - 1; i-- > 0;) v[i] -= east[i] * pivot[i] * v[i + 1];
    }
}

template <typename T>
void Multigrid<T>::sweepY(Level& level, int colour)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride();
    const std::vector<T>& pivot = level.pivot[1];
    for (int j = 0; j < pad.ny; ++j)
        for (int i = colour; i < pad.nx; i += 2) {
            const std::size_t at = pad.at(i, j);
            T rest = level.b[at] - level.west[at] * level.v[at - 1] - level.east[at] * level.v[at + 1];
            if (j > 0) rest -= level.south[at] * level.v[at - up];
            level.v[at] = rest * pivot[at];
        }
    for (int j = pad.ny - 2; j >= 0; --j)
        for (int i = colour; i < pad.nx; i += 2) {
            const std::size_t at = pad.at(i, j);
            level.v[at] -= level.north[at] * pivot[at] * level.v[at + up];
        }
}

template <typename T>
void Multigrid<T>::sweep(Level& level, int axis)
{
    for (int colour = 0; colour < 2; ++colour) axis == 0 ? sweepX(level, colour) : sweepY(level, colour);
}

template <typename T>
void Multigrid<T>::residual(Level& level)
{
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride();
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            level.r[at] = level.b[at] - level.centre[at] * level.v[at] - level.west[at] * level.v[at - 1] -
                          level.east[at] * level.v[at + 1] - level.south[at] * level.v[at - up] -
                          level.north[at] * level.v[at + up];
        }
}

template <typename T>
void Multigrid<T>::cycle(std::size_t l)
{
    Level& level = levels_[l];
    if (l + 1 == levels_.size()) {
        for (int k = 0; k < 6; ++k) {
            sweep(level, 0);
            sweep(level, 1);
        }
        return;
    }
    sweep(level, 0);
    sweep(level, 1);
    residual(level);
    Level& coarse = levels_[l + 1];
    const PaddedGrid& fine = level.pad;
    for (int j = 0; j < coarse.pad.ny; ++j)
        for (int i = 0; i < coarse.pad.nx; ++i) {
            T sum{};
            for (int b = 2 * j; b < std::min(2 * j + 2, fine.ny); ++b)
                for (int a = 2 * i; a < std::min(2 * i + 2, fine.nx); ++a) sum += level.r[fine.at(a, b)];
            coarse.b[coarse.pad.at(i, j)] = sum;
        }
    std::fill(coarse.v.begin(), coarse.v.end(), T{});
    cycle(l + 1);
    // Bilinear: a fine cell takes nine, three, three and one sixteenths of the four coarse cells around its centre.
    for (int j = 0; j < fine.ny; ++j) {
        const int J = j / 2, nextJ = j % 2 == 0 ? J - 1 : J + 1;
        for (int i = 0; i < fine.nx; ++i) {
            const int I = i / 2, nextI = i % 2 == 0 ? I - 1 : I + 1;
            const auto& v = coarse.v;
            const PaddedGrid& pad = coarse.pad;
            level.v[fine.at(i, j)] += 0.5625 * v[pad.at(I, J)] + 0.1875 * (v[pad.at(nextI, J)] + v[pad.at(I, nextJ)]) +
                                      0.0625 * v[pad.at(nextI, nextJ)];
        }
    }
    sweep(level, 0);
    sweep(level, 1);
}

template <typename T>
void Multigrid<T>::precondition(std::span<const T> b, std::span<T> v)
{
    Level& finest = levels_.front();
    std::copy(b.begin(), b.end(), finest.b.begin());
    std::fill(finest.v.begin(), finest.v.end(), T{});
    cycle(0);
    std::copy(finest.v.begin(), finest.v.end(), v.begin());
}

template class Multigrid<double>;
template class Multigrid<std::complex<double>>;

} // namespace touchdown
