// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pad and a disk whose surfaces are given point by point: s = d + pad height - w, w the disk's surface, on patches of
// an elastic half-space, with adhesion where there is one.
#pragma once

#include <span>

#include "core/physics/contact/adhesive_contact.h"
#include "core/physics/contact/contact_patch.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/simulation/contact/contact_model.h"

namespace touchdown {

/// What was assumed or left out for these patches on this surface, in sentences.
std::vector<std::string> elasticRemarks(const Case& c, std::span<const UniformGrid> patches,
                                        const DiskTopography& surface);
/// Whether a measured surface has features below a cell of that grid, of which the contact does not know.
bool losesFeatures(const Case& c, const DiskTopography& surface, const UniformGrid& grid);
/// Fields of the first patch; empty without one.
RecordedFields elasticFields(const Case& c, const SliderPatches& patches);

class ElasticPad final : public ContactModel {
public:
    explicit ElasticPad(const Case& c, const std::function<bool()>& goOn = {}, bool coarser = false);

    /// Number of cells of all patches.
    std::size_t cells() const;

    const ContactForces& move(double separation, double time) override;
    bool canJump() const override { return case_.adhesion.acts(); }
    bool mayHaveJumped() const override { return jumped_; }
    void remember(std::size_t place = 0) override;
    void recall(std::size_t place = 0) override;
    void observe(FieldSnapshot& snapshot) const override;
    ContactDoubts doubts(const std::function<bool()>& goOn) const override;
    std::vector<std::string> remarks() const override;
    std::optional<SurfaceStatistics> surfaceStatistics() const override;

    static RecordedFields fields(const Case& c);

private:
    /// One patch and all that is solved on it.
    struct Part {
        ContactPatch patch;
        AdhesiveContact contact;
        std::vector<double> surface;    // w [m]; empty: flat
        std::vector<double> separation; // s [m]
        double surfaceTime = -1.0;      // of `surface` [s]
    };
    void solve(Part& part, double separation, double time);
    double adhesionBeyond(const Part& part) const;

    Case case_;
    DiskTopography topography_;
    Velocity velocity_; // of the surface under the pad [m/s]
    double modulus_;    // E* [Pa]
    std::vector<Part> parts_;
    ContactForces forces_;
    double time_ = 0.0; // of the last move [s]
    bool jumped_ = false;
};

} // namespace touchdown
