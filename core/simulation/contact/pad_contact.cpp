// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/pad_contact.h"

#include <utility>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"

namespace touchdown {
namespace {

/// By which the corners move where a stiffness is taken from two loads [m]: far below the bearing depth.
constexpr double stiffnessStep = 1e-13;

} // namespace

std::unique_ptr<SeparationLaw> makeSeparationLaw(const Case& c)
{
    switch (c.contact) {
    case ContactKind::OnoYamane: return std::make_unique<CharacteristicLaw>(*characteristic(c));
    case ContactKind::MultiAsperity: return std::make_unique<MultiAsperityLaw>(manyAsperities(c));
    case ContactKind::Asperity: // gapLawOf
    case ContactKind::Elastic:  // on cells
    case ContactKind::None: break;
    }
    return nullptr;
}

std::optional<GapLaw> gapLawOf(const Case& c)
{
    if (c.contact != ContactKind::Asperity) return std::nullopt;
    return GapLaw(c.asperity, c.elastic.pair, c.adhesion);
}

MultiAsperity manyAsperities(const Case& c)
{
    return MultiAsperity(c.asperity, c.meniscus, c.elastic.pair, c.pad.length * c.pad.width);
}

PadContact::PadContact(const Case& c, std::unique_ptr<SeparationLaw> law, const MinimumSpacing& spacing)
    : law_(std::move(law)),
      lever_(c),
      spacing_(spacing),
      near_(spacing, 0.0),
      length_(c.slider.length),
      width_(c.slider.width),
      first_(c.initial.branch)
{}

void PadContact::begin(ContactBranch branch, const Attitude& attitude)
{
    law_->begin(branch, separation(attitude));
    begun_ = true;
    stiffness_.reset();
}

const SliderContactForces& PadContact::at(const Attitude& attitude, double)
{
    attitude_ = attitude;
    place_ = {};
    stiffness_.reset();
    if (!begun_) law_->begin(first_, separation(attitude));
    forces_ = {};
    if (law_->acts()) loadAt(place(), law_->at(place().spacing), forces_);
    return forces_;
}

const MinimumSpacing::Place& PadContact::place() const
{
    if (!place_) place_ = near_.bearing(attitude_, bearingDepth);
    return *place_;
}

Vector3 PadContact::loadAt(const MinimumSpacing::Place& place, const SeparationForces& law,
                           SliderContactForces& forces) const
{
    const Vector3 arms = lever_.arms(place.at.x, place.at.y);
    const ContactLever::Rubbing rubbing = lever_.rubbing(place.at.x, place.at.y);
    forces.contact = law.contact.at(place.spacing);
    forces.adhesion = law.adhesion.at(place.spacing);
    const double force = forces.contact + forces.adhesion;
    forces.friction = rubbing.force * forces.contact;
    forces.pitchTorque = arms[1] * force + rubbing.pitchTorque * forces.contact;
    forces.rollTorque = arms[2] * force + rubbing.rollTorque * forces.contact;
    forces.area = law.area;
    forces.storedEnergy = law.storedEnergy;
    return forces.load();
}

// By differences of the law's tangents: the place of the force moves with the attitude, too.
Matrix3 PadContact::stiffness() const
{
    if (stiffness_) return *stiffness_;
    Matrix3& result = stiffness_.emplace(Matrix3::Zero());
    if (!law_->acts()) return result;
    const SeparationForces law = law_->at(place().spacing);
    SliderContactForces forces;
    const Vector3 load = loadAt(place(), law, forces);
    const Vector3 step{stiffnessStep, stiffnessStep / length_, stiffnessStep / width_};
    for (Eigen::Index m = 0; m < 3; ++m) {
        Vector3 moved = Vector3::Zero();
        moved[m] = step[m];
        // Turning about the mass centre lifts the trailing edge's centre by -L/2 pitch.
        const Attitude attitude{attitude_.height + moved[0] - 0.5 * length_ * moved[1], attitude_.pitch + moved[1],
                                attitude_.roll + moved[2]};
        const Vector3 there = loadAt(near_.bearing(attitude, bearingDepth), law, forces);
        result.col(m) = (load - there) / step[m];
    }
    return result;
}

void PadContact::moveLittle(double margin) { near_ = {spacing_, margin}; }

bool PadContact::outOfReach(const Attitude& attitude) const { return law_->outOfReach(separation(attitude)); }

void PadContact::accept()
{
    begun_ = true;
    law_->accept(separation(attitude_));
    stiffness_.reset();
}

std::string PadContact::cross(bool upper)
{
    begun_ = true;
    stiffness_.reset();
    return law_->cross(upper);
}

} // namespace touchdown
