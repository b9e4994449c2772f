// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_model.h"

#include <cmath>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/numerics/interval.h"
#include "core/physics/contact/characteristic_fit.h"
#include "core/physics/contact/gap_law.h"
#include "core/physics/contact/multi_asperity.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/elastic_pad.h"

namespace touchdown {

namespace {

/// The simplified characteristic of Ono & Yamane.
class CharacteristicPad final : public ContactModel {
public:
    CharacteristicPad(const Case& c, const OnoYamane& parameters)
        : law_(parameters),
          touchDown_(parameters.touchDown),
          takeOff_(parameters.takeOff),
          separation_(c.approach.start),
          branch_(law_.nextBranch(c.initial.branch, c.approach.start))
    {}

    const ContactForces& move(double separation, double) override
    {
        branch_ = law_.nextBranch(branch_, separation);
        separation_ = separation;
        const ContactRegion region = law_.region(branch_, separation);
        forces_.separation = separation;
        forces_.contact = law_.contactForce(region, separation);
        forces_.adhesion = law_.adhesionForce(region, separation);
        return forces_;
    }
    std::vector<ContactSwitch> switchesUntil(double separation) const override
    {
        if (branch_ == ContactBranch::TouchDown && separation_ > touchDown_ && separation <= touchDown_)
            return {{touchDown_, switchName(ContactRegion::Apart, ContactRegion::Pressed)}};
        if (branch_ == ContactBranch::TakeOff && separation_ < takeOff_ && separation >= takeOff_)
            return {{takeOff_, switchName(ContactRegion::Bridged, ContactRegion::Apart)}};
        return {};
    }
    /// The forces are affine within a region, so that the strongest pull is at an end of one.
    std::vector<PullPoint> pullsUntil(double separation) const override
    {
        std::vector<PullPoint> list;
        for (ContactRegion region = law_.region(branch_, separation_);; region = law_.beyond(region, true)) {
            const double end = law_.interval(region).upper;
            if (end > separation) return list;
            list.push_back({end, law_.contactForce(region, end) + law_.adhesionForce(region, end)});
        }
    }

private:
    OnoYamaneLaw law_;
    double touchDown_, takeOff_, separation_;
    ContactBranch branch_;
    ContactForces forces_;
};

/// A pressure of the gap, which keeps no memory.
class AsperityPad final : public ContactModel {
public:
    explicit AsperityPad(const Case& c)
        : law_(c.asperity, c.elastic.pair, c.adhesion), padArea_(c.pad.length * c.pad.width)
    {}

    const ContactForces& move(double separation, double) override
    {
        forces_.separation = separation;
        const GapForces at = law_.at(separation);
        forces_.contact = padArea_ * at.contact;
        forces_.adhesion = padArea_ * at.adhesion;
        forces_.area = padArea_ * at.area;
        return forces_;
    }
    std::vector<PullPoint> pullsUntil(double separation) const override
    {
        if (!(separation > forces_.separation)) return {};
        const TracedContact way{[this](double d) { return padArea_ * law_.pressures(d).total(); }, {}, [] {}};
        return {strongestPull(way, forces_.separation, separation, resolution)};
    }

private:
    static constexpr double resolution = 1e-14; // of the separation of the strongest pull [m]
    GapLaw law_;
    double padArea_; // [m^2]
    ContactForces forces_;
};

/// The full model of Ono & Yamane beside the five parameters fitted to it.
class MultiAsperityPad final : public ContactModel {
public:
    explicit MultiAsperityPad(const Case& c)
        : model_(c.asperity, c.meniscus, c.elastic.pair, c.pad.length * c.pad.width),
          separation_(c.approach.start),
          state_(model_.start(c.approach.start)),
          fit_(fitCharacteristic(model_, c.approach.start, c.approach.closest, {.friction = c.asperity.friction})),
          fitted_(fit_.parameters),
          fittedBranch_(fitted_.nextBranch(ContactBranch::TouchDown, c.approach.start))
    {}

