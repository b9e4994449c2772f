// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/numerics/vector_clones.h"

namespace touchdown {
namespace {

using Runs = std::span<const ContactCells::Run>;

/// Eight sums side by side, whatever the width of vectors.
struct Sums {
    std::array<double, 8> of{};
    double total() const { return ((of[0] + of[4]) + (of[2] + of[6])) + ((of[1] + of[5]) + (of[3] + of[7])); }
};

TOUCHDOWN_VECTOR_CLONES double sumProducts(Runs runs, const double* a, const double* b)
{
    Sums sums;
    for (const auto [first, last] : runs) {
        std::size_t at = first;
        for (; at + 8 <= last; at += 8)
            for (std::size_t k = 0; k < 8; ++k) sums.of[k] += a[at + k] * b[at + k];
        for (std::size_t k = 0; at + k < last; ++k) sums.of[k] += a[at + k] * b[at + k];
    }
    return sums.total();
}

TOUCHDOWN_VECTOR_CLONES void addProduct(Runs runs, double factor, const double* b, double* a)
{
    for (const auto [first, last] : runs)
#pragma GCC ivdep
        for (std::size_t at = first; at < last; ++at) a[at] += factor * b[at];
}

TOUCHDOWN_VECTOR_CLONES void multiplyAndAdd(Runs runs, double factor, const double* b, double* a)
{
    for (const auto [first, last] : runs)
#pragma GCC ivdep
        for (std::size_t at = first; at < last; ++at) a[at] = b[at] + factor * a[at];
}

/// One row of five cells of the stencil, even about its middle.
inline double row(const double (&c)[3], const double* v)
{
    return c[0] * v[0] + (c[1] * (v[-1] + v[1]) + c[2] * (v[-2] + v[2]));
}

TOUCHDOWN_VECTOR_CLONES void applyStencil(Runs runs, const double (&c)[3][3], std::ptrdiff_t stride, const double* in, double* out)
{
    for (const auto [first, last] : runs)
#pragma GCC ivdep
        for (std::size_t at = first; at < last; ++at) {
            const double* v = in + at;
            out[at] = row(c[0], v) + ((row(c[1], v - stride) + row(c[1], v + stride)) + (row(c[2], v - 2 * stride) + row(c[2], v + 2 * stride)));
        }
}

} // namespace

ContactCells::ContactCells(const HalfSpace& space)
    : margin_(reach * static_cast<std::size_t>(space.grid().nx) + reach), stride_(static_cast<std::size_t>(space.grid().nx))
{
    static_assert(reach == 2, "applyStencil()");
    runs_.reserve(space.grid().cells() / 2 + 1);
    // What near cells do to each other hardly depends on how large the grid is.
    constexpr int n = 16;
    HalfSpace small({n, n, space.grid().dx, space.grid().dy}, space.modulus(), HalfSpaceEdges::Periodic);
    std::vector<double> field(n * n, 0.0);
    field[0] = 1.0;
    small.stress(field, field);
    const auto triangle = [](int i) { return 1.0 - static_cast<double>(i) / (reach + 1); };
    for (int j = 0; j <= reach; ++j)
        for (int i = 0; i <= reach; ++i) stencil_[j][i] = triangle(j) * triangle(i) * field[static_cast<std::size_t>(j * n + i)];
}

void ContactCells::clear()
{
    runs_.clear();
    count_ = 0;
}

void ContactCells::add(std::size_t cell)
{
    if (runs_.empty() || runs_.back().last != cell) runs_.push_back({cell, cell});
    ++runs_.back().last;
    ++count_;
}

double ContactCells::precondition(const double* in, double* out) const
{
    applyStencil(runs_, stencil_, static_cast<std::ptrdiff_t>(stride_), in, out);
    double sum = 0.0;
    for (const Run& run : runs_)
        for (std::size_t at = run.first; at < run.last; ++at) sum += out[at];
    return sum;
}

double ContactCells::product(const double* a, const double* b) const { return sumProducts(runs_, a, b); }
void ContactCells::add(double factor, const double* b, double* a) const { addProduct(runs_, factor, b, a); }
void ContactCells::scaleAndAdd(double factor, const double* b, double* a) const { multiplyAndAdd(runs_, factor, b, a); }

void ContactCells::fill(double value, double* a) const
{
    for (const Run& run : runs_) std::fill(a + run.first, a + run.last, value);
}

double ContactCells::largest(const double* a) const
{
    double most = 0.0;
    for (const Run& run : runs_)
        for (std::size_t at = run.first; at < run.last; ++at) most = std::max(most, std::abs(a[at]));
    return most;
}

} // namespace touchdown
