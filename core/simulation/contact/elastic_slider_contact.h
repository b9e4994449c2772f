// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact and adhesion between the disk and those parts of a flying slider that can touch it: patches, known
// before the run, of all that lies within elastic.patch_reach of the lowest point at elastic.patch_pitch and no roll.
// Only patches in reach are solved: beyond the disk's highest point, or where adhesion could pull all of the patch by
// no more than 1e-5 of the preload.
#pragma once

#include <vector>

#include "core/numerics/padded_grid.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/elastic_patch.h"
#include "core/simulation/contact/slider_contact.h"
#include "core/work/state_stream.h"

namespace touchdown {

class ElasticSliderContact final : public SliderContact {
public:
    /// Spacing, surface and pad must last. Invalid where `goOn` returns false.
    ElasticSliderContact(const Case& c, const MinimumSpacing& spacing, const DiskTopography& surface,
                         const CellGrid& grid, const PaddedGrid& pad, const std::function<bool()>& goOn);

    const SliderContactForces& at(const Attitude& attitude, double time) override;
    Matrix3 stiffness() const override { return stiffness_; }
    bool outOfReach(const Attitude& attitude) const override;
    double reach() const override;
    void accept() override;
    void begin(ContactBranch branch, const Attitude& attitude) override;

    double longestStep() const override { return longestStep_; }
    bool deforms() const override { return true; }
    bool deform(std::span<double> height) const override;
    void clearTouching(std::span<double> field) const override;
    void observe(FieldSnapshot& snapshot) const override;
    Doubts doubts(const std::function<bool()>& goOn) override;
    std::vector<std::string> remarks() const override;
    std::string problemAt(const Attitude& attitude) const override;
    void pass(StateStream& stream) override
    {
        stream.fixed(parts_);
        stream(last_, hardest_);
    }

private:
    struct Part {
        ElasticPatch patch;
        double reach;      // clearance beyond which nothing acts [m]
        bool near = false; // at the last call
        void pass(StateStream& stream) { stream(patch, near); }
    };

    Case case_;
    const MinimumSpacing& spacing_;
    const DiskTopography& surface_;
    const PaddedGrid& pad_;
    double highest_;     // of the disk [m]
    double longestStep_; // [s]
    ContactLever lever_;
    std::vector<Part> parts_;
    SliderContactForces forces_;
    /// When and where the contact force was largest.
    struct Moment {
        Attitude attitude;
        double time = 0.0;    // [s]
        double contact = 0.0; // [N]
    };
    Moment last_, hardest_; // of at(), of the accepted ones
    Matrix3 stiffness_ = Matrix3::Zero();
};

} // namespace touchdown
