// SPDX-License-Identifier: GPL-3.0-or-later
//
// Normal displacement of an elastic half-space under pressure that is uniform over each cell of a grid (Love 1929;
// Johnson 1985, equation 3.25). Over the corners' coordinates a, b of a cell seen from a point, with r = sqrt(a^2 +
// b^2),
//
//   u = p/(pi E*) [a ln(b + r) + b ln(a + r)] between the corners,
//
// summed over all cells as a convolution by FFT. Free: zero-padded to twice the size, exact. Periodic: the patch
// repeats in both directions, u = 2 p/(E* k) for the wave number k (Johnson 1985, section 13.2; Stanley & Kato 1997),
// and the mean pressure displaces nothing.
//
// The inverse, the pressure of a given displacement, acts on stiffnessGrid(). Periodic: the grid itself, p = E* k u/2.
// Free: the padded grid, whose first columns and rows are the grid; the padded domain repeats, so that the displacement
// outside the grid is not that of the half-space. Where the pressure of stress() vanishes outside the grid, stress() is
// the inverse of displace(). All factors are positive.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/numerics/cell_grid.h"
#include "core/numerics/plane_convolution.h"

namespace touchdown {

enum class HalfSpaceEdges : std::uint8_t { Free, Periodic };

/// Keeps FFTW's plans and the transformed influence coefficients. One thread at a time for each object.
class HalfSpace {
public:
    /// `modulus` E* [Pa], positive; the grid has at least one cell. `goOn` is asked at each row of influence
    /// coefficients; if it returns false, all displacements are zero.
    HalfSpace(const UniformGrid& grid, double modulus, HalfSpaceEdges edges = HalfSpaceEdges::Free,
              const std::function<bool()>& goOn = {});

    const UniformGrid& grid() const { return grid_; }
    double modulus() const { return modulus_; } // E* [Pa]
    HalfSpaceEdges edges() const { return edges_; }

    /// displacement [m], positive into the body, under `pressure` [Pa], positive towards it; each grid().cells() long.
    /// Allocates nothing. They may be the same array.
    void displace(std::span<const double> pressure, std::span<double> displacement)
    {
        compliance_.apply(pressure, displacement);
    }
    /// Displacement of a cell's centre by unit pressure on it alone [m/Pa].
    double ownCompliance() const { return ownCompliance_; }
    /// Largest ratio of displacement to pressure in the mean of squares, over all pressures [m/Pa].
    double largestCompliance() const { return largestCompliance_; }

    const UniformGrid& stiffnessGrid() const { return stiffnessGrid_; }
    /// pressure [Pa] of a displacement [m], each stiffnessGrid().cells() long; may be the same array. Periodic: the
    /// mean displacement takes none. Allocates at the first call only.
    void stress(std::span<const double> displacement, std::span<double> pressure);
    /// Pressure on a cell's centre by unit displacement of it alone [Pa/m].
    double ownStiffness() const { return ownStiffness_; }

private:
    std::vector<double> freeTransform(const std::function<bool()>& goOn) const;
    std::vector<double> periodicTransform() const;

    UniformGrid grid_, stiffnessGrid_;
    double modulus_;
    HalfSpaceEdges edges_;
    double ownCompliance_ = 0.0, largestCompliance_ = 0.0, ownStiffness_ = 0.0;
    PlaneConvolution compliance_;
    std::vector<double> stiffnessTransform_; // until the first stress()
    std::optional<PlaneConvolution> stiffness_;
};

} // namespace touchdown
