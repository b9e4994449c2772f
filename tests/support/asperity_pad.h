// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pad on dense, low asperities, for the tests of the multi-asperity model.
#pragma once

#include <numbers>

#include "core/physics/contact/multi_asperity.h"

namespace touchdown::test {

struct AsperityPad {
    Asperities asperities{.radius = 1e-6, .density = 8.5e12, .heightDeviation = 0.2e-9, .planeHeight = 2e-9};
    Meniscus meniscus{.surfaceTension = 0.025, .contactAngle = 0.0, .filmThickness = 0.5e-9, .breakingLength = 1.5e-9};
    ElasticPair pair;
    double area = 3.6e-9; // [m^2]

    MultiAsperity model() const { return {asperities, meniscus, pair, area}; }
    /// With every summit wetted [N].
    double adhesion() const
    {
        return asperities.density * area * 4.0 * std::numbers::pi * asperities.radius * meniscus.surfaceTension;
    }
};

/// A pad so small against its summits' stiffness that the bulk does not give way: k_b grows with sqrt(A), the forces
/// with A.
inline AsperityPad stiffBulk()
{
    AsperityPad s;
    s.area = 1e-24;
    return s;
}

} // namespace touchdown::test
