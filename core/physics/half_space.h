// SPDX-License-Identifier: GPL-3.0-or-later
//
// Normal displacement of an elastic half-space under pressure that is uniform over each cell of a grid (Love 1929; Johnson
// 1985, equation 3.25). Over the corners' coordinates a, b of a cell seen from a point, with r = sqrt(a^2 + b^2),
//
//   u = p/(pi E*) [a ln(b + r) + b ln(a + r)] between the corners,
//
// summed over all cells as a convolution by FFT. Free: zero-padded to twice the size, exact. Periodic: the patch repeats in
// both directions, u = 2 p/(E* k) for the wave number k (Johnson 1985, section 13.2; Stanley & Kato 1997), and the mean
// pressure displaces nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/numerics/uniform_grid.h"

namespace touchdown {

enum class HalfSpaceEdges : std::uint8_t { Free, Periodic };

/// Keeps FFTW's plans and the transformed influence coefficients. One thread at a time for each object.
class HalfSpace {
public:
    /// `modulus` E* [Pa], positive; the grid has at least one cell.
    HalfSpace(const UniformGrid& grid, double modulus, HalfSpaceEdges edges = HalfSpaceEdges::Free);
    ~HalfSpace();
    HalfSpace(HalfSpace&&) noexcept;
    HalfSpace& operator=(HalfSpace&&) noexcept;

    const UniformGrid& grid() const;
    double modulus() const; // E* [Pa]
    HalfSpaceEdges edges() const;

    /// displacement [m], positive into the body, under `pressure` [Pa], positive towards it; each grid().cells() long.
    /// Allocates nothing. They may be the same array.
    void displace(std::span<const double> pressure, std::span<double> displacement);

    /// Displacement of a cell's centre by unit pressure on it alone [m/Pa].
    double ownCompliance() const;

private:
    struct Transform;
    std::unique_ptr<Transform> transform_;
};

} // namespace touchdown
