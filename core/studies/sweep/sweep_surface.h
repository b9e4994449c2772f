// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples that are not solved one by one: a surface of second order through a few exact items gives their readings.
//
//   y(x) = y0 + sum_i (a_i d_i + b_i d_i^2) + sum_i<j c_ij d_i d_j,   d = x - x0
//
// It passes through the middle x0, through a point on each side of it along each axis (1.5 standard deviations, or the
// ends of the axis), and through the upper corner of each pair of axes: 1 + 2 n + n (n - 1)/2 items for n axes. More
// items, drawn at random, tell how far it is off.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/studies/sweep/sweep_axis.h"

namespace touchdown {

/// Items that check the surface, the last ones of the design.
inline constexpr std::size_t surfaceChecks = 10;
/// Of the design without checks.
constexpr std::size_t surfaceItems(std::size_t axes) { return 1 + 2 * axes + axes * (axes - 1) / 2; }

/// The numbers of all exact items, by axis [units of the axes].
std::vector<std::vector<double>> surfaceDesign(const std::vector<SweepAxis>& axes, int seed);

class ResponseSurface {
public:
    /// A value at each item of the design but the checks.
    ResponseSurface(const std::vector<std::vector<double>>& design, std::span<const double> values);
    double at(std::span<const double> x) const;

private:
    std::vector<double> middle_;
    double there_ = 0.0;               // y0
    std::vector<double> slope_, bend_; // a, b
    std::vector<double> mixed_;        // c of each pair, the first axis runs last
};

} // namespace touchdown
