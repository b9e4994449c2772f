// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of a contact whose pressure is sought, as runs of neighbours in the order of storage, and what conjugate
// gradients do on them alone. Fields are those of the whole grid; sums are taken in an order that depends on the cells only.
//
// Preconditioner: the stiffness K of the half-space itself (Stanley & Kato 1997; Vollebregt 2014 uses it by FFT), which falls
// as 1/r^3, cut to the nearest cells. Cutting by the triangle (1 - |i|/m)(1 - |j|/m), whose transform is nowhere negative,
// keeps it positive definite. It takes the array as one line, so that it reaches round the ends of rows: there it couples
// cells that are apart, which costs nothing but a little of its worth.
#pragma once

#include <cstddef>
#include <vector>

#include "core/physics/half_space.h"

namespace touchdown {

class ContactCells {
public:
    explicit ContactCells(const HalfSpace& space);

    void clear();
    /// In rising order.
    void add(std::size_t cell);
    std::size_t count() const { return count_; }

    /// Values that a field given to precondition() needs before its first cell and after its last; there and wherever no
    /// cell is, it must be zero.
    std::size_t margin() const { return margin_; }
    /// out = K cut * in. Returns the sum of out.
    double precondition(const double* in, double* out) const;

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
    static constexpr int reach = 2; // cells
    std::vector<Run> runs_;
    std::size_t count_ = 0, margin_, stride_;
    double stencil_[reach + 1][reach + 1]; // by |j|, |i| [Pa/m]
};

} // namespace touchdown
