// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part of a pad's or slider's surface that can touch the disk, as an elastic half-space of its own, with adhesion
// where there is one. The surfaces' separation at a cell's centre, at any attitude and with the disk's surface w moved
// for a time t, is
//
//   s = height + pitch (L - x) - roll (y - W/2) + recess - w(x - U t, y - V t)
//
// A pad of the model "contact" is level: its lowest point is at `height`, and the recess is its own height above it.
//
// Under a film each step is solved to 1e4 elastic.tolerance: by default to 1e-4 of the largest pressure and
// displacement. The error of the force is some 1e-5, and contacts snap in and pull off in the same steps as with a
// tight tolerance.
//
// The margin around the cells that can touch under a film, a recess, is not part of the solution. The disk is displaced
// there, too, which the film beside a pad's edge sees.
//
// A solution with adhesion depends on its start.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/numerics/padded_grid.h"
#include "core/physics/contact/adhesive_contact.h"
#include "core/physics/contact/contact_grid_error.h"
#include "core/physics/contact/contact_patch.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/slider/attitude.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/recording/field_snapshot.h"

namespace touchdown {

/// What observe() fills, over the first of the patches; empty without one.
RecordedFields elasticFields(const Case& c, const SliderPatches& patches);

/// Forces of a patch: (force, pitch torque, roll torque) about the slider's mass centre [N], [N m].
struct PatchForces {
    Vector3 contact = Vector3::Zero(), adhesion = Vector3::Zero();
    double area = 0.0;                   // of contact [m^2]
    double peakPressure = 0.0;           // of contact [Pa]
    double minimumGap = 0.0;             // of the deformed surfaces [m]
    double storedEnergy = 0.0;           // of the half-space and of the attraction [J]
    Matrix3 stiffness = Matrix3::Zero(); // roughly
    int iterations = 0;
    bool jumped = false; // with adhesion: the solution may have jumped from the one before
    std::string problem;
};

class ElasticPatch {
public:
    /// The surface must last.
    ElasticPatch(const Case& c, ContactPatch patch, const DiskTopography& surface, const std::function<bool()>& goOn);

    /// The least height of its cells over the disk's mean plane [m].
    double clearance(const Attitude& attitude) const;

    /// From the last solution.
    const PatchForces& solve(const Attitude& attitude, double time);
    /// Stores the last solution in one of two places; returns to it.
    void remember(std::size_t place) { contact_.remember(place); }
    void recall(std::size_t place) { contact_.recall(place); }

    /// From the last accepted state, or from the last try where that was at the same time within a picometre.
    const PatchForces& tryAt(const Attitude& attitude, double time);
    /// Nothing acts on it at that attitude: no solution.
    void part(const Attitude& attitude, double time);
    void accept();
    /// All that the next solution depends on, written or read.
    void pass(auto& stream) { stream(contact_, attitude_, time_, acts_, tried_, remembers_); }

    /// The error of the last solution's grid, and whether the patch's border cuts its contact off.
    ContactGridError gridError(const std::function<bool()>& goOn) const;
    bool isCutOff() const;
    /// The most that attracts beyond the patch, where it is a part of a sphere of this radius [m] [N].
    double attractionAround(double radius) const;

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
    SeparationOn separation() const;
    ContactState state() const;
    ContactGridError adhesiveError(const std::function<bool()>& goOn) const;
    void setDisplacement();
    void sum();
    /// Calls visit(cell of the whole patch, solved cell) for each solved one.
    template <typename Visit>
    void forSolved(const Visit& visit) const;

    ContactPatch whole_;    // with the margin
    ContactPatch solved_;   // without
    std::size_t first_;     // of its cells, on the whole patch
    double length_, width_; // of the slider [m]
    double modulus_;        // E* [Pa]
    HalfSpaceEdges edges_;
    Adhesion adhesion_;
    ElasticContactOptions options_;
    const DiskTopography& topography_;
    Velocity velocity_; // of the surface [m/s]
    ContactLever lever_;
    AdhesiveContact contact_;
    std::optional<HalfSpace> space_;   // of the whole patch, where it has a margin
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
