// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contact at the pad of the spring model, by the separation d of pad and disk. A law has at most the four regions
// of ContactRegion. Within one its forces are smooth; a step of an integrator ends where d leaves the region's
// interval. A law without switches is Apart everywhere.
#pragma once

#include <memory>

#include "core/numerics/interval.h"
#include "core/physics/contact/ono_yamane.h"

namespace touchdown {

class SeparationLaw;
struct Case;

/// On the whole pad.
struct PadForces {
    double contact = 0.0;                             // >= 0, away from the disk [N]
    double adhesion = 0.0;                            // mostly <= 0 [N]
    double contactSlope = 0.0, adhesionSlope = 0.0;   // by d [N/m]
    double area = 0.0;                                // real area of contact [m^2]; zero where the law has none
    double energy = 0.0;                              // stored, zero far away [J]
    double net() const { return contact + adhesion; } // [N]
    double slope() const { return contactSlope + adhesionSlope; } // [N/m]
};

/// The base class is the law without contact.
class PadLaw {
public:
    virtual ~PadLaw() = default;

    virtual PadForces at(ContactRegion /*region*/, double /*d*/) const { return {}; }
    /// Contact and adhesion alone.
    virtual PadForces forces(ContactRegion region, double d) const { return at(region, d); }
    /// Whether the forces are straight lines within each region.
    virtual bool affine() const { return true; }
    /// Of contact and adhesion on the pad, on its way within a region [J].
    virtual double work(ContactRegion region, double from, double to) const;

    virtual Interval interval(ContactRegion /*region*/) const { return {}; }
    /// The region beyond the lower (upper) end of the interval.
    virtual ContactRegion beyond(ContactRegion region, bool /*upper*/) const { return region; }
    /// The region of d on a branch.
    virtual ContactRegion region(ContactBranch /*branch*/, double /*d*/) const { return ContactRegion::Apart; }
    /// The branch at d after `previous`.
    virtual ContactBranch nextBranch(ContactBranch previous, double /*d*/) const { return previous; }

    /// In contact, as large as a run meets [N/m].
    virtual double stiffness() const;
};

/// The law that the case names.
std::unique_ptr<const PadLaw> makePadLaw(const Case& c);
/// A law that remembers no more than its branch, on the way in and on the way out of a contact. They are the regions
/// Apart and Pressed.
std::unique_ptr<const PadLaw> makePadLaw(std::unique_ptr<SeparationLaw> in, std::unique_ptr<SeparationLaw> out);

} // namespace touchdown
