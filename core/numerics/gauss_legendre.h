// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gauss-Legendre quadrature of N points: exact for polynomials of degree 2 N - 1.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace touchdown {

template <std::size_t N>
class GaussLegendre {
public:
    GaussLegendre()
    {
        for (std::size_t i = 0; i < N; ++i) {
            // Newton on the Legendre polynomial P_N from Tricomi's estimate of its root.
            double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (static_cast<double>(N) + 0.5));
            double slope = 0.0;
            for (int step = 0; step < 8; ++step) {
                double before = 0.0, value = 1.0; // P_(k-1), P_k
                for (std::size_t k = 1; k <= N; ++k) {
                    const double n = static_cast<double>(k);
                    const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n;
                    before = value;
                    value = next;
                }
                slope = static_cast<double>(N) * (before - x * value) / (1.0 - x * x);
                x -= value / slope;
            }
            nodes_[i] = x;
            weights_[i] = 2.0 / ((1.0 - x * x) * slope * slope);
        }
    }

    /// Calls add(place, weight) for each point of [lower, upper].
    template <typename Add>
    void sample(double lower, double upper, Add add) const
    {
        const double half = 0.5 * (upper - lower);
        for (std::size_t i = 0; i < N; ++i) add(0.5 * (lower + upper) + half * nodes_[i], half * weights_[i]);
    }

private:
    std::array<double, N> nodes_{}, weights_{}; // of [-1, 1]
};

} // namespace touchdown
