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
        if (piece.depth == deepest) {
            if (piece.c[4] < 0.0) return piece.begin + std::ldexp(1.0, -deepest);
            continue;
        }
        const int depth = piece.depth + 1;
        const Coefficients right = split(piece.c);
        stack[size++] = {right, piece.begin + std::ldexp(1.0, -depth), depth};
        stack[size++] = {piece.c, piece.begin, depth};
    }
    return std::nullopt;
}

} // namespace touchdown
