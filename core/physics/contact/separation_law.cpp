// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/separation_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

CharacteristicLaw::CharacteristicLaw(const OnoYamane& parameters) : law_(parameters), takeOff_(parameters.takeOff)
{
    setInterval();
}

SeparationForces CharacteristicLaw::at(double separation) const
{
    return {.contact = law_.contactLaw(region_),
            .adhesion = law_.adhesionLaw(region_),
            .storedEnergy = law_.storedEnergy(region_, separation)};
}

bool CharacteristicLaw::sameLaw(ContactRegion a, ContactRegion b) const
{
    return law_.contactLaw(a) == law_.contactLaw(b) && law_.adhesionLaw(a) == law_.adhesionLaw(b);
}

/// The last region up there, or down there, whose law is this one's: nothing switches on the way. Without menisci no
/// force tells Bridged from Apart, but a slider that comes back from beyond d_e touches down at d_s again.
ContactRegion CharacteristicLaw::lastOfLaw(bool upper) const
{
    ContactRegion last = region_;
    for (ContactRegion next; (next = law_.beyond(last, upper)) != last && next != ContactRegion::Apart &&
                             last != ContactRegion::Apart && sameLaw(last, next);)
        last = next;
    return last;
}

void CharacteristicLaw::setInterval()
{
    interval_ = {law_.interval(lastOfLaw(false)).lower, law_.interval(lastOfLaw(true)).upper};
}

void CharacteristicLaw::setRegion(ContactRegion region)
{
    region_ = region;
    region_ = lastOfLaw(false);
    setInterval();
}

void CharacteristicLaw::begin(ContactBranch branch, double separation)
{
    region_ = law_.region(branch, separation);
    setInterval();
}

std::string CharacteristicLaw::cross(bool upper)
{
    const ContactRegion before = lastOfLaw(upper);
    region_ = law_.beyond(before, upper);
    setInterval();
    return switchName(before, region_);
}

SeparationForces UniformGapLaw::at(double separation) const
{
    const GapForces forces = law_.at(separation);
    return {.contact = {area_ * forces.contact, area_ * forces.contactSlope, separation},
            .adhesion = {area_ * forces.adhesion, area_ * forces.adhesionSlope, separation},
            .area = area_ * forces.area,
            .storedEnergy = area_ * forces.energy};
}

MultiAsperityLaw::MultiAsperityLaw(MultiAsperity model) : model_(std::move(model)), reach_(model_.reach())
{
    setState(model_.start(reach_));
}

void MultiAsperityLaw::setState(const MultiAsperityState& state)
{
    state_ = state;
    touchDown_ = model_.nextJump(state_, PadMotion::Towards);
    takeOff_ = model_.nextJump(state_, PadMotion::Away);
}

MultiAsperityState MultiAsperityLaw::stateAt(double separation) const
{
    if (touchDown_ && separation <= touchDown_->padSeparation) return touchDown_->from;
    if (takeOff_ && separation >= takeOff_->padSeparation) return takeOff_->from;
    return model_.advance(state_, separation);
}

// Contact and adhesion follow s, and the summits that s wets or dries; d'(s) = 1 - F_c'(s)/k_b.
SeparationForces MultiAsperityLaw::at(double separation) const
{
    const Interval holds = interval();
    const MultiAsperityState state = stateAt(separation);
    const MultiAsperityForces forces = model_.forces(state);
    // At the accepted state rounding must not choose between the slopes of the two ways.
    constexpr double resolved = 1e-14; // of a way [m]
    const bool towards = separation < model_.padSeparation(state_) - resolved;
    const PadMotion motion = towards ? PadMotion::Towards : PadMotion::Away;
    const bool beyond = separation <= holds.lower || separation >= holds.upper;
    const bool smooth = !beyond && model_.bulkStiffness() > 0.0; // a pad without area has neither forces nor slopes
    const MultiAsperitySlopes slopes = smooth ? model_.slopes(state, motion) : MultiAsperitySlopes{};
    return {.contact = {forces.contact, slopes.contact, separation},
            .adhesion = {forces.adhesion, slopes.adhesion, separation},
            .area = forces.contactArea,
            .storedEnergy = forces.storedEnergy};
}

void MultiAsperityLaw::accept(double separation) { setState(stateAt(separation)); }

Interval MultiAsperityLaw::interval() const
{
    Interval holds;
    if (touchDown_) holds.lower = touchDown_->padSeparation;
    if (takeOff_) holds.upper = takeOff_->padSeparation;
    return holds;
}

std::string MultiAsperityLaw::cross(bool upper)
{
    setState(upper ? takeOff_->to : touchDown_->to);
    return upper ? "take-off" : "touch-down";
}

void MultiAsperityLaw::begin(ContactBranch branch, double separation)
{
    MultiAsperityState state = model_.start(std::max(separation, reach_));
    if (branch == ContactBranch::TakeOff) {
        // So deep that every summit is wetted.
        const double pressed = std::min(separation, -reach_);
        state = model_.advance(state, pressed);
    }
    setState(model_.advance(state, separation));
}

} // namespace touchdown
