// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air around the slider: given, or from altitude and temperature.
//
//   mu = 1.458e-6 T^1.5 / (T + 110.4)                       Sutherland
//   lambda = R T / (sqrt(2) pi d^2 N_A p), d = 3.65e-10 m   hard spheres, R per mole
//   p = 101325 (1 - 0.0065 z / 288.16)^5.256                standard atmosphere, z in metres, up to z1 = 11000
//   p = p(z1) exp(-(z - z1)/6341.62)                        above it, at 216.65 K (U.S. Standard Atmosphere, 1976)
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchdown {

struct Air {
    double pressure = 101325.0;    // p0 [Pa]
    double viscosity = 1.806e-5;   // mu [Pa s]
    double meanFreePath = 63.5e-9; // lambda at p0 [m]
    bool operator==(const Air&) const = default;
};

/// What the established static program calls standard air (25 C), whatever its input file says.
inline constexpr Air establishedStandardAir{101325.0, 1.8372e-5, 68.6e-9};

/// Altitude [m], -1000 to 20000; temperature [K], above 0.
inline Air airAt(double altitude, double temperature)
{
    constexpr double gasConstant = 8.31446261815324; // [J/(mol K)]
    constexpr double avogadro = 6.02214076e23;       // [1/mol]
    constexpr double moleculeDiameter = 3.65e-10;    // d [m]
    const double t = temperature;
    constexpr double tropopause = 11000.0, scaleHeight = 6341.62; // [m]
    const double p = 101325.0 * std::pow(1.0 - 0.0065 * std::min(altitude, tropopause) / 288.16, 5.256) *
                     std::exp(-std::max(altitude - tropopause, 0.0) / scaleHeight);
    const double area = std::numbers::sqrt2 * std::numbers::pi * moleculeDiameter * moleculeDiameter;
    return {p, 1.458e-6 * t * std::sqrt(t) / (t + 110.4), gasConstant * t / (area * avogadro * p)};
}

} // namespace touchdown
