// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of a contact whose pressure is sought, as runs of neighbours in the order of storage, and what conjugate
// gradients do on them alone. Fields are those of the whole grid; sums are taken in an order that depends on the cells
// only.
//
// Preconditioner: the factorised sparse approximate inverse of the cells' compliances (Kolotilina & Yeremin 1993), M =
// G^T G. Row i of G serves cell i and those of the twelve cells before it, at most two rows and two columns away, that
// take part: it is the last row of the inverse Cholesky factor of their compliances. These depend on distances alone,
// so that rows are looked up by which of the twelve take part. The array counts as one line, so that neighbours reach
// round the ends of rows: there cells are coupled that are apart, which costs nothing but a little of its worth; M is
// positive definite whatever the cells.
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
    std::size_t count() const { return count_; }

    /// Values that a field given to precondition() needs before its first cell and after its last; there and wherever
    /// no cell is, it must be zero.
    std::size_t margin() const { return margin_; }
    /// out = M in. Returns the sum of out.
    double precondition(const double* in, double* out);

    double product(const double* a, const double* b) const;
    /// a += factor b
    void add(double factor, const double* b, double* a) const;
    /// a = b + factor a
    void scaleAndAdd(double factor, const double* b, double* a) const;
    void fill(double value, double* a) const;
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
    std::size_t count_ = 0, margin_;
    std::vector<Row> rows_;                // by the set of neighbours that take part, as bits
    std::vector<unsigned char> takesPart_; // with the margin before
    std::vector<std::uint16_t> set_;       // of each cell, by index
    bool setsHold_ = false;
    std::vector<double> half_, whole_; // G in; G^T G in, with the margin before and after
    std::vector<int> usable_;          // neighbours
    std::ptrdiff_t stride_;
};

} // namespace touchdown
