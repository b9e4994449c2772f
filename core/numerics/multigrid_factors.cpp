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
template <std::size_t lines, typename Real, typename Number>
void solveLinesAlone(std::size_t count, std::size_t apart, const Real* west, const Real* east, const Number* pivot,
                     const Number* b, Number* v)
{
    std::array<Number, lines> last{};
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = k * apart + i;
            v[at] = last[k] = b[at] * pivot[at] - (west[at] * pivot[at]) * last[k];
        }
    for (std::size_t i = count - 1; i-- > 0;)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = k * apart + i;
            v[at] = last[k] = v[at] - (east[at] * pivot[at]) * last[k];
        }
}

/// Rows of its lines along y.
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

} // namespace

template <typename T>
void Multigrid<T>::solveByFactors()
{
    Level& level = levels_.front();
    const PaddedGrid& pad = level.pad;
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    // A few lines along x, and at once these rows of the lines along y, while they are at hand.
    const auto solve = [&]<std::size_t lines>(int first) {
        const std::size_t from = pad.at(0, first);
        solveLinesAlone<lines>(n, up, &level.west[from], &level.east[from], &level.pivot[0][from], &level.right[from],
                               &level.value[from]);
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = from + k * up; // below the first row the ring holds zero
            forwardRowAlone(n, up, &factorCentre_[at], &factorSouth_[at], &level.value[at]);
        }
    };
    int first = 0;
    for (; first + 3 < pad.ny; first += 4) solve.template operator()<4>(first);
    for (; first < pad.ny; ++first) solve.template operator()<1>(first);
    for (int j = pad.ny - 2; j >= 0; --j) {
        const std::size_t at = pad.at(0, j);
        backwardRowAlone(n, up, &factorNorth_[at], &level.value[at]);
    }
}

template void Multigrid<double>::solveByFactors();
template void Multigrid<std::complex<double>>::solveByFactors();

} // namespace touchdown
