// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/air.h"

#include <cmath>
#include <numbers>

namespace touchdown {

Air airAt(double altitude, double temperature)
{
    constexpr double gasConstant = 8.31446261815324; // [J/(mol K)]
    constexpr double avogadro = 6.02214076e23;       // [1/mol]
    constexpr double moleculeDiameter = 3.65e-10;    // d [m]
    const double t = temperature;
    const double p = 101325.0 * std::pow(1.0 - 0.0065 * altitude / 288.16, 5.256);
    const double area = std::numbers::sqrt2 * std::numbers::pi * moleculeDiameter * moleculeDiameter;
    return {p, 1.458e-6 * t * std::sqrt(t) / (t + 110.4), gasConstant * t / (area * avogadro * p)};
}

} // namespace touchdown
