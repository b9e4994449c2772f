// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frequency and damping of a motion that has been sampled.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace touchdown::test {

/// Samples that are sums of c z^n: the z that goes round at least once in them and has the largest part. Each sample
/// with the `delays` that follow is a vector, and one matrix leads from each to the next (Hua & Sarkar 1990, matrix
/// pencil). What is smaller than `noise` against the largest is rounding.
std::complex<double> leadingFactor(const std::vector<Eigen::Vector3d>& samples, Eigen::Index delays,
                                   double noise = 1e-7);

} // namespace touchdown::test
