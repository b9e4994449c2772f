// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_cells.h"

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

constexpr int neighbours = 12;
// Columns and rows from a cell to those before it that its row of G may use, and to itself.
constexpr int columnOf[neighbours + 1] = {-2, -1, 0, 1, 2, -2, -1, 0, 1, 2, -2, -1, 0};
constexpr int rowOf[neighbours + 1] = {-2, -2, -2, -2, -2, -1, -1, -1, -1, -1, 0, 0, 0};

// The last row of L^-1, A = L L^T over the set and the cell itself: y/sqrt(y_last) with A y = (0, .., 0, 1).
std::array<double, neighbours + 4> inverseRow(unsigned set, std::span<const double> compliance)
{
    int member[neighbours + 1];
    int count = 0;
    for (int k = 0; k <= neighbours; ++k)
        if (k == neighbours || (set >> k & 1u) != 0) member[count++] = k;
    double factor[neighbours + 1][neighbours + 1];
    for (int a = 0; a < count; ++a)
        for (int b = 0; b <= a; ++b) {
            const int columns = std::abs(columnOf[member[a]] - columnOf[member[b]]);
            const int rows = std::abs(rowOf[member[a]] - rowOf[member[b]]);
            double value = compliance[static_cast<std::size_t>(5 * rows + columns)];
            for (int c = 0; c < b; ++c) value -= factor[a][c] * factor[b][c];
            factor[a][b] = a == b ? std::sqrt(value) : value / factor[b][b];
        }
    std::array<double, neighbours + 4> row{};
    double y[neighbours + 1] = {};
    for (int a = count - 1; a >= 0; --a) {
        double value = a == count - 1 ? 1.0 : 0.0;
        for (int c = a + 1; c < count; ++c) value -= factor[c][a] * y[c];
        y[a] = value / factor[a][a];
        row[static_cast<std::size_t>(member[a])] = y[a];
    }
    return row;
}

TOUCHDOWN_VECTOR_CLONES void applyRows(Runs runs, const std::uint16_t* sets, const std::array<double, 16>* rows,
                                       std::ptrdiff_t stride, const double* in, double* half, double* out)
{
    for (const auto [first, last] : runs)
        for (std::size_t at = first; at < last; ++at) {
            const double* c = rows[sets[at]].data();
            const double* v = in + at;
            double sum = 0.0;
            for (int k = 0; k < 5; ++k) sum += c[k] * v[k - 2 - 2 * stride] + c[5 + k] * v[k - 2 - stride];
            half[at] = sum + (c[10] * v[-2] + c[11] * v[-1] + c[12] * v[0]);
            out[at] = 0.0;
        }
    for (const auto [first, last] : runs)
        for (std::size_t at = first; at < last; ++at) {
            const double* c = rows[sets[at]].data();
            double* v = out + at;
            const double h = half[at];
            for (int k = 0; k < 5; ++k) v[k - 2 - 2 * stride] += c[k] * h;
            for (int k = 0; k < 5; ++k) v[k - 2 - stride] += c[5 + k] * h;
            for (int k = 0; k < 3; ++k) v[k - 2] += c[10 + k] * h;
        }
}

} // namespace

ContactCells::ContactCells(const HalfSpace& space)
    : margin_(2 * static_cast<std::size_t>(space.grid().nx) + 2), stride_(space.grid().nx)
{
    const std::size_t cells = space.grid().cells();
    runs_.reserve(cells / 2 + 1);
    takesPart_.assign(cells + margin_, 0);
    // On fewer than five columns the line would bring some neighbours back as others.
    for (int k = 0; k < neighbours; ++k)
        if (2 * std::abs(columnOf[k]) < space.grid().nx) usable_.push_back(k);
    set_.assign(cells, 0);
    half_.assign(cells, 0.0);
    whole_.assign(cells + 2 * margin_, 0.0);
    // What near cells do to each other hardly depends on how large the grid is, nor on its edges.
    constexpr int n = 5;
    HalfSpace small({n, n, space.grid().dx, space.grid().dy}, space.modulus());
    std::vector<double> compliance(n * n, 0.0);
    compliance[0] = 1.0;
    small.displace(compliance, compliance);
    for (unsigned set = 0; set < 1u << neighbours; ++set) rows_.push_back(inverseRow(set, compliance));
}

void ContactCells::clear()
{
    runs_.clear();
    setsHold_ = false;
}

void ContactCells::add(std::size_t cell)
{
    if (runs_.empty() || runs_.back().last != cell) runs_.push_back({cell, cell});
    ++runs_.back().last;
    setsHold_ = false;
}

void ContactCells::findSets()
{
    setsHold_ = true;
    std::fill(takesPart_.begin(), takesPart_.end(), static_cast<unsigned char>(0));
    unsigned char* taken = takesPart_.data() + margin_;
    forEach([&](std::size_t i) { taken[i] = 1; });
    forEach([&](std::size_t i) {
        unsigned set = 0;
        for (const int k : usable_)
            set |= static_cast<unsigned>(taken[static_cast<std::ptrdiff_t>(i) + rowOf[k] * stride_ + columnOf[k]]) << k;
        set_[i] = static_cast<std::uint16_t>(set);
    });
}

void ContactCells::precondition(const double* in, double* out)
{
    if (!setsHold_) findSets();
    double* whole = whole_.data() + margin_;
    applyRows(runs_, set_.data(), rows_.data(), stride_, in, half_.data(), whole);
    for (const Run& run : runs_) std::copy(whole + run.first, whole + run.last, out + run.first);
}

double ContactCells::product(const double* a, const double* b) const { return sumProducts(runs_, a, b); }
void ContactCells::add(double factor, const double* b, double* a) const { addProduct(runs_, factor, b, a); }
void ContactCells::scaleAndAdd(double factor, const double* b, double* a) const { multiplyAndAdd(runs_, factor, b, a); }

double ContactCells::largest(const double* a) const
{
    double most = 0.0;
    for (const Run& run : runs_)
        for (std::size_t at = run.first; at < run.last; ++at) most = std::max(most, std::abs(a[at]));
    return most;
}

} // namespace touchdown
