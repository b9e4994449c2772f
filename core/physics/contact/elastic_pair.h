// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two elastic bodies in contact, as one half-space against a rigid pad (Johnson 1985, section 4.2):
// 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
#pragma once

namespace touchdown {

/// The defaults are assumed: carbon overcoats on a glass disk and on a ceramic slider.
struct ElasticPair {
    double diskModulus = 100e9;       // [Pa]
    double diskPoissonRatio = 0.25;   // [-]
    double sliderModulus = 390e9;     // [Pa]
    double sliderPoissonRatio = 0.24; // [-]
};

/// E* [Pa].
inline double contactModulus(const ElasticPair& pair)
{
    const auto compliance = [](double modulus, double poisson) { return (1.0 - poisson * poisson) / modulus; };
    return 1.0 / (compliance(pair.diskModulus, pair.diskPoissonRatio) +
                  compliance(pair.sliderModulus, pair.sliderPoissonRatio));
}

} // namespace touchdown
