// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/row_spread.h"

#include <algorithm>
#include <complex>

#include "core/numerics/vector_clones.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr double spreading = 1.0 / 12.0; // c of the header
constexpr double leastSquare = 1e-200;   // keeps the ratio of two empty cells finite

TOUCHDOWN_VECTOR_CLONES void setPassed(std::size_t count, const double* share, const double* v, double* passed)
{
#pragma GCC ivdep
    for (std::size_t k = 1; k < count; ++k) passed[k] = share[k] * (v[k] - v[k - 1]);
}

template <typename T>
TOUCHDOWN_VECTOR_CLONES void setPassed(std::size_t count, const double* share, const double* perWidth, const T* source,
                                       T* passed)
{
#pragma GCC ivdep
    for (std::size_t k = 1; k < count; ++k)
        passed[k] = share[k] * (perWidth[k] * source[k] - perWidth[k - 1] * source[k - 1]);
}

template <typename T>
TOUCHDOWN_VECTOR_CLONES void subtractRise(std::size_t count, const T* passed, T* source)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) source[k] -= passed[k + 1] - passed[k];
}

TOUCHDOWN_VECTOR_CLONES void subtractRise(std::size_t count, const double* perWidth, const double* passed, double* v)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) v[k] -= perWidth[k] * (passed[k + 1] - passed[k]);
}

/// e of the header from the contents per width of the cells on either side.
TOUCHDOWN_VECTOR_CLONES void weighRow(std::size_t count, const double* perWidth, const double* volume,
                                      const double* density, const double* even, double* share)
{
#pragma GCC ivdep
    for (std::size_t k = 1; k < count; ++k) {
        const double below = perWidth[k - 1] * volume[k - 1] * density[k - 1];
        const double above = perWidth[k] * volume[k] * density[k], sum = below + above;
        share[k] = even[k] * std::min(1.0, 8.0 * below * above / (sum * sum + leastSquare));
    }
}

} // namespace

RowSpread::RowSpread(const PaddedGrid& grid, std::span<const double> lines, std::span<const std::size_t> closed)
    : grid_(grid), share_(grid.size(), 0.0)
{
    const std::size_t nx = static_cast<std::size_t>(grid.nx);
    for (std::size_t k = 0; k < nx; ++k) perWidth_.push_back(1.0 / (lines[k + 1] - lines[k]));
    for (int j = 0; j < grid.ny; ++j)
        for (std::size_t k = 1; k < nx; ++k)
            share_[grid.at(0, j) + k] = 0.5 * spreading * (lines[k + 1] - lines[k - 1]);
    for (const std::size_t face : closed) share_[face] = 0.0;
    evenShare_ = share_;
}

void RowSpread::weigh(std::span<const double> volume, std::span<const double> density)
{
    Team::mine().items(grid_.ny, 24, 1, [&](int begin, int end, int) {
        for (int j = begin; j < end; ++j) {
            const std::size_t first = grid_.at(0, j);
            weighRow(static_cast<std::size_t>(grid_.nx), perWidth_.data(), &volume[first], &density[first],
                     &evenShare_[first], &share_[first]);
        }
    });
}

template <typename T>
void RowSpread::spread(int j, T* source, T* passed) const
{
    const std::size_t nx = static_cast<std::size_t>(grid_.nx);
    passed[0] = passed[nx] = T{};
    setPassed(nx, &share_[grid_.at(0, j)], perWidth_.data(), source, passed);
    subtractRise(nx, passed, source);
}

template void RowSpread::spread(int, double*, double*) const;
template void RowSpread::spread(int, std::complex<double>*, std::complex<double>*) const;

void RowSpread::spreadTransposed(int j, double* v, double* passed) const
{
    const std::size_t nx = static_cast<std::size_t>(grid_.nx);
    passed[0] = passed[nx] = 0.0;
    setPassed(nx, &share_[grid_.at(0, j)], v, passed);
    subtractRise(nx, perWidth_.data(), passed, v);
}

} // namespace touchdown
