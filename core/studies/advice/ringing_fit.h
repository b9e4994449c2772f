// SPDX-License-Identifier: GPL-3.0-or-later
//
// A signal as a constant and motions that ring: x(t) = c + Re sum_k A_k e^(s_k t), fitted to samples at equal intervals
// by least squares. The rates s_k are known about; those that may change are improved by Gauss & Newton's method, with
// t e^(s_k t) beside e^(s_k t), as what a small change of s_k makes.
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace touchdown {

struct RingingRate {
    std::complex<double> rate; // s [1/s]; real: it creeps
    bool fixed = false;        // as that of a wave
};

struct RingingFit {
    double constant = 0.0;
    std::vector<std::complex<double>> rates, amplitudes; // at the first sample
    double left = 0.0;                                   // root mean square of what the fit leaves [unit of the signal]

    double at(double time) const; // since the first sample [s]
};

/// None where the samples are too few or too short for these rates.
std::optional<RingingFit> fitRinging(std::span<const double> samples, double interval,
                                     const std::vector<RingingRate>& rates);

} // namespace touchdown
