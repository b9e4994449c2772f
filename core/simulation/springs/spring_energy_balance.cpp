// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_energy_balance.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

constexpr double onBoundary = 1e-15; // [m]

} // namespace

void SpringEnergyBalance::begin(const SpringModel::State& y, SpringModel::Mode mode)
{
    time_ = 0.0;
    y_ = y;
    region_ = mode.contact;
    under_ = disk_.at(0.0);
    separation_ = model_.guards(y.head<2>(), under_.height)[SpringModel::Pad];
    start_ = model_.energy(y, under_.height);
    gained_ = {};
    missing_ = 0.0;
    least_ = most_ = {};
}

double SpringEnergyBalance::workAlong(double to)
{
    const PadLaw& law = model_.padLaw();
    double work = 0.0;
    double at = separation_;
    constexpr int mostRegions = 8; // of one step; there are four
    for (int k = 0; k < mostRegions; ++k) {
        const Interval holds = law.interval(region_);
        const double end = std::clamp(to, holds.lower, holds.upper);
        work += law.work(region_, at, end);
        at = end;
        if (end == to) break;
        region_ = law.beyond(region_, to > end);
    }
    separation_ = to;
    return work;
}

void SpringEnergyBalance::add(double time, const SpringModel::State& y, SpringModel::Mode mode)
{
    const double h = time - time_;
    if (!(h > 0.0) || !y.allFinite()) return;
    SpringModel::State middle; // of the cubic through both ends
    middle.head<2>() = 0.5 * (y_.head<2>() + y.head<2>()) + 0.125 * h * (y_.tail<2>() - y.tail<2>());
    middle.tail<2>() = 1.5 / h * (y.head<2>() - y_.head<2>()) - 0.25 * (y_.tail<2>() + y.tail<2>());
    const SpringModel::Under last = disk_.at(time);
    const SpringModel::Powers p0 = model_.powers(y_, mode, under_),
                              p1 = model_.powers(middle, mode, disk_.at(time_ + 0.5 * h)),
                              p2 = model_.powers(y, mode, last);
    const auto simpson = [&](auto part) { return h / 6.0 * (part(p0) + 4.0 * part(p1) + part(p2)); };
    using P = const SpringModel::Powers&;
    gained_[0] += simpson([](P p) { return p.suspension + p.frontDashpot + p.rearDashpot; });
    gained_[2] += simpson([](P p) { return p.friction; });
    gained_[3] += simpson([](P p) { return p.disk; });
    const Interval holds = model_.padLaw().interval(region_);
    // A switch that was located ends a step on the boundary; the next one begins with the law beyond.
    if (std::min(std::abs(separation_ - holds.lower), std::abs(separation_ - holds.upper)) < onBoundary)
        region_ = mode.contact;
    gained_[1] += workAlong(model_.guards(y.head<2>(), last.height)[SpringModel::Pad]);
    const Interval next = model_.padLaw().interval(mode.contact);
    if (separation_ > next.lower - onBoundary && separation_ < next.upper + onBoundary) region_ = mode.contact;
    time_ = time;
    y_ = y;
    under_ = last;
    keep(model_.energy(y, last.height) - start_);
}

void SpringEnergyBalance::keep(double energy)
{
    const std::array<double, 5> parts{energy, gained_[0], gained_[1], gained_[2], gained_[3]};
    for (std::size_t k = 0; k < parts.size(); ++k) {
        least_[k] = std::min(least_[k], parts[k]);
        most_[k] = std::max(most_[k], parts[k]);
    }
    missing_ = std::max(missing_, std::abs(energy - gained_[0] - gained_[1] - gained_[2] - gained_[3]));
}

double SpringEnergyBalance::imbalance() const
{
    double range = 0.0;
    for (std::size_t k = 0; k < least_.size(); ++k) range = std::max(range, most_[k] - least_[k]);
    return range > 1e-12 * model_.energyBound() ? missing_ / range : 0.0; // what stays at rest moves no energy
}

} // namespace touchdown
