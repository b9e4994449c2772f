// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/pad_law.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/case/contact_law.h"
#include "core/numerics/gauss_legendre.h"
#include "core/physics/contact/gap_law.h"
#include "core/simulation/contact/pad_contact.h"

namespace touchdown {

namespace {

/// Ono and Yamane's five parameters.
class CharacteristicOfPad final : public PadLaw {
public:
    explicit CharacteristicOfPad(const OnoYamane& parameters) : law_(parameters) {}

    PadForces at(ContactRegion region, double d) const override
    {
        const AffineForce &contact = law_.contactLaw(region), &adhesion = law_.adhesionLaw(region);
        return {contact.at(d), adhesion.at(d), contact.slope, adhesion.slope, 0.0, law_.storedEnergy(region, d)};
    }
    double work(ContactRegion region, double from, double to) const override
    {
        const double middle = 0.5 * (from + to);
        return (law_.contactForce(region, middle) + law_.adhesionForce(region, middle)) * (to - from); // affine: exact
    }
    Interval interval(ContactRegion region) const override { return law_.interval(region); }
    ContactRegion beyond(ContactRegion region, bool upper) const override { return law_.beyond(region, upper); }
    ContactRegion region(ContactBranch branch, double d) const override { return law_.region(branch, d); }
    ContactBranch nextBranch(ContactBranch previous, double d) const override { return law_.nextBranch(previous, d); }

private:
    OnoYamaneLaw law_;
};

/// A pressure of the gap over a flat pad, parallel to the disk.
class PressureOnPad final : public PadLaw {
public:
    PressureOnPad(const GapLaw& law, double area, double typical) : law_(law), area_(area), typical_(typical) {}

    PadForces at(ContactRegion, double d) const override
    {
        const GapForces at = law_.at(d);
        return {area_ * at.contact,       area_ * at.adhesion, area_ * at.contactSlope,
                area_ * at.adhesionSlope, area_ * at.area,     area_ * at.energy};
    }
    PadForces forces(ContactRegion, double d) const override
    {
        const GapForces at = law_.pressures(d);
        return {.contact = area_ * at.contact, .adhesion = area_ * at.adhesion};
    }
    bool affine() const override { return false; }
    double work(ContactRegion region, double from, double to) const override
    {
        return at(region, from).energy - at(region, to).energy;
    }
    double stiffness() const override { return std::abs(at({}, typical_).contactSlope); }

private:
    GapLaw law_;
    double area_;    // of the pad [m^2]
    double typical_; // separation in contact [m]
};

/// Two branches of a law of the separation.
class BranchesOfPad final : public PadLaw {
public:
    BranchesOfPad(std::unique_ptr<SeparationLaw> in, std::unique_ptr<SeparationLaw> out)
        : in_(std::move(in)), out_(std::move(out))
    {
        constexpr double clear = 1e-9; // of its reach: on the branch of a pad that comes from afar [m]
        in_->begin(ContactBranch::TouchDown, in_->reach() + clear);
        touchDown_ = in_->interval().lower;
        if (!switches()) return;
        out_->begin(ContactBranch::TakeOff, touchDown_);
        takeOff_ = out_->interval().upper;
    }

    PadForces at(ContactRegion region, double d) const override
    {
        const SeparationForces at = (region == ContactRegion::Apart || !switches() ? in_ : out_)->at(d);
        return {at.contact.at(d), at.adhesion.at(d), at.contact.slope, at.adhesion.slope, at.area, at.storedEnergy};
    }
    bool affine() const override { return false; }
    Interval interval(ContactRegion region) const override
    {
        if (!switches()) return {};
        return region == ContactRegion::Apart ? Interval{.lower = touchDown_} : Interval{.upper = takeOff_};
    }
    ContactRegion beyond(ContactRegion, bool upper) const override
    {
        return upper ? ContactRegion::Apart : ContactRegion::Pressed;
    }
    ContactRegion region(ContactBranch branch, double d) const override
    {
        return switches() && nextBranch(branch, d) == ContactBranch::TakeOff ? ContactRegion::Pressed
                                                                             : ContactRegion::Apart;
    }
    ContactBranch nextBranch(ContactBranch previous, double d) const override
    {
        if (d <= touchDown_) return ContactBranch::TakeOff;
        return d >= takeOff_ ? ContactBranch::TouchDown : previous;
    }

private:
    bool switches() const { return std::isfinite(touchDown_); }

    std::unique_ptr<SeparationLaw> in_, out_;
    double touchDown_, takeOff_ = std::numeric_limits<double>::infinity(); // [m]
};

} // namespace

double PadLaw::stiffness() const { return std::abs(at(ContactRegion::Pressed, 0.0).contactSlope); }

double PadLaw::work(ContactRegion region, double from, double to) const
{
    static const GaussLegendre<5> quadrature;
    double sum = 0.0;
    quadrature.sample(from, to, [&](double d, double weight) { sum += weight * forces(region, d).net(); });
    return sum;
}

std::unique_ptr<const PadLaw> makePadLaw(std::unique_ptr<SeparationLaw> in, std::unique_ptr<SeparationLaw> out)
{
    return std::make_unique<BranchesOfPad>(std::move(in), std::move(out));
}

std::unique_ptr<const PadLaw> makePadLaw(const Case& c)
{
    if (c.contact == noContact || !contactLaw(c).whyNot(ModelKind::Springs).empty()) return std::make_unique<PadLaw>();
    if (const auto parameters = characteristic(c)) return std::make_unique<CharacteristicOfPad>(*parameters);
    if (auto law = makeSeparationLaw(c)) return makePadLaw(std::move(law), makeSeparationLaw(c));
    return std::make_unique<PressureOnPad>(*gapLawOf(c), c.pad.length * c.pad.width, c.asperity.planeHeight);
}

} // namespace touchdown
