// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of a contact whose pressure is unknown, as runs of neighbours in the order of storage, and the operations
// of conjugate gradients on them. Arrays are those of the whole grid; the order of sums depends only on the cells.
//
// Preconditioner: the factorised sparse approximate inverse of the cells' compliances (Kolotilina & Yeremin 1993), M =
// G^T G. Row i of G couples cell i and the unknown ones among the twelve cells before it, at most two rows and two
// columns away: it is the last row of the inverse Cholesky factor of their compliances. These depend on distances only,
// so rows are looked up by the set of unknown neighbours. Neighbours reach round the ends of rows, where the coupled
// cells are not near each other: this makes M slightly less effective. M is positive definite for any set of cells.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/physics/contact/half_space.h"

namespace touchdown {

class ContactCells {
public:
    explicit ContactCells(const HalfSpace& space);

    void clear();
    /// In rising order.
    void add(std::size_t cell);

    /// Number of values that the array given to precondition() needs before its first and after its last cell. It must
    /// be zero there and at all other cells.
    std::size_t margin() const { return margin_; }
    /// out = M in.
    void precondition(const double* in, double* out);

    double product(const double* a, const double* b) const;
    /// a += factor b
    void add(double factor, const double* b, double* a) const;
    /// a = b + factor a
    void scaleAndAdd(double factor, const double* b, double* a) const;
    /// The largest |a|.
    double largest(const double* a) const;

    template <typename Visit>
    void forEach(Visit&& visit) const
    {
        for (const Run& run : runs_)
            for (std::size_t at = run.first; at < run.last; ++at) visit(at);
    }

    struct Run {
        std::size_t first, last; // one past the end
    };

private:
    void findSets();

    static constexpr int neighbours = 12;
    using Row = std::array<double, neighbours + 4>; // G's, in the order of `offsets_`, the cell itself last; padded

    std::vector<Run> runs_;
    std::size_t margin_;
    std::vector<Row> rows_;                // by the set of neighbours that take part, as bits
    std::vector<unsigned char> takesPart_; // with the margin before
    std::vector<std::uint16_t> set_;       // of each cell, by index
    bool setsHold_ = false;
    std::vector<double> half_, whole_; // G in; G^T G in, with the margin before and after
    std::vector<int> usable_;          // neighbours
    std::ptrdiff_t stride_;
};

} // namespace touchdown
