// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bodies in contact: their elasticity, the asperities of the disk and the liquid that forms menisci on them.
#pragma once

#include <cstdint>

namespace touchdown {

/// Two elastic bodies, as one half-space against a rigid pad (Johnson 1985, section 4.2): 1/E* = (1 - nu_1^2)/E_1 + (1
/// - nu_2^2)/E_2. The defaults are assumed: carbon overcoats on a glass disk and on a ceramic slider.
struct ElasticPair {
    double diskModulus = 100e9;       // [Pa]
    double diskPoissonRatio = 0.25;   // [-]
    double sliderModulus = 390e9;     // [Pa]
    double sliderPoissonRatio = 0.24; // [-]
    bool operator==(const ElasticPair&) const = default;
};

/// E* [Pa].
inline double contactModulus(const ElasticPair& pair)
{
    const auto compliance = [](double modulus, double poisson) { return (1.0 - poisson * poisson) / modulus; };
    return 1.0 / (compliance(pair.diskModulus, pair.diskPoissonRatio) +
                  compliance(pair.sliderModulus, pair.sliderPoissonRatio));
}

enum class AsperityModel : std::uint8_t; // core/physics/contact/asperity_model.h

/// The statistical rough surface of Greenwood & Williamson (1966): summits of one radius and Gaussian heights, against
/// a smooth pad. Radius, density, heights and lubricant are assumed: with a pad of 62 x 62 um they give about the
/// paper's five values (core/physics/contact/characteristic_fit.h).
struct Asperities {
    AsperityModel model{};           // the first: greenwood-williamson
    double radius = 1e-6;            // R of the summits [m]
    double density = 8.5e12;         // eta [1/m^2]
    double heightDeviation = 0.2e-9; // sigma_s of the summits' heights [m]
    double planeHeight = 2.1e-9;     // y_s of the summits' mean plane above the disk's mean plane [m]
    double yieldStrength = 2e9;      // Y [Pa], elastic-plastic
    double friction = 0.3;           // mu [-]
    bool operator==(const Asperities&) const = default;
};

/// Of each wetted asperity: 2 pi R gamma (1 + cos theta) while the liquid bridge stands.
struct Meniscus {
    double surfaceTension = 0.025;  // gamma of the lubricant [N/m]
    double contactAngle = 0.0;      // theta [rad]
    double filmThickness = 0.5e-9;  // mobile lubricant: a meniscus forms when a summit comes this near [m]
    double breakingLength = 1.5e-9; // it breaks when the summit's gap exceeds this [m], >= filmThickness
    bool operator==(const Meniscus&) const = default;
};

} // namespace touchdown
