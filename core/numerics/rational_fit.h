// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rational functions with common poles through values at complex s: vector fitting (Gustavsen & Semlyen 1999), relaxed
// (Gustavsen 2006), with one QR per function (Deschrijver et al. 2008):
//
//   f_e(s) ~ d_e + sum_k r_ke/(s - p_k)
//
// The functions are real in time: f(s*) = f(s)*, so that poles are real or in conjugate pairs.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace touchdown {

struct RationalFit {
    /// Decaying, Re p < 0 [1/s]. A pair counts once, with Im p > 0; its conjugate is understood.
    std::vector<std::complex<double>> poles;
    std::vector<std::vector<std::complex<double>>> residues; // r_ke, by pole, then by function
    std::vector<double> constants;                           // d_e

    std::complex<double> at(std::complex<double> s, std::size_t function) const;
};

struct RationalSample {
    std::complex<double> s;                   // Im s > 0, or s >= 0 [1/s]
    std::vector<std::complex<double>> values; // by function
    std::vector<double> weights;              // of their errors; zero leaves one out
};

/// `order`: number of poles, pairs counted twice; even, at most twice the number of samples less two. The poles start
/// in pairs between the slowest sample that is not at zero and the fastest one. Throws std::invalid_argument where the
/// samples are too few.
RationalFit fitRationally(std::span<const RationalSample> samples, int order, int iterations = 12);

/// With these poles, and without a constant where `constant` is false.
RationalFit fitResidues(std::span<const RationalSample> samples, std::span<const std::complex<double>> poles,
                        bool constant);

} // namespace touchdown
