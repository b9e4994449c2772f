// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_energy_balance.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/contact/contact_lever.h"

namespace touchdown {

namespace {

constexpr double onBoundary = 1e-15; // [m]

} // namespace

SpringEnergyBalance::SpringEnergyBalance(const SpringModel& model, const Case& c)
    : model_(model), law_(c.onoYamane), hasContact_(c.contact == ContactKind::OnoYamane), friction_(frictionOf(c))
{}

void SpringEnergyBalance::begin(const SpringModel::State& y, SpringModel::Mode mode)
{
    time_ = 0.0;
    y_ = y;
    region_ = mode.contact;
    separation_ = model_.guards(y.head<2>())[SpringModel::Pad];
    start_ = model_.energy(y);
    gained_ = {};
    missing_ = 0.0;
    least_ = most_ = {};
}

SpringEnergyBalance::Way SpringEnergyBalance::walk(double to)
{
    const double way = to - separation_;
    Way sum;
    double at = separation_;
    constexpr int mostRegions = 8; // of one step; there are four
    for (int k = 0; k < mostRegions; ++k) {
        const Interval holds = law_.interval(region_);
        const double end = std::clamp(to, holds.lower, holds.upper);
        const double middle = 0.5 * (at + end), part = end - at;
        const double contact = law_.contactForce(region_, middle);
        sum.work += (contact + law_.adhesionForce(region_, middle)) * part; // affine laws: exact
        sum.meanContact += way != 0.0 ? contact * part / way : 0.0;
        at = end;
        if (end == to) break;
        region_ = law_.beyond(region_, to > end);
    }
    if (way == 0.0) sum.meanContact = law_.contactForce(region_, to);
    separation_ = to;
    return sum;
}

void SpringEnergyBalance::add(double time, const SpringModel::State& y, SpringModel::Mode mode)
{
    const double h = time - time_;
    if (!(h > 0.0) || !y.allFinite()) return;
    SpringModel::State middle = y;
    middle.tail<2>() =
        1.5 / h * (y.head<2>() - y_.head<2>()) - 0.25 * (y_.tail<2>() + y.tail<2>()); // of the cubic through both ends
    const SpringModel::Mode apart{mode.frontSpring, mode.rearSpring, ContactRegion::Apart};
    gained_[0] += h / 6.0 * (model_.power(y_, apart) + 4.0 * model_.power(middle, apart) + model_.power(y, apart));
    if (hasContact_) {
        const Interval holds = law_.interval(region_);
        // A switch that was located ends a step on the boundary; the next one begins with the law beyond.
        if (std::min(std::abs(separation_ - holds.lower), std::abs(separation_ - holds.upper)) < onBoundary)
            region_ = mode.contact;
        const Way way = walk(model_.guards(y.head<2>())[SpringModel::Pad]);
        gained_[1] += way.work;
        gained_[2] -= friction_.noseDown() * way.meanContact * (y[1] - y_[1]);
        const Interval next = law_.interval(mode.contact);
        if (separation_ > next.lower - onBoundary && separation_ < next.upper + onBoundary) region_ = mode.contact;
    }
    time_ = time;
    y_ = y;
    keep(model_.energy(y) - start_);
}

void SpringEnergyBalance::keep(double energy)
{
    const std::array<double, 4> parts{energy, gained_[0], gained_[1], gained_[2]};
    for (std::size_t k = 0; k < parts.size(); ++k) {
        least_[k] = std::min(least_[k], parts[k]);
        most_[k] = std::max(most_[k], parts[k]);
    }
    missing_ = std::max(missing_, std::abs(energy - gained_[0] - gained_[1] - gained_[2]));
}

double SpringEnergyBalance::imbalance() const
{
    double range = 0.0;
    for (std::size_t k = 0; k < least_.size(); ++k) range = std::max(range, most_[k] - least_[k]);
    return range > 1e-12 * model_.energyBound() ? missing_ / range : 0.0; // what stays at rest moves no energy
}

} // namespace touchdown
