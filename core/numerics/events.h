// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a step leaves the intervals of its mode.
//
// A guard is a polynomial in Bernstein form over a step and lies within the hull of its coefficients. If no coefficient
// leaves the interval, no point of the step does, so a contact that touches and leaves within one step is not missed.
// Otherwise the first crossing is found by halving down to one change of sign, then by Newton's iteration.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/numerics/switched_system.h"

namespace touchdown {

/// The first place in [0, 1] where the polynomial with these Bernstein coefficients falls from >= 0 to below zero, to
/// the last bit. A c[0] below zero counts as a crossing at 0, unless the caller has cleared it.
std::optional<double> firstDescent(const std::array<double, 5>& coefficients);

/// Bernstein coefficients of the guards along a step whose states have the coefficients c: the guards of the
/// coefficients where these are affine functions of q, else what the system says itself.
template <SwitchedSystem System>
std::array<Eigen::Matrix<double, System::guardCount, 1>, 5> guardPath(const System& system,
                                                                      const std::array<typename System::State, 5>& c)
{
    if constexpr (requires { system.guardPath(c); }) {
        return system.guardPath(c);
    } else {
        std::array<Eigen::Matrix<double, System::guardCount, 1>, 5> g;
        for (std::size_t k = 0; k < 5; ++k)
            g[k] = system.guards(c[k].template head<System::State::RowsAtCompileTime / 2>());
        return g;
    }
}

/// A guard leaving its interval.
struct Crossing {
    double at = 0.0; // place in the step, 0..1
    int guard = 0;
    bool upper = false; // through the upper end
};

/// Detects chattering: many switches within one period of the motion.
class ChatterWatch {
public:
    ChatterWatch() { times_.fill(-std::numeric_limits<double>::infinity()); }
    /// True when this switch is the 65th within `period`, the shortest time scale of the motion where it happens [s].
    bool tooMany(double time, double period)
    {
        const double oldest = times_[next_];
        times_[next_] = time;
        next_ = (next_ + 1) % times_.size();
        return time - oldest < period;
    }
    void pass(auto& stream)
    {
        stream(times_, next_);
        next_ %= times_.size();
    }

    static constexpr std::size_t most = 64; // switches within one period

private:
    std::array<double, most> times_;
    std::size_t next_ = 0;
};

/// The mode of a run and its intervals, and the round-off with which a guard is compared with them.
template <SwitchedSystem System>
class GuardWatch {
public:
    static constexpr int half = System::State::RowsAtCompileTime / 2;
    using State = typename System::State;
    using Mode = typename System::Mode;

    GuardWatch(const System& system, Mode mode) : system_(system) { enter(mode); }

    const Mode& mode() const { return mode_; }
    void pass(auto& stream)
    {
        stream(mode_, chatter_);
        enter(mode_);
    }
    void enter(Mode mode)
    {
        mode_ = mode;
        for (int i = 0; i < System::guardCount; ++i)
            intervals_[static_cast<std::size_t>(i)] = system_.interval(i, mode);
    }

    /// Distance of the state from the interval's end [unit of q]; negative outside.
    double inside(const State& y, int guard, bool upper) const
    {
        const double value = system_.guards(y.template head<half>())[guard];
        const Interval& interval = intervals_[static_cast<std::size_t>(guard)];
        return upper ? interval.upper - value : value - interval.lower;
    }
    /// Its rate [unit of q/s].
    double insideRate(const State& y, int guard, bool upper) const
    {
        const double rate = system_.guardRates(y)[guard];
        return upper ? -rate : rate;
    }
    /// Round-off of a guard at this state [unit of q].
    double roundOff(const State& y, int guard) const
    {
        constexpr double few = 16.0 * std::numeric_limits<double>::epsilon();
        const Interval& interval = intervals_[static_cast<std::size_t>(guard)];
        const auto scale = [this] {
            if constexpr (requires { system_.guardScale(); })
                return system_.guardScale();
            else
                return system_.scale();
        }();
        double size =
            y.template head<half>().cwiseAbs().cwiseMax(scale.template head<half>()).dot(system_.guardSizes(guard));
        if (std::isfinite(interval.lower)) size = std::max(size, std::abs(interval.lower));
        if (std::isfinite(interval.upper)) size = std::max(size, std::abs(interval.upper));
        return few * size;
    }

