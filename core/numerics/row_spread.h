// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources of cells spread along the rows of a grid, for waves of few cells. A scheme that takes the source S of a cell
// as even over the cell (complete flux, box scheme) carries a wave v = exp(i k x) at the flow A v, without diffusion,
// with a = 1 - exp(-i k), k the phase from cell to cell, by
//
//   A a v + (1 - a/2) S = 0,  S = s V v:   s = -(A/V) 2 i tan(k/2) = -(A/V) i k (1 + k^2/12 + ...),
//
// too fast by 3 % at ten cells a wave. Spread to its neighbours,
//
//   S'_i = S_i - (phi_(i+1) - phi_i),   phi_i = c e_i l_i (S_i/b_i - S_(i-1)/b_(i-1)),   c = 1/12,
//
// l the distance of the centres on either side of face i, b the widths of the cells [m] and e = 1, the source has the
// factor 1 + c d, d = 2 - 2 cos k, and s = -(A/V) i k (1 + 11 k^4/720 + ...): fourth order. 1/12 is the moment of a
// linear source about the face, 1/8, less that of the cell's mean against its middle, 1/24. Where diffusion is fast, c
// = 1/24 would be exact; c = 1/12 leaves there an error as large as c = 0, of the other sign.
//
// phi passes from cell to cell: the sum of S' is that of S. On even cells the map is symmetric and positive: s stays
// imaginary, and no wave grows. Where sources jump faces are closed, phi = 0, as at both ends of a row.
//
// An almost empty cell beside a full one cannot take up a share of what that loses: to draw the air in, its pressure
// would have to fall below zero, and no step is short enough. So weigh() sets e = min(1, 8 m n/(m + n)^2), m and n the
// contents per width of the two cells: 1 down to a ratio of 0.17, as in all smooth films, and towards an empty cell it
// falls as the content does.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/numerics/padded_grid.h"

namespace touchdown {

class RowSpread {
public:
    /// Lines of the grid along x [m]; faces along x that are closed, by padded index in any order.
    RowSpread(const PaddedGrid& grid, std::span<const double> lines, std::span<const std::size_t> closed);

    /// From now on e is that of these contents, volume times density; padded, not negative. Before, e = 1.
    void weigh(std::span<const double> volume, std::span<const double> density);

    /// S in row j becomes S', from its first cell; `passed` is work space for the row's nx + 1 faces.
    template <typename T>
    void spread(int j, T* source, T* passed) const;
    /// The transposed map of a row.
    void spreadTransposed(int j, double* v, double* passed) const;

private:
    PaddedGrid grid_;
    std::vector<double> perWidth_;          // 1/b by column [1/m]
    std::vector<double> share_, evenShare_; // c e l and c l by face, zero at closed ones; padded [m]
};

} // namespace touchdown
