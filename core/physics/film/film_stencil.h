// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film's linearisation as coefficients of a cell and its eight neighbours: the flows and, in the complete flux
// scheme, their corrections, in one pass over memory. The coefficients have single precision; they multiply differences
// of double precision,
//
//   (J v)_0 = sum_k c_k (v_k - v_0) + (sum_k c_k) v_0 + u_0 + storage shared between faces,   u = rate V v,
//
// u spread along x (core/numerics/row_spread.h); passed on across y of u, across x of u with what faces across
// y pass on,
//
// so that the relative error of the conductances is 1e-7, for smooth v too. The rate and the volumes may differ from
// those of the linearisation.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/numerics/multigrid.h"
#include "core/numerics/padded_grid.h"
#include "core/work/team.h"

namespace touchdown {

class RowSpread;

struct FilmStencil {
    explicit FilmStencil(const PaddedGrid& grid);

    /// out = J v, where cells store rate V v [1/s], [m^3]; padded, v zero in its rings, out there left as it is.
    void apply(std::span<const double> v, double rate, std::span<const double> volume, std::span<double> out);

    /// Coefficients of a face in its two cells, F = c (v1 + v2)/2 - E (v2 - v1), without and with the share of their
    /// storage, rate V v, that it passes on; padded [m^3/s].
    struct Own {
        std::span<const double> effective, convection;
    };
    void addStored(std::size_t axis, double rate, std::span<const double> volume, const Own& own,
                   std::span<double> effective, std::span<double> convection) const;

    /// For multigrid: J = points() + rate storagePoints(), but for the spreading of the storage, which would need cells
    /// farther away; storagePoints() as of the last setStorage(). reserve() allocates what that needs; else its first
    /// call does.
    NinePoints points() const;
    NinePoints storagePoints() const;
    void setStorage(std::span<const double> volume);
    void reserve();

    PaddedGrid pad;
    const RowSpread* spread = nullptr;        // of the film; without: the storage is not spread
    std::array<std::vector<float>, 8> beside; // from south west to north east, row by row; padded [m^3/s]
    std::vector<float> sum;                   // of the nine [m^3/s]
    // Shares of the storage of the cells below and above a face that it passes on, by axis; padded [-].
    std::array<std::vector<float>, 2> storedBelow, storedAbove;
    // The same of the faces across y, not limited, for the slope of the flow along x.
    std::vector<float> crossBelow, crossAbove;
    std::array<std::vector<float>, 8> storedBeside; // nine points of the storage, as `beside` and `sum` [m^3]
    std::vector<float> storedSum;

    int threads = 1; // with work space
    // Work space of GasFilm::setStencil, by thread.
    std::vector<double> rows;  // slopes of four rows, by three cells each [m^2/s]
    std::vector<double> width; // of a row [1/m]
    // Of apply: V v of three rows, of one with what faces across y pass on, and flows of a row that spread it [Pa m^3].
    std::vector<double> stored;

private:
    void applyRows(std::span<const double> v, double rate, std::span<const double> volume, std::span<double> out,
                   Block block, int thread);
};

/// Flows through the faces across x and across y, with the slopes and the storage of each cell: padded work space.
template <typename T>
struct FaceFlows {
    std::array<std::vector<T>, 2> flow, slope;
    std::vector<T> stored;  // empty: nothing
    std::vector<T> passing; // per width along y, and flows across y with what the faces there pass on of it
    void resize(std::size_t size)
    {
        for (auto* pair : {&flow, &slope})
            for (auto& field : *pair) field.assign(size, T{});
        for (auto* field : {&stored, &passing}) field->reserve(size);
    }
};

} // namespace touchdown
