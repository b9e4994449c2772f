// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/half_space.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace touchdown {
namespace {

UniformGrid paddedGrid(const UniformGrid& grid)
{
    return {paddedSize(grid.nx), paddedSize(grid.ny), grid.dx, grid.dy, grid.x0, grid.y0};
}

// a ln(b + r) + b ln(a + r) without the terms in a or b alone, which cancel between the corners; odd in a and in b. The
// cells' values are its second differences, smaller by the square of the distance in cells: hence the long numbers.
long double corner(long double a, long double b)
{
    return a * std::asinh(b / std::abs(a)) + b * std::asinh(a / std::abs(b));
}

// The domain's mean of a transform over its m_x m_y wave numbers: the kernel's value at distance 0.
double kernelAtOrigin(std::span<const double> transform, int mx, int my)
{
    const auto occurrences = [](int k, int m) { return k == 0 || 2 * k == m ? 1.0 : 2.0; };
    double sum = 0.0;
    std::size_t at = 0;
    for (int ky = 0; ky <= my / 2; ++ky)
        for (int kx = 0; kx <= mx / 2; ++kx) sum += occurrences(kx, mx) * occurrences(ky, my) * transform[at++];
    return sum / (static_cast<double>(mx) * my);
}

} // namespace

HalfSpace::HalfSpace(const UniformGrid& grid, double modulus, HalfSpaceEdges edges, const std::function<bool()>& goOn)
    : grid_(grid),
      stiffnessGrid_(edges == HalfSpaceEdges::Free ? paddedGrid(grid) : grid),
      modulus_(modulus),
      edges_(edges),
      compliance_(grid.nx, grid.ny, stiffnessGrid_.nx, stiffnessGrid_.ny)
{
    assert(grid.nx >= 1 && grid.ny >= 1 && grid.dx > 0.0 && grid.dy > 0.0 && modulus > 0.0);
    stiffnessTransform_ = edges == HalfSpaceEdges::Free ? freeTransform(goOn) : periodicTransform();
    compliance_.setTransform(stiffnessTransform_);
    ownCompliance_ = kernelAtOrigin(stiffnessTransform_, stiffnessGrid_.nx, stiffnessGrid_.ny);
    largestCompliance_ = *std::max_element(stiffnessTransform_.begin(), stiffnessTransform_.end());
    for (double& factor : stiffnessTransform_) factor = factor > 0.0 ? 1.0 / factor : 0.0;
    ownStiffness_ = kernelAtOrigin(stiffnessTransform_, stiffnessGrid_.nx, stiffnessGrid_.ny);
}

std::vector<double> HalfSpace::freeTransform(const std::function<bool()>& goOn) const
{
    const int mx = stiffnessGrid_.nx;
    const int my = stiffnessGrid_.ny;
    const auto width = static_cast<std::size_t>(mx / 2 + 1);
    std::vector<long double> below(width + 1, 0.0L); // corners on the lower side of a row of cells, the first mirrored
    std::vector<long double> above(width + 1, 0.0L);
    const auto setCorners = [&](std::vector<long double>& row, int j) {
        for (std::size_t i = 0; i < width; ++i)
            row[i + 1] = corner((static_cast<long double>(i) + 0.5L) * grid_.dx, (j + 0.5L) * grid_.dy);
        row[0] = -row[1];
    };
    std::vector<double> kernel;
    kernel.reserve(width * static_cast<std::size_t>(my / 2 + 1));
    setCorners(below, -1);
    for (int j = 0; j <= my / 2; ++j) {
        if (goOn && !goOn()) return std::vector<double>(width * static_cast<std::size_t>(my / 2 + 1), 0.0);
        setCorners(above, j);
        for (std::size_t i = 0; i < width; ++i)
            kernel.push_back(static_cast<double>((above[i + 1] - above[i]) - (below[i + 1] - below[i])) /
                             (std::numbers::pi * modulus_));
        below.swap(above);
    }
    PlaneConvolution::transformKernel(kernel, mx, my);
    return kernel;
}

std::vector<double> HalfSpace::periodicTransform() const
{
    std::vector<double> transform;
    for (int j = 0; j <= grid_.ny / 2; ++j)
        for (int i = 0; i <= grid_.nx / 2; ++i) {
            const double k = 2.0 * std::numbers::pi * std::hypot(i / (grid_.nx * grid_.dx), j / (grid_.ny * grid_.dy));
            transform.push_back(k > 0.0 ? 2.0 / (modulus_ * k) : 0.0);
        }
    return transform;
}

void HalfSpace::stress(std::span<const double> displacement, std::span<double> pressure)
{
    if (!stiffness_) {
        stiffness_.emplace(stiffnessGrid_.nx, stiffnessGrid_.ny, stiffnessGrid_.nx, stiffnessGrid_.ny);
        stiffness_->setTransform(stiffnessTransform_);
        stiffnessTransform_ = {};
    }
    stiffness_->apply(displacement, pressure);
}

} // namespace touchdown
