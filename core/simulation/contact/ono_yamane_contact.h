// SPDX-License-Identifier: GPL-3.0-or-later
//
// The characteristic of Ono & Yamane under a flying slider: d is the minimum spacing above the disk's mean plane, and
// the force acts there (Chen & Bogy, section 4).
//
// Along a trailing edge without roll the nearest point jumps from corner to corner with the slightest roll, and the
// torque with it. The force therefore acts at the weighted mean of all points within a hundredth of a nanometre of the
// nearest: our choice. It moves the force by no more than the width of the pad.
//
// The accepted region's law also applies beyond the ends of its interval, so that a step has a smooth force; the caller
// ends the step at the switch.
#pragma once

#include <optional>

#include "core/physics/contact/ono_yamane.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/slider_contact.h"

namespace touchdown {

class OnoYamaneContact final : public SliderContact {
public:
    /// The spacing must last. The first region is that of `initial.branch` at the attitude that is accepted first.
    OnoYamaneContact(const Case& c, const MinimumSpacing& spacing);

    const SliderContactForces& at(const Attitude& attitude, double time) override;
    Matrix3 stiffness() const override;
    bool outOfReach(const Attitude& attitude) const override;
    void accept() override { begun_ = true; }

    double separation(const Attitude& attitude) const override { return spacing_.at(attitude).spacing; }
    Interval interval() const override { return interval_; }
    std::string cross(bool upper) override;

    /// The region whose law acts; regions with the same law are one.
    ContactRegion region() const { return region_; }
    /// This region's law acts from now on until it is crossed. The lowest region with the same law is taken.
    void setRegion(ContactRegion region);

private:
    bool sameLaw(ContactRegion a, ContactRegion b) const;
    ContactRegion lastOfLaw(bool upper) const;
    void setInterval();
    Vector3 loadAt(const Attitude& attitude, SliderContactForces& forces) const;

    OnoYamaneLaw law_;
    ContactLever lever_;
    const MinimumSpacing& spacing_;
    double length_, width_; // of the slider [m]
    double takeOff_;        // d_e [m]
    ContactBranch first_;
    ContactRegion region_ = ContactRegion::Apart;
    Interval interval_; // in which its law holds [m]
    bool begun_ = false;
    Attitude attitude_; // of the last call
    SliderContactForces forces_;
    mutable std::optional<Matrix3> stiffness_; // at attitude_, once it was asked for
};

} // namespace touchdown
