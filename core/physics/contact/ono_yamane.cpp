// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/ono_yamane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/numerics/interval.h"

namespace touchdown {

OnoYamaneLaw::OnoYamaneLaw(const OnoYamane& parameters)
{
    using enum ContactRegion;
    const double ds = parameters.touchDown;
    const double de = parameters.takeOff;
    const double kc = parameters.contactStiffness;
    const double fc0 = parameters.initialContactForce;
    const double fm = parameters.meniscusForce;

    const bool bothFall = parameters.takeOffShape == TakeOffShape::BothLinear;
    // F_cr reaches zero at d_s + f_c0/k_c, unless the take-off height comes first.
    release_ = fc0 <= 0.0 ? ds : kc > 0.0 && !bothFall ? std::min(de, ds + fc0 / kc) : de;

    Row pressed{{fc0 + kc * ds, -kc}, {-fm, 0.0}, -std::numeric_limits<double>::infinity(), ds, Pressed, Lifting};
    Row lifting{{fc0 + kc * ds, -kc}, {-fm, 0.0}, ds, release_, Pressed, Bridged};
    Row bridged{{}, {-fm, 0.0}, release_, de, Lifting, Apart};
    const Row apart{{}, {}, ds, std::numeric_limits<double>::infinity(), Pressed, Apart};

    if (parameters.takeOffShape != TakeOffShape::Constant && de > ds) {
        const auto falling = [&](double force) { // force (d_e - d)/(d_e - d_s)
            return AffineForce{force * de / (de - ds), -force / (de - ds)};
        };
        for (Row* row : {&lifting, &bridged}) row->adhesion = falling(-fm);
        if (bothFall) lifting.contact = falling(fc0);
    }
    // Regions of no width are stepped over.
    if (release_ >= de) lifting.above = Apart;
    if (release_ <= ds) {
        pressed.above = de > ds ? Bridged : Apart;
        bridged.below = Pressed;
    }
    rows_ = {apart, pressed, lifting, bridged};
}

namespace {

constexpr double roundOff = 1e-12; // of the parts of a sum that cancel [-]

/// Of an affine force over a way [J].
double work(const AffineForce& force, double from, double to) { return force.at(0.5 * (from + to)) * (to - from); }

} // namespace

double OnoYamaneLaw::storedEnergy(ContactRegion region, double d) const
{
    using enum ContactRegion;
    if (region != Pressed && region != Lifting) return 0.0;
    const double touchDown = row(Pressed).upper;
    if (region == Lifting) return work(row(Lifting).contact, d, release_);
    return work(row(Pressed).contact, d, touchDown) + work(row(Lifting).contact, touchDown, release_);
}

double OnoYamaneLaw::cycleWork() const
{
    using enum ContactRegion;
    double byContact = 0.0, byAdhesion = 0.0; // on the slider, on its way up
    for (const auto& [region, from, to] :
         {std::tuple{Lifting, row(Pressed).upper, release_}, std::tuple{Bridged, release_, row(Bridged).upper}}) {
        byContact += work(row(region).contact, from, to);
        byAdhesion += work(row(region).adhesion, from, to);
    }
    const double taken = -(byContact + byAdhesion);
    return std::abs(taken) <= roundOff * std::max(byContact, -byAdhesion) ? 0.0 : taken;
}

double meniscusForceForWork(const OnoYamane& parameters, double work)
{
    auto workOf = [trial = parameters](double meniscusForce) mutable {
        trial.meniscusForce = meniscusForce;
        return OnoYamaneLaw(trial).cycleWork();
    };
    const double without = workOf(0.0);
    const double each = workOf(1.0) - without; // W is affine in f_m
    return std::max(0.0, (work - without) / each);
}

Interval OnoYamaneLaw::interval(ContactRegion region) const { return {row(region).lower, row(region).upper}; }

ContactRegion OnoYamaneLaw::region(ContactBranch branch, double d) const
{
    using enum ContactRegion;
    if (d <= row(Pressed).upper) return Pressed;
    if (branch == ContactBranch::TouchDown || d >= row(Bridged).upper) return Apart;
    return d < release_ ? Lifting : Bridged;
}

ContactBranch OnoYamaneLaw::nextBranch(ContactBranch previous, double d) const
{
    if (d <= row(ContactRegion::Pressed).upper) return ContactBranch::TakeOff;
    if (d >= row(ContactRegion::Bridged).upper) return ContactBranch::TouchDown;
    return previous;
}

std::string switchName(ContactRegion before, ContactRegion now)
{
    switch (now) {
    case ContactRegion::Apart: return "take-off";
    case ContactRegion::Pressed: return before == ContactRegion::Apart ? "touch-down" : "pressed again";
    case ContactRegion::Lifting: return before == ContactRegion::Pressed ? "lifting" : "pressed on menisci";
    case ContactRegion::Bridged: return "held by menisci";
    }
    return {};
}

std::optional<ContactBranch> branchAfterSwitch(std::string_view name)
{
    using enum ContactRegion;
    for (const ContactRegion before : {Apart, Pressed, Lifting, Bridged})
        for (const ContactRegion now : {Apart, Pressed, Lifting, Bridged})
            if (now != before && name == switchName(before, now))
                return now == Apart ? ContactBranch::TouchDown : ContactBranch::TakeOff;
    return {};
}

} // namespace touchdown
