// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/row_spread.h"

#include <algorithm>
#include <complex>

#include "core/numerics/vector_clones.h"

namespace touchdown {

namespace {

constexpr double spreading = 1.0 / 12.0; // c of the header

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

} // namespace

RowSpread::RowSpread(const PaddedGrid& grid, std::span<const double> lines, std::span<const std::size_t> closed)
    : nx_(static_cast<std::size_t>(grid.nx)), share_(nx_ + 1, 0.0)
{
    for (std::size_t k = 0; k < nx_; ++k) perWidth_.push_back(1.0 / (lines[k + 1] - lines[k]));
    for (std::size_t k = 1; k < nx_; ++k) share_[k] = 0.5 * spreading * (lines[k + 1] - lines[k - 1]);
    std::vector<std::size_t> ordered(closed.begin(), closed.end());
    std::ranges::sort(ordered);
    std::size_t n = 0;
    for (int j = 0; j < grid.ny; ++j) {
        closedRows_.push_back(closed_.size());
        for (const std::size_t first = grid.at(0, j), end = first + nx_; n < ordered.size() && ordered[n] < end; ++n)
            if (ordered[n] > first) closed_.push_back(ordered[n] - first);
    }
    closedRows_.push_back(closed_.size());
}

template <typename T>
void RowSpread::close(int j, T* passed) const
{
    const std::size_t row = static_cast<std::size_t>(j);
    passed[0] = passed[nx_] = T{};
    for (std::size_t n = closedRows_[row]; n < closedRows_[row + 1]; ++n) passed[closed_[n]] = T{};
}

template <typename T>
void RowSpread::spread(int j, T* source, T* passed) const
{
    setPassed(nx_, share_.data(), perWidth_.data(), source, passed);
    close(j, passed);
    subtractRise(nx_, passed, source);
}

template void RowSpread::spread(int, double*, double*) const;
template void RowSpread::spread(int, std::complex<double>*, std::complex<double>*) const;

void RowSpread::spreadTransposed(int j, double* v, double* passed) const
{
    setPassed(nx_, share_.data(), v, passed);
    close(j, passed);
    subtractRise(nx_, perWidth_.data(), passed, v);
}

} // namespace touchdown