    /// How near to the boundary a state can be placed at this time [s], by round-off of state and time [unit of q].
    double resolution(const State& y, int guard, double time) const
    {
        constexpr double few = 4.0 * std::numeric_limits<double>::epsilon();
        return roundOff(y, guard) + few * time * std::abs(system_.guardRates(y)[guard]);
    }

    /// The first crossing of a step from this time [s] whose Bernstein coefficients are c.
    std::optional<Crossing> first(const std::array<State, 5>& c, double time) const
    {
        const auto g = guardPath(system_, c);
        std::optional<Crossing> found;
        for (int i = 0; i < System::guardCount; ++i) {
            const Interval& interval = intervals_[static_cast<std::size_t>(i)];
            double lowest = g[0][i];
            double highest = lowest;
            for (std::size_t k = 1; k < 5; ++k) {
                lowest = std::min(lowest, g[k][i]);
                highest = std::max(highest, g[k][i]);
            }
            for (const bool upper : {false, true}) {
                if (upper ? highest <= interval.upper : lowest >= interval.lower) continue;
                std::array<double, 5> inside;
                for (std::size_t k = 0; k < 5; ++k)
                    inside[k] = upper ? interval.upper - g[k][i] : g[k][i] - interval.lower;
                // On the boundary, as after a switch: inside unless it moves out.
                if (const double start = inside[0]; std::abs(start) <= resolution(c[0], i, time))
                    for (double& distance : inside) distance -= start;
                const std::optional<double> at = firstDescent(inside);
                if (at && (!found || *at < found->at)) found = Crossing{*at, i, upper};
            }
        }
        return found;
    }

    /// Enters the mode beyond a crossing at `time` [s] and state y, and reports it; false if it chatters.
    template <class Recorder>
    bool cross(double time, int guard, bool upper, const State& y, Recorder& recorder)
    {
        const Mode before = mode_;
        enter(system_.beyond(before, guard, upper));
        recorder.event(time, guard, upper, before, mode_);
        return !chatter_.tooMany(time, system_.period(y, mode_));
    }

private:
    const System& system_;
    Mode mode_;
    std::array<Interval, System::guardCount> intervals_;
    ChatterWatch chatter_;
};

/// Shortens a step that begins at `time` [s] until it ends on a crossing to round-off.
///
/// `take(h)` repeats the step with length h and returns its end state; `h` starts at the crossing of the dense output.
/// Newton's iteration on the length within a bracket. `crossed` becomes false where the step only grazes the boundary.
template <SwitchedSystem System, class Take>
typename System::State endOnCrossing(const GuardWatch<System>& watch, const Crossing& crossing, double time,
                                     double fullLength, double& h, bool& crossed, Take&& take)
{
    double inner = 0.0;        // longest length known to end inside
    double outer = fullLength; // shortest length taken to end outside
    typename System::State y = take(h);
    for (int i = 0; i < 80; ++i) {
        const double distance = watch.inside(y, crossing.guard, crossing.upper);
        if (std::abs(distance) <= watch.roundOff(y, crossing.guard)) break;
        (distance > 0.0 ? inner : outer) = h;
        const double rate = watch.insideRate(y, crossing.guard, crossing.upper);
        const double newton = h - distance / rate;
        const double next = newton > inner && newton < outer && i < 8 ? newton : 0.5 * (inner + outer);
        if (next == h || outer - inner <= std::numeric_limits<double>::epsilon() * outer) break;
        h = next;
        y = take(h);
    }
    crossed = watch.inside(y, crossing.guard, crossing.upper) <= watch.resolution(y, crossing.guard, time + h);
    return y;
}

} // namespace touchdown
