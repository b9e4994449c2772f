// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy balance of a spring run. Slider, air springs and suspension hold an energy E (equation (5), held below
// d_1). They gain energy
//
//   by the dashpots            a negative amount, by Simpson's rule along each step, as all integrals over time
//   by contact and adhesion    int F_c dd along the way of the pad, through the regions of the law as it passes them
//   by friction                -(b/2) mu int F_cr theta' dt
//   by a surface that moves    int (F_f w_f' + F_r w_r' + F_c w') dt
//
// so that E - gained is constant to the integrator's error. The contact's work follows the way of the pad against the
// disk, not the law that a step used: a missed switch causes an imbalance.
#pragma once

#include <array>

#include "core/simulation/springs/disk_under_springs.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

class SpringEnergyBalance {
public:
    /// Model and disk must last.
    SpringEnergyBalance(const SpringModel& model, const DiskUnderSprings& disk) : model_(model), disk_(disk) {}

    void begin(const SpringModel::State& y, SpringModel::Mode mode);
    /// After a step to `time` [s] in `mode`, or ending in it where a step chooses its laws itself.
    void add(double time, const SpringModel::State& y, SpringModel::Mode mode);

    /// The largest energy imbalance so far, against the largest change of a part [-].
    double imbalance() const;
    void pass(auto& stream)
    {
        stream(time_, y_, under_, region_, separation_, start_, gained_, missing_, least_, most_);
    }

private:
    /// Work of contact and adhesion on the pad along the way to separation `to` [J].
    double workAlong(double to);
    void keep(double energy);

    const SpringModel& model_;
    const DiskUnderSprings& disk_;
    double time_ = 0.0;
    SpringModel::State y_;
    SpringModel::Under under_;                    // at time_
    ContactRegion region_ = ContactRegion::Apart; // as the way has come
    double separation_ = 0.0;
    double start_ = 0.0;                     // E at the beginning [J]
    std::array<double, 4> gained_{};         // by dashpots, contact, friction, disk [J]
    double missing_ = 0.0;                   // the largest so far [J]
    std::array<double, 5> least_{}, most_{}; // of E - E(0) and of what is gained [J]
};

} // namespace touchdown
