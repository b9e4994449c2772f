// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pad and a disk whose surfaces are given point by point, on patches of an elastic half-space, with adhesion where
// there is one.
#pragma once

#include <span>

#include "core/physics/disk/disk_topography.h"
#include "core/simulation/contact/contact_model.h"
#include "core/simulation/contact/elastic_patch.h"

namespace touchdown {

/// What was assumed or left out for these patches on this surface, in sentences.
std::vector<std::string> elasticRemarks(const Case& c, std::span<const UniformGrid> patches,
                                        const DiskTopography& surface);
/// Whether a measured surface has features below a cell of that grid, of which the contact does not know.
bool losesFeatures(const Case& c, const DiskTopography& surface, const UniformGrid& grid);

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
    void pass(StateStream& stream) override
    {
        stream.fixed(patches_);
        stream(forces_, jumped_);
    }
    void observe(FieldSnapshot& snapshot) const override;
    ContactDoubts doubts(const std::function<bool()>& goOn) const override;
    std::vector<std::string> remarks() const override;
    std::optional<SurfaceStatistics> surfaceStatistics() const override;

private:
    Case case_;
    DiskTopography topography_;
    std::vector<ElasticPatch> patches_;
    ContactForces forces_;
    bool jumped_ = false;
};

} // namespace touchdown
