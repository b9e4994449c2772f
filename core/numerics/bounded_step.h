// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step of damped least squares between bounds (Levenberg 1944, Marquardt 1963): du minimises
//
//   |r + J du|^2 + lambda sum_k (J^T J)_kk du_k^2
//
// A parameter that would leave its bounds is held on the bound, and the others are found again without it.
#pragma once

#include <span>
#include <vector>

namespace touchdown {

/// `slopes` is J column by column, each as long as `residual`; low[k] <= 0 <= high[k] bound du_k. lambda > 0.
std::vector<double> boundedStep(const std::vector<std::vector<double>>& slopes, std::span<const double> residual,
                                double lambda, std::span<const double> low, std::span<const double> high);

} // namespace touchdown
