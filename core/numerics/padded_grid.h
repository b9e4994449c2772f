// SPDX-License-Identifier: GPL-3.0-or-later
//
// Storage of a field on nx x ny cells with two rings of cells around it, so that stencils of up to five cells along
// each axis need no special cases at the border. A face has the index of the cell on its upper side: along x between
// at - 1 and at, along y between at - stride and at.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace touchdown {

struct PaddedGrid {
    static constexpr int rings = 2;
    int nx = 0, ny = 0;

    std::size_t stride() const { return static_cast<std::size_t>(nx + 2 * rings); }
    std::size_t size() const { return stride() * static_cast<std::size_t>(ny + 2 * rings); }
    std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    /// Value of cell (i, j), each from -2 to n + 1.
    std::size_t at(int i, int j) const
    {
        return static_cast<std::size_t>(j + rings) * stride() + static_cast<std::size_t>(i + rings);
    }
    /// The cell's i and j.
    int column(std::size_t at) const { return static_cast<int>(at % stride()) - rings; }
    int row(std::size_t at) const { return static_cast<int>(at / stride()) - rings; }
    /// The step from a cell to the next along an axis: 0 is x, 1 is y.
    std::size_t step(int axis) const { return axis == 0 ? 1 : stride(); }

    /// From or to an array without rings.
    template <typename T>
    void pad(std::span<const T> plain, std::span<T> padded) const
    {
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) padded[at(i, j)] = plain[static_cast<std::size_t>(j * nx + i)];
    }
    template <typename T>
    std::vector<T> unpad(std::span<const T> padded) const
    {
        std::vector<T> plain(cells());
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) plain[static_cast<std::size_t>(j * nx + i)] = padded[at(i, j)];
        return plain;
    }
};

} // namespace touchdown
