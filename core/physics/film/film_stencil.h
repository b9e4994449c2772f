// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film's linearisation as what a cell has from itself and the eight around it: what its flows take from the cells
// and, in the complete flux scheme, what these correct, all in one pass over memory. Numbers of single precision, but
// differences of double precision are what they multiply,
//
//   (J v)_0 = sum_k c_k (v_k - v_0) + (sum_k c_k) v_0 + u_0 + what faces pass on of u,   u = rate V v,
//
// so that it is as if conductances were wrong by 1e-7 of themselves: smooth v lose no more than rough ones. The rate
// and the volumes may be others than those of the linearisation.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/numerics/padded_grid.h"

namespace touchdown {

struct FilmStencil {
    explicit FilmStencil(const PaddedGrid& grid);

    /// out = J v, where cells store rate V v [1/s], [m^3]; padded, v zero in its rings, out there left as it is.
    void apply(std::span<const double> v, double rate, std::span<const double> volume, std::span<double> out) const;

    /// What a face across an axis has from its two cells, F = c (v1 + v2)/2 - E (v2 - v1), without and with what it
    /// passes on of their storage, rate V v; padded [m^3/s].
    struct Own {
        std::span<const double> effective, convection;
    };
    void addStored(std::size_t axis, double rate, std::span<const double> volume, const Own& own,
                   std::span<double> effective, std::span<double> convection) const;

    PaddedGrid pad;
    std::array<std::vector<float>, 8> beside; // from south west to north east, row by row; padded [m^3/s]
    std::vector<float> sum;                   // of the nine [m^3/s]
    // Shares of what the cells below and above a face store that it passes on, by axis; padded [-].
    std::array<std::vector<float>, 2> storedBelow, storedAbove;

    // Work space of GasFilm::setStencil.
    std::vector<double> rows;  // slopes of four rows, by three cells each [m^2/s]
    std::vector<double> width; // of a row [1/m]
};

} // namespace touchdown
