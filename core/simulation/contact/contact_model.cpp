// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_model.h"

#include <utility>

#include "core/case/contact_law.h"
#include "core/case/contact_patches.h"
#include "core/case/disk_setup.h"
#include "core/physics/contact/characteristic_fit.h"
#include "core/physics/contact/separation_law.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/elastic_pad.h"
#include "core/simulation/contact/pad_contact.h"

namespace touchdown {

namespace {

constexpr double pullSeparation = 1e-15; // to which that of the strongest pull is found [m]

/// The law of the separation under a pad without tilt; null for one that acts on cells.
std::unique_ptr<SeparationLaw> lawUnderPad(const Case& c)
{
    if (auto gap = gapLawOf(c)) return std::make_unique<UniformGapLaw>(std::move(*gap), c.pad.length * c.pad.width);
    return makeSeparationLaw(c);
}

/// The strongest net pulls on the way out along a branch: at its end, and before it unless the law is a straight line.
void addPulls(const SeparationLaw& law, double from, double to, std::vector<PullPoint>& pulls)
{
    const SeparationForces first = law.at(from), last = law.at(to);
    if (!(first.contact == last.contact && first.adhesion == last.adhesion)) {
        const TracedContact way{[&](double d) { return law.at(d).netAt(d); }, {}, [] {}};
        pulls.push_back(strongestPull(way, from, to, pullSeparation));
    }
    pulls.push_back({to, last.netAt(to)});
}

/// Moves the law straight from one separation to another. Returns its forces there.
SeparationForces follow(SeparationLaw& law, double from, double to, PadMove& passed)
{
    passed.switches.clear();
    passed.pulls.clear();
    const bool away = to > from;
    if (away) passed.pulls.push_back({from, law.at(from).netAt(from)});
    for (;;) {
        const Interval holds = law.interval();
        const double end = away ? holds.upper : holds.lower;
        const bool ends = away ? to >= end : to <= end;
        if (away) addPulls(law, from, ends ? end : to, passed.pulls);
        if (!ends) break;
        const std::string name = law.cross(away);
        // At the other ends of a straight line the force bends, and does not jump.
        if (name == "touch-down" || name == "take-off") passed.switches.push_back({end, name});
        from = end;
    }
    const SeparationForces forces = law.at(to);
    law.accept(to);
    return forces;
}

/// A law of the separation alone, and beside the full model of Ono & Yamane the five parameters fitted to it.
class SeparationPad final : public ContactModel {
public:
    SeparationPad(const Case& c, std::unique_ptr<SeparationLaw> law)
        : law_(std::move(law)), separation_(c.approach.start)
    {
        law_->begin(characteristic(c) ? c.initial.branch : ContactBranch::TouchDown, separation_);
        if (!contactLaw(c).recordsFit) return;
        fit_ = fitCharacteristic(manyAsperities(c), separation_, c.approach.closest, {.friction = c.asperity.friction});
        fitted_.emplace(fit_->parameters).begin(ContactBranch::TouchDown, separation_);
    }

    const ContactForces& move(double separation, double) override
    {
        if (fitted_) {
            const SeparationForces fitted = follow(*fitted_, separation_, separation, way_);
            forces_.fittedContact = fitted.contact.at(separation);
            forces_.fittedAdhesion = fitted.adhesion.at(separation);
        }
        const SeparationForces forces = follow(*law_, separation_, separation, way_);
        separation_ = forces_.separation = separation;
        forces_.contact = forces.contact.at(separation);
        forces_.adhesion = forces.adhesion.at(separation);
        forces_.area = forces.area;
        return forces_;
    }
    void pass(StateStream& stream) override
    {
        stream(*law_, separation_, forces_);
        if (fitted_) stream(*fitted_);
    }
    std::optional<CharacteristicFit> fit() const override { return fit_; }

private:
    std::unique_ptr<SeparationLaw> law_;
    double separation_; // [m]
    std::optional<CharacteristicFit> fit_;
    std::optional<CharacteristicLaw> fitted_;
    ContactForces forces_;
};

} // namespace

std::unique_ptr<ContactModel> makeContactModel(const Case& c, const std::function<bool()>& goOn, bool coarser)
{
    if (contactLaw(c).recordsSurfaces) return std::make_unique<ElasticPad>(c, goOn, coarser);
    if (auto law = lawUnderPad(c)) return std::make_unique<SeparationPad>(c, std::move(law));
    return nullptr;
}

ContactRows contactRows(const Case& c)
{
    using S = const ContactSample&;
    const ContactLaw& law = contactLaw(c);
    ContactRows list{
        {{"minimum_spacing", "m", "nm", "Separation of the pad's lowest point and the disk's mean plane"},
         [](S s) { return s.forces.separation; }},
        {{"contact_force", "N", "mN", "Real contact force"}, [](S s) { return s.forces.contact; }},
    };
    if (law.adheres(c))
        list.push_back({{"adhesion_force", "N", "mN", "Adhesion force"}, [](S s) { return s.forces.adhesion; }});
    list.insert(
        list.end(),
        {{{"net_contact_force", "N", "mN", "Net contact force"}, [](S s) { return s.forces.net(); }},
         {{"friction_force", "N", "mN", "Friction force, in the disk's direction"}, [](S s) { return s.friction; }},
         {{"friction_torque", "N m", "uN m", "Pitch torque of the friction about the mass centre, nose up"},
          [](S s) { return s.frictionTorque; }}});
    if (law.recordsArea)
        list.push_back({{"contact_area", "m^2", "um^2", "Real area of contact"}, [](S s) { return s.forces.area; }});
    if (law.recordsSurfaces)
        list.insert(list.end(), {{{"peak_contact_pressure", "Pa", "MPa", "Peak contact pressure"},
                                  [](S s) { return s.forces.peakPressure; }},
                                 {{"minimum_gap", "m", "nm", "Smallest gap of the deformed surfaces"},
                                  [](S s) { return s.forces.minimumGap; }}});
    if (law.recordsFit)
        list.insert(list.end(),
                    {{{"fitted_contact_force", "N", "mN", "Real contact force of the fitted characteristic"},
                      [](S s) { return s.forces.fittedContact; }},
                     {{"fitted_adhesion_force", "N", "mN", "Adhesion force of the fitted characteristic"},
                      [](S s) { return s.forces.fittedAdhesion; }}});
    return list;
}

void contactValues(const Case& c, const ContactRows& rows, const ContactForces& forces, double* values)
{
    const ContactLever::Rubbing rubbing = ContactLever(c).rubbing(0.5 * c.slider.length, 0.5 * c.slider.width);
    const ContactSample sample{forces, rubbing.force * forces.contact, rubbing.pitchTorque * forces.contact};
    // Adding zero turns -0 into 0.
    for (const auto& row : rows) *values++ = row.value(sample) + 0.0;
}

RecordedFields contactMaps(const Case& c)
{
    if (!contactLaw(c).recordsSurfaces || c.run.fieldSnapshots == 0) return {};
    // A measured surface is long to read, and only the patches of a slider's shape depend on it.
    const DiskTopography surface = c.pad.shape == PadShape::Slider ? diskTopography(c) : DiskTopography();
    return elasticFields(c, patchesOf(c, surface));
}

} // namespace touchdown
