// SPDX-License-Identifier: GPL-3.0-or-later
//
// The approximate inverse by factors, one along each axis.
#include <array>
#include <complex>

#include "core/numerics/multigrid.h"
#include "core/numerics/vector_clones.h"

namespace touchdown {

namespace {

/// The lines along x of a factored operator: as solveLines, without what comes from the lines beside.
template <int lines, typename T>
void solveLinesAlone(std::size_t first, std::size_t apart, std::size_t n, const double* west, const double* east, const T* pivot,
                     const T* b, T* v)
{
    std::array<T, lines> last{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + k * apart + i;
            v[at] = last[k] = (b[at] - west[at] * last[k]) * pivot[at];
        }
    for (std::size_t i = n - 1; i-- > 0;)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + k * apart + i;
            v[at] = last[k] = v[at] - east[at] * pivot[at] * last[k];
        }
}

/// Rows of its lines along y.
template <typename T>
TOUCHDOWN_VECTOR_CLONES void forwardRowAlone(std::size_t n, std::size_t up, const double* south, const T* centre, const T* pivot,
                                             T* v)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) v[i] = (centre[i] * v[i] - south[i] * v[i - up]) * pivot[i];
}
template <typename T>
TOUCHDOWN_VECTOR_CLONES void backwardRowAlone(std::size_t n, std::size_t up, const double* north, const T* pivot, T* v)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i) v[i] -= north[i] * pivot[i] * v[i + up];
}

} // namespace

template <typename T>
void Multigrid<T>::solveFactors(std::span<const T> b, std::span<T> v)
{
    const Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto solve = [&]<int lines>(int j) {
        solveLinesAlone<lines>(pad.at(0, j), up, n, level.west.data(), level.east.data(), level.pivot[0].data(), b.data(), v.data());
    };
    int first = 0;
    for (; first + 3 < pad.ny; first += 4) solve.template operator()<4>(first);
    for (; first < pad.ny; ++first) solve.template operator()<1>(first);
    for (int j = 1; j < pad.ny; ++j) {
        const std::size_t at = pad.at(0, j);
        forwardRowAlone(n, up, &level.south[at], &level.centre[at], &level.pivot[1][at], v.data() + at);
    }
    for (int j = pad.ny - 2; j >= 0; --j) {
        const std::size_t at = pad.at(0, j);
        backwardRowAlone(n, up, &level.north[at], &level.pivot[1][at], v.data() + at);
    }
}

template void Multigrid<double>::solveFactors(std::span<const double>, std::span<double>);
template void Multigrid<std::complex<double>>::solveFactors(std::span<const std::complex<double>>, std::span<std::complex<double>>);

} // namespace touchdown
