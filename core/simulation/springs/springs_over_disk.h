// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spring model over a surface that moves with the disk, as the integrators ask (core/numerics/switched_system.h).
//
// The time is a coordinate of the state, y = (z, theta, t, z', theta', 1). The spacings are no affine functions of it:
// along a step each is the step's own polynomial less the heights of the disk, which are interpolated by the polynomial
// of degree 4 through heights and rates at both ends and the height in the middle. For a wave of amplitude a and
// angular frequency w over a step h it is off by at most 7.5e-5 (w h)^5 a (the largest value of x^2 (1 - x)^2 (x -
// 1/2)/5! on [0, 1]): 7e-7 a where a sixteenth of the wave passes. So much a contact may dip in and be missed. Where a
// step ends on a switch, the exact heights count.
#pragma once

#include <array>

#include "core/simulation/springs/disk_under_springs.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

struct IntegrationResult; // core/numerics/switched_system.h
class SpringRecorder;

class SpringsOverDisk {
public:
    using State = Eigen::Matrix<double, 6, 1>; // z [m], theta [rad], t [s], z' [m/s], theta' [rad/s], 1
    using Mode = SpringModel::Mode;
    using Guards = SpringModel::Guards;
    static constexpr int guardCount = SpringModel::guardCount;

    /// Model (flat) and disk must last. `duration` of the run [s].
    SpringsOverDisk(const SpringModel& model, const DiskUnderSprings& disk, double duration)
        : model_(model), disk_(disk), time_(duration + disk.passage())
    {}

    static SpringModel::State motionOf(const State& y) { return SpringModel::motionOf(y); }
    State initialState() const { return stateOf(model_.initialState(), 0.0, 1.0); }
    Mode initialMode() const { return model_.initialMode(disk_.at(0.0).height); }

    State derivative(const State& y, Mode mode) const
    {
        return stateOf(model_.derivative(motionOf(y), mode, disk_.at(y[2])), y[5], 0.0);
    }
    State naiveDerivative(const State& y, Mode mode) const
    {
        return stateOf(model_.naiveDerivative(motionOf(y), mode, disk_.at(y[2])), y[5], 0.0);
    }
    Mode naiveMode(const State& y, Mode mode) const
    {
        return model_.naiveMode(motionOf(y), mode, disk_.at(y[2]).height);
    }
    Guards guards(const Eigen::Vector3d& q) const { return model_.guards(q.head<2>(), disk_.at(q[2]).height); }
    Guards guardRates(const State& y) const { return model_.ratesOf({y[3], y[4]}) - disk_.at(y[2]).rate; }
    std::array<Guards, 5> guardPath(const std::array<State, 5>& c) const;
    Eigen::RowVector3d guardSizes(int guard) const
    {
        const Eigen::RowVector2d sizes = model_.guardSizes(guard);
        return {sizes[0], sizes[1], disk_.fastestRate()};
    }
    Interval interval(int guard, Mode mode) const { return model_.interval(guard, mode); }
    Mode beyond(Mode mode, int guard, bool upper) const { return model_.beyond(mode, guard, upper); }
    bool isWall(int guard) const { return model_.isWall(guard); }
    State scale() const { return stateOf(model_.scale(), time_, 1.0); }
    /// Its switches are located as in a run of any other duration.
    State guardScale() const { return stateOf(model_.scale(), disk_.passage(), 1.0); }
    double longestStep() const { return disk_.longestStep(); }
    /// Also a wave of the disk may switch the contact on and off.
    double period(const State& y, Mode mode) const;
    double energy(const State& y) const { return model_.energy(motionOf(y), disk_.at(y[2]).height); }
    double power(const State& y, Mode mode) const { return model_.powers(motionOf(y), mode, disk_.at(y[2])).sum(); }
    /// Derivatives of (z'', theta'', 0) by the state. Those by the time are left out: time itself is never corrected.
    Eigen::Matrix<double, 3, 6> jacobian(const State& y, Mode mode) const;

private:
    static State stateOf(const SpringModel::State& motion, double time, double rate)
    {
        State y;
        y << motion[0], motion[1], time, motion[2], motion[3], rate;
        return y;
    }

    const SpringModel& model_;
    const DiskUnderSprings& disk_;
    double time_; // size of a time, for its round-off [s]
};

/// A run of the case from its start to its end: the recorder has begun and takes the steps; `step` [s] is for
/// fixed-step integrators.
IntegrationResult integrateOverDisk(const SpringModel& model, const DiskUnderSprings& disk, const Case& c, double step,
                                    SpringRecorder& recorder);

} // namespace touchdown
