// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adhesive pressure between two smooth surfaces at the gap g, local (each point sees the gap above it). Pressure is
// positive when it pushes the surfaces apart, so attraction is negative.
//
//   lennard-jones   p = -(8 dgamma/(3 z0)) [s^3 - s^9], s = z0/(g + z0), g >= 0: zero at g = 0, where elastic contact alone
//                   repels. A reading of the improved intermolecular model that Chen & Bogy name as their reference [8],
//                   whose equations were not available. Its integral over g from 0 is -dgamma.
//   van-der-waals   p = -A/(6 pi g^3) + B/(45 pi g^9), with a repulsion of its own
//   electrostatic   p = -eps0 V^2/(2 (g + z0)^2), added to either or alone
#pragma once

#include <cstdint>

namespace touchdown {

enum class AdhesionKind : std::uint8_t { None, LennardJones, VanDerWaals };

struct Adhesion {
    AdhesionKind kind = AdhesionKind::None;
    double surfaceEnergy = 0.05;          // dgamma [N/m], work of adhesion; the lubricant enters through it
    double equilibriumDistance = 0.3e-9;  // z0 [m], 0.2..0.4 nm
    double hamakerA = 1e-19;              // A [J]
    double hamakerB = 1e-76;              // B [J m^6]
    double voltage = 0.0;                 // V [V] between slider and disk

    bool acts() const { return kind != AdhesionKind::None || voltage != 0.0; }
};

} // namespace touchdown
