// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/events.h"

namespace touchdown {

namespace {

using Coefficients = std::array<double, 5>;

/// Splits at the middle (de Casteljau): the left half in place, the right one returned.
Coefficients split(Coefficients& left)
{
    Coefficients right = left;
    for (std::size_t level = 1; level < 5; ++level)
        for (std::size_t k = 4; k >= level; --k) left[k] = 0.5 * (left[k - 1] + left[k]);
    for (std::size_t level = 1; level < 5; ++level)
        for (std::size_t k = 0; k + level < 5; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
    return right;
}

bool neverNegative(const Coefficients& c) { return *std::min_element(c.begin(), c.end()) >= 0.0; }

/// One change of sign of the coefficients, here from >= 0 to below zero, is one root (Descartes' rule).
bool descendsOnce(const Coefficients& c)
{
    const auto below = [](double value) { return value < 0.0; };
    return std::is_partitioned(c.rbegin(), c.rend(), below);
}

/// That root, by Newton's iteration kept within a bracket, to `resolution` [-].
double onlyRoot(const Coefficients& c, double resolution)
{
    double inner = 0.0, outer = 1.0;
    double x = c[0] / (c[0] - c[4]);
    for (int i = 0; i < 200; ++i) {
        Coefficients b = c;
        for (std::size_t level = 1; level < 4; ++level)
            for (std::size_t k = 0; k + level < 5; ++k) b[k] += x * (b[k + 1] - b[k]);
        const double value = b[0] + x * (b[1] - b[0]);
        (value < 0.0 ? outer : inner) = x;
        const double newton = x - 0.25 * value / (b[1] - b[0]);
        const double next = newton > inner && newton < outer ? newton : 0.5 * (inner + outer);
        if (std::abs(next - x) <= resolution) return next;
        x = next;
    }
    return x;
}

} // namespace

std::optional<double> firstDescent(const Coefficients& coefficients)
{
    if (coefficients[0] < 0.0) return 0.0;
    if (neverNegative(coefficients)) return std::nullopt;

    // Depth first, left halves first; the stack holds the right halves still to be searched.
    constexpr int deepest = 52;
    struct Piece {
        Coefficients c;
        double begin;
        int depth;
    };
    std::array<Piece, deepest + 2> stack;
    std::size_t size = 0;
    stack[size++] = {coefficients, 0.0, 0};
    while (size > 0) {
        Piece piece = stack[--size];
        if (piece.c[0] < 0.0) return piece.begin;
        if (neverNegative(piece.c)) continue;
        const double width = std::ldexp(1.0, -piece.depth);
        if (descendsOnce(piece.c))
            return piece.begin + width * onlyRoot(piece.c, std::numeric_limits<double>::epsilon() / width);
        if (piece.depth == deepest) {
            if (piece.c[4] < 0.0) return piece.begin + width;
            continue;
        }
        const Coefficients right = split(piece.c);
        stack[size++] = {right, piece.begin + 0.5 * width, piece.depth + 1};
        stack[size++] = {piece.c, piece.begin, piece.depth + 1};
    }
    return std::nullopt;
}

} // namespace touchdown
