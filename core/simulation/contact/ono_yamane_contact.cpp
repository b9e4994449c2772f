// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/ono_yamane_contact.h"

namespace touchdown {
namespace {

/// Points so near to the nearest one's height bear with it [m].
constexpr double bearingDepth = 1e-11;
/// By which the corners move where a stiffness is taken from two loads [m]: far below the bearing depth.
constexpr double stiffnessStep = 1e-13;

} // namespace

OnoYamaneContact::OnoYamaneContact(const Case& c, const MinimumSpacing& spacing)
    : law_(c.onoYamane),
      lever_(c),
      spacing_(spacing),
      length_(c.slider.length),
      width_(c.slider.width),
      takeOff_(c.onoYamane.takeOff),
      first_(c.initial.branch)
{}

const SliderContactForces& OnoYamaneContact::at(const Attitude& attitude, double)
{
    attitude_ = attitude;
    stiffness_.reset();
    if (!begun_) {
        region_ = law_.region(first_, spacing_.at(attitude).spacing);
        setInterval();
    }
    if (region_ == ContactRegion::Apart)
        forces_ = {};
    else
        loadAt(attitude, forces_);
    return forces_;
}

Vector3 OnoYamaneContact::loadAt(const Attitude& attitude, SliderContactForces& forces) const
{
    const MinimumSpacing::Place place = spacing_.bearing(attitude, bearingDepth);
    const Vector3 arms = lever_.arms(place.at.x, place.at.y);
    const ContactLever::Rubbing rubbing = lever_.rubbing(place.at.x, place.at.y);
    forces.contact = law_.contactForce(region_, place.spacing);
    forces.adhesion = law_.adhesionForce(region_, place.spacing);
    const double force = forces.contact + forces.adhesion;
    forces.friction = rubbing.force * forces.contact;
    forces.pitchTorque = arms[1] * force + rubbing.pitchTorque * forces.contact;
    forces.rollTorque = arms[2] * force + rubbing.rollTorque * forces.contact;
    forces.storedEnergy = law_.storedEnergy(region_, place.spacing);
    return forces.load();
}

// By differences: the place of the force moves with the attitude, too.
Matrix3 OnoYamaneContact::stiffness() const
{
    if (stiffness_) return *stiffness_;
    Matrix3& result = stiffness_.emplace(Matrix3::Zero());
    if (region_ == ContactRegion::Apart) return result;
    SliderContactForces forces;
    const Vector3 load = loadAt(attitude_, forces);
    const Vector3 step{stiffnessStep, stiffnessStep / length_, stiffnessStep / width_};
    for (Eigen::Index m = 0; m < 3; ++m) {
        Vector3 moved = Vector3::Zero();
        moved[m] = step[m];
        // Turning about the mass centre lifts the trailing edge's centre by -L/2 pitch.
        const Attitude attitude{attitude_.height + moved[0] - 0.5 * length_ * moved[1], attitude_.pitch + moved[1],
                                attitude_.roll + moved[2]};
        const Vector3 there = loadAt(attitude, forces);
        result.col(m) = (load - there) / step[m];
    }
    return result;
}

bool OnoYamaneContact::outOfReach(const Attitude& attitude) const
{
    return region_ == ContactRegion::Apart && spacing_.at(attitude).spacing > takeOff_;
}

bool OnoYamaneContact::sameLaw(ContactRegion a, ContactRegion b) const
{
    const auto same = [](const AffineForce& f, const AffineForce& g) {
        return f.constant == g.constant && f.slope == g.slope;
    };
    return same(law_.contactLaw(a), law_.contactLaw(b)) && same(law_.adhesionLaw(a), law_.adhesionLaw(b));
}

/// The last region up there, or down there, whose law is this one's: nothing switches on the way.
ContactRegion OnoYamaneContact::lastOfLaw(bool upper) const
{
    ContactRegion last = region_;
    for (ContactRegion next; (next = law_.beyond(last, upper)) != last && sameLaw(last, next);) last = next;
    return last;
}

void OnoYamaneContact::setInterval()
{
    interval_ = {law_.interval(lastOfLaw(false)).lower, law_.interval(lastOfLaw(true)).upper};
}

void OnoYamaneContact::setRegion(ContactRegion region)
{
    region_ = region;
    region_ = lastOfLaw(false);
    stiffness_.reset();
    begun_ = true;
    setInterval();
}

std::string OnoYamaneContact::cross(bool upper)
{
    const ContactRegion before = lastOfLaw(upper);
    region_ = law_.beyond(before, upper);
    stiffness_.reset();
    begun_ = true;
    setInterval();
    return switchName(before, region_);
}

} // namespace touchdown
