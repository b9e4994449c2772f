// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part of the slider's surface that can touch the disk, as an elastic half-space of its own, with adhesion where
// there is one. The surfaces' separation at a cell's centre, the slider at any attitude and the disk's surface w moved
// for a time t, is
//
//   s = height + pitch (L - x) - roll (y - W/2) + recess - w(x - U t, y - V t)
//
// Each step is solved to 1e4 elastic.tolerance: by default to 1e-4 of the largest pressure and displacement. The error
// of the force is some 1e-5, and contacts snap in and pull off in the same steps as with a tight tolerance.
//
// The margin around the cells that can touch, a recess, is not part of the solution. The disk is displaced there, too,
// which the film beside a pad's edge sees.
//
// A solution with adhesion depends on its start: the last accepted state, or the last try where that was at the same
// time within a picometre.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/numerics/padded_grid.h"
#include "core/physics/contact/adhesive_contact.h"
#include "core/physics/contact/contact_patch.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/slider/attitude.h"
#include "core/simulation/contact/contact_doubts.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/recording/field_snapshot.h"

namespace touchdown {

/// Forces of a patch on the slider: (force, pitch torque, roll torque) about the mass centre [N], [N m].
struct PatchForces {
    Vector3 contact = Vector3::Zero(), adhesion = Vector3::Zero();
    double area = 0.0;                   // of contact [m^2]
    double peakPressure = 0.0;           // of contact [Pa]
    double storedEnergy = 0.0;           // of the half-space and of the attraction [J]
    Matrix3 stiffness = Matrix3::Zero(); // roughly
    int iterations = 0;
    std::string problem;
};

class SliderPatch {
public:
    /// The surface must last.
    SliderPatch(const Case& c, ContactPatch patch, const DiskTopography& surface, Velocity velocity,
                const std::function<bool()>& goOn);

    /// The least height of its cells over the disk's mean plane [m].
    double clearance(const Attitude& attitude) const;

    const PatchForces& solve(const Attitude& attitude, double time);
    /// Nothing acts on it at that attitude: no solution.
    void part(const Attitude& attitude, double time);
    void accept();

    /// Adds the errors of the last solution that come from its cells and its border.
    void addDoubts(ContactDoubts& doubts, const std::function<bool()>& goOn) const;

    /// Prepares deform() for the cells of a film.
    void overlap(const CellGrid& grid);
    /// Takes the mean displacement of the disk in each cell off `height` (padded) [m].
    void deform(const PaddedGrid& pad, std::span<double> height) const;
    /// Sets `field` (padded) to zero in the cells where the surfaces touch.
    void clearTouching(const PaddedGrid& pad, std::span<double> field) const;
    void observe(FieldSnapshot& snapshot) const;

    const UniformGrid& grid() const { return whole_.grid; }

private:
    /// The share of one of the film's columns or rows that one of the patch's takes.
    struct Overlap {
        int film, patch;
        double share; // [-]
    };
    static std::vector<Overlap> overlaps(std::span<const double> lines, double first, double cell, int count);
    template <typename Visit>
    void forHeights(const Attitude& attitude, const Visit& visit) const;
    void setSeparation(const Attitude& attitude, double time);
    void separationOn(const UniformGrid& grid, std::span<double> separation) const;
    ContactGridError adhesiveError(const std::function<bool()>& goOn) const;
    void setDisplacement();
    void sum();
    /// Calls visit(cell of the whole patch, solved cell) for each solved one.
    template <typename Visit>
    void forSolved(const Visit& visit) const;

    ContactPatch whole_; // with the margin
    UniformGrid grid_;
    std::size_t first_;          // of its cells, on the whole patch
    std::vector<double> recess_; // [m]
    double length_, width_;      // of the slider [m]
    double modulus_;             // E* [Pa]
    Adhesion adhesion_;
    AdhesiveContactOptions options_;
    const DiskTopography& topography_;
    Velocity velocity_; // of the surface [m/s]
    ContactLever lever_;
    AdhesiveContact contact_;
    HalfSpace space_;                  // of the whole patch
    std::vector<double> displacement_; // of the disk, on the whole patch [m]
    std::vector<double> surface_;      // w [m]; empty: flat
    std::vector<double> separation_;   // s [m]
    double surfaceTime_;               // of surface_ [s]
    Attitude attitude_;                // of the last call
    double time_ = 0.0;                // of the last call [s]
    bool acts_ = false;                // whether the last call solved
    bool tried_ = false;               // solved since it was accepted, and converged
    bool remembers_ = false;           // the accepted state acts
    PatchForces forces_;
    std::vector<Overlap> columns_, rows_;
};

} // namespace touchdown
