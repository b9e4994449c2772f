// SPDX-License-Identifier: GPL-3.0-or-later
//
// A law of the separation under a flying slider: d is the minimum spacing above the disk's mean plane, and the force
// acts there (Chen & Bogy, section 4).
//
// Along a trailing edge without roll the nearest point jumps from corner to corner with the slightest roll, and the
// torque with it. The force therefore acts at the weighted mean of all points within a hundredth of a nanometre of the
// nearest: our choice. It moves the force by no more than the width of the pad.
#pragma once

#include <memory>
#include <optional>

#include "core/physics/contact/separation_law.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/slider_contact.h"

namespace touchdown {

/// The law of the separation that a case names; null where its contact is another.
std::unique_ptr<SeparationLaw> makeSeparationLaw(const Case& c);
/// The same for a pressure of the gap.
std::optional<GapLaw> gapLawOf(const Case& c);
/// Many asperities on the pad of a case.
MultiAsperity manyAsperities(const Case& c);

/// Points so near to the nearest one's height bear with it [m].
inline constexpr double bearingDepth = 1e-11;

class PadContact final : public SliderContact {
public:
    /// The spacing must last. The law begins on `initial.branch` at the attitude that is accepted first.
    PadContact(const Case& c, std::unique_ptr<SeparationLaw> law, const MinimumSpacing& spacing);

    const SliderContactForces& at(const Attitude& attitude, double time) override;
    Matrix3 stiffness() const override;
    bool outOfReach(const Attitude& attitude) const override;
    double reach() const override { return law_->reach(); }
    void accept() override;
    void begin(ContactBranch branch, const Attitude& attitude) override;

    double separation(const Attitude& attitude) const override { return near_.at(attitude); }
    Interval interval() const override { return law_->interval(); }
    std::string cross(bool upper) override;
    void moveLittle(double margin) override;
    void pass(StateStream& stream) override { stream(*law_, begun_, attitude_, near_); }

    /// Where the law is Ono and Yamane's; else null.
    CharacteristicLaw* characteristic() { return dynamic_cast<CharacteristicLaw*>(law_.get()); }
    const CharacteristicLaw* characteristic() const { return dynamic_cast<const CharacteristicLaw*>(law_.get()); }

private:
    /// Where the pad bears at attitude_.
    const MinimumSpacing::Place& place() const;
    Vector3 loadAt(const MinimumSpacing::Place& place, const SeparationForces& law, SliderContactForces& forces) const;

    std::unique_ptr<SeparationLaw> law_;
    ContactLever lever_;
    const MinimumSpacing& spacing_;
    mutable NearbySpacing near_;
    double length_, width_; // of the slider [m]
    ContactBranch first_;
    bool begun_ = false;
    Attitude attitude_; // of the last call
    SliderContactForces forces_;
    mutable std::optional<MinimumSpacing::Place> place_; // at attitude_, once it was asked for
    mutable std::optional<Matrix3> stiffness_;           // at attitude_, once it was asked for
};

} // namespace touchdown
