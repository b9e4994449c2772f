// SPDX-License-Identifier: GPL-3.0-or-later
//
// Laws of contact that are a pressure of the local gap g between the mean planes of slider and disk, both rigid there:
// the summits of a statistical surface (asperity_contact.h), and the attraction of the surfaces (adhesion.h) beside
// them. The pressures add.
#pragma once

#include <optional>

#include "core/physics/contact/adhesion.h"
#include "core/physics/contact/asperity_contact.h"

namespace touchdown {

/// Per area of the nominal surface.
struct GapForces {
    double contact = 0.0;                               // >= 0, away from the disk [Pa]
    double adhesion = 0.0;                              // mostly <= 0 [Pa]
    double contactSlope = 0.0;                          // d(contact)/dg [Pa/m]
    double adhesionSlope = 0.0;                         // d(adhesion)/dg [Pa/m]
    double area = 0.0;                                  // real area of contact [-]
    double energy = 0.0;                                // of both, zero far away [J/m^2]
    double total() const { return contact + adhesion; } // [Pa]
};

class GapLaw {
public:
    /// As AsperityContact and AdhesionLaw; without attraction where that does not act.
    GapLaw(const Asperities& asperities, const ElasticPair& pair, const Adhesion& adhesion = {});

    GapForces at(double gap) const;
    /// The pressures alone.
    GapForces pressures(double gap) const;
    /// Nothing acts from this gap on [m]; of an attraction, less than 1e-10 of its largest value.
    double reach() const { return reach_; }
    /// Over which the pressures change near a gap [m].
    double scale(double gap) const;

private:
    AsperityContact asperities_;
    std::optional<AdhesionLaw> adhesion_;
    double deviation_; // sigma_s [m]
    double width_;     // of the attraction at no gap [m]
    double reach_;     // [m]
};

} // namespace touchdown