    const ContactForces& move(double separation, double) override
    {
        state_ = model_.advance(state_, separation);
        separation_ = separation;
        const MultiAsperityForces full = model_.forces(state_);
        forces_.separation = separation;
        forces_.contact = full.contact;
        forces_.adhesion = full.adhesion;
        forces_.area = full.contactArea;
        fittedBranch_ = fitted_.nextBranch(fittedBranch_, separation);
        const ContactRegion region = fitted_.region(fittedBranch_, separation);
        forces_.fittedContact = fitted_.contactForce(region, separation);
        forces_.fittedAdhesion = fitted_.adhesionForce(region, separation);
        return forces_;
    }
    std::vector<ContactSwitch> switchesUntil(double separation) const override
    {
        const PadMotion motion = separation < separation_ ? PadMotion::Towards : PadMotion::Away;
        const auto passed = [&](double d) { return motion == PadMotion::Towards ? d >= separation : d <= separation; };
        std::vector<ContactSwitch> list;
        MultiAsperityState state = state_;
        for (auto jump = model_.nextJump(state, motion); jump && passed(jump->padSeparation);
             jump = model_.nextJump(state, motion)) {
            list.push_back({jump->padSeparation, motion == PadMotion::Towards ? "touch-down" : "take-off"});
            state = jump->to;
        }
        return list;
    }
    /// At each jump, and on the smooth way to it and beyond the last.
    std::vector<PullPoint> pullsUntil(double separation) const override
    {
        std::vector<PullPoint> list;
        MultiAsperityState state = state_;
        const TracedContact way{[&](double d) { return model_.forces(model_.advance(state, d)).total(); }, {}, [] {}};
        double from = separation_;
        while (from < separation) {
            const auto jump = model_.nextJump(state, PadMotion::Away);
            const bool passed = jump && jump->padSeparation <= separation;
            const double to = passed ? jump->padSeparation : separation;
            list.push_back(strongestPull(way, from, to, resolution));
            if (!passed) break;
            list.push_back({to, model_.forces(jump->from).total()});
            state = jump->to;
            from = to;
        }
        return list;
    }
    std::optional<CharacteristicFit> fit() const override { return fit_; }

private:
    static constexpr double resolution = 1e-15; // of the separation of the strongest pull [m]
    MultiAsperity model_;
    double separation_;
    MultiAsperityState state_;
    CharacteristicFit fit_;
    OnoYamaneLaw fitted_;
    ContactBranch fittedBranch_;
    ContactForces forces_;
};

} // namespace

std::vector<ContactSwitch> ContactModel::switchesUntil(double) const { return {}; }

std::vector<PullPoint> ContactModel::pullsUntil(double) const { return {}; }

void ContactModel::observe(FieldSnapshot& snapshot) const { snapshot.values.clear(); }

std::unique_ptr<ContactModel> makeContactModel(const Case& c, const std::function<bool()>& goOn, bool coarser)
{
    switch (c.contact) {
    case ContactKind::None: break;
    case ContactKind::OnoYamane: return std::make_unique<CharacteristicPad>(c, *characteristic(c));
    case ContactKind::Elastic: return std::make_unique<ElasticPad>(c, goOn, coarser);
    case ContactKind::Asperity: return std::make_unique<AsperityPad>(c);
    case ContactKind::MultiAsperity: return std::make_unique<MultiAsperityPad>(c);
    }
    return nullptr;
}

ContactRows contactRows(const Case& c)
{
    using S = const ContactSample&;
    const bool surfaces = c.contact == ContactKind::Elastic;
    const bool summits = c.contact == ContactKind::Asperity || c.contact == ContactKind::MultiAsperity;
    ContactRows list{
        {{"minimum_spacing", "m", "nm", "Separation of the pad's lowest point and the disk's mean plane"},
         [](S s) { return s.forces.separation; }},
        {{"contact_force", "N", "mN", "Real contact force"}, [](S s) { return s.forces.contact; }},
    };
    if (contactLaw(c).adheres(c))
        list.push_back({{"adhesion_force", "N", "mN", "Adhesion force"}, [](S s) { return s.forces.adhesion; }});
    list.insert(
        list.end(),
        {{{"net_contact_force", "N", "mN", "Net contact force"}, [](S s) { return s.forces.net(); }},
         {{"friction_force", "N", "mN", "Friction force, in the disk's direction"}, [](S s) { return s.friction; }},
         {{"friction_torque", "N m", "uN m", "Pitch torque of the friction about the mass centre, nose up"},
          [](S s) { return s.frictionTorque; }}});
    if (surfaces || summits)
        list.push_back({{"contact_area", "m^2", "um^2", "Real area of contact"}, [](S s) { return s.forces.area; }});
    if (surfaces)
        list.insert(list.end(), {{{"peak_contact_pressure", "Pa", "MPa", "Peak contact pressure"},
                                  [](S s) { return s.forces.peakPressure; }},
                                 {{"minimum_gap", "m", "nm", "Smallest gap of the deformed surfaces"},
                                  [](S s) { return s.forces.minimumGap; }}});
    if (c.contact == ContactKind::MultiAsperity)
        list.insert(list.end(),
                    {{{"fitted_contact_force", "N", "mN", "Real contact force of the fitted characteristic"},
                      [](S s) { return s.forces.fittedContact; }},
                     {{"fitted_adhesion_force", "N", "mN", "Adhesion force of the fitted characteristic"},
                      [](S s) { return s.forces.fittedAdhesion; }}});
    return list;
}

void contactValues(const Case& c, const ContactRows& rows, const ContactForces& forces, double* values)
{
    const CoulombFriction friction = frictionOf(c);
    const Velocity disk =
        diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width);
    const double sliding = std::hypot(disk.x, disk.y);
    ContactSample sample{.forces = forces, .friction = friction.force(forces.contact, sliding)};
    // The moment is that of the part along the slider.
    if (sliding > 0.0) sample.frictionTorque = friction.pitchMoment(forces.contact, sliding) * disk.x / sliding;
    // Adding zero turns -0 into 0.
    for (const auto& row : rows) *values++ = row.value(sample) + 0.0;
}

RecordedFields contactMaps(const Case& c)
{
    return c.contact == ContactKind::Elastic && c.run.fieldSnapshots > 0 ? ElasticPad::fields(c) : RecordedFields{};
}

} // namespace touchdown
