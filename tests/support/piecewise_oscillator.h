// SPDX-License-Identifier: GPL-3.0-or-later
//
// One degree of freedom, one switch at q = 0, and an exact solution:
//
//   q" = upper.force - upper.stiffness q - upper.damping q'   for q > 0, likewise `lower` for q < 0.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Core>

#include "core/numerics/switched_system.h"

namespace touchdown::test {

struct PiecewiseOscillator {
    struct Law {
        double force = 0.0;     // [m/s^2]
        double stiffness = 0.0; // [1/s^2]
        double damping = 0.0;   // [1/s]
    };
    enum class Mode { Upper, Lower };
    using State = Eigen::Vector2d;
    static constexpr int guardCount = 1;

    Law upper;
    Law lower;
    bool switches = true; // false: the upper law everywhere
    bool wall = false;

    const Law& law(Mode mode) const { return mode == Mode::Upper ? upper : lower; }
    State derivative(const State& y, Mode mode) const
    {
        return {y[1], law(mode).force - law(mode).stiffness * y[0] - law(mode).damping * y[1]};
    }
    Mode naiveMode(const State& y, Mode) const { return switches && y[0] < 0.0 ? Mode::Lower : Mode::Upper; }
    State naiveDerivative(const State& y, Mode mode) const { return derivative(y, naiveMode(y, mode)); }
    Eigen::Matrix<double, 1, 2> jacobian(const State&, Mode mode) const
    {
        return {-law(mode).stiffness, -law(mode).damping};
    }
    Eigen::Matrix<double, 1, 1> guards(const Eigen::Matrix<double, 1, 1>& q) const { return q; }
    Eigen::Matrix<double, 1, 1> guardRates(const State& y) const { return y.tail<1>(); }
    Eigen::Matrix<double, 1, 1> guardSizes(int) const { return Eigen::Matrix<double, 1, 1>(1.0); }
    Interval interval(int, Mode mode) const
    {
        if (!switches) return {};
        return mode == Mode::Upper ? Interval{.lower = 0.0} : Interval{.upper = 0.0};
    }
    Mode beyond(Mode, int, bool throughUpper) const { return throughUpper ? Mode::Upper : Mode::Lower; }
    State scale() const { return {1.0, 1.0}; }
    bool isWall(int) const { return wall; }
    double period(const State&, Mode) const { return 1.0; }
    double energy(const State& y) const
    {
        const Law& at = naiveMode(y, Mode::Upper) == Mode::Upper ? upper : lower;
        return 0.5 * y[1] * y[1] + 0.5 * at.stiffness * y[0] * y[0] - at.force * y[0];
    }
    double power(const State& y, Mode mode) const { return -law(mode).damping * y[1] * y[1]; }

    /// The exact state a time t after y under one law (stiffness > 0).
    static State exact(const Law& law, const State& y, double t)
    {
        // q = q_e + Re[...] by the two roots s of s^2 + damping s + stiffness = 0; complex arithmetic covers all cases
        // but the double root.
        const double rest = law.force / law.stiffness;
        const std::complex<double> root =
            std::sqrt(std::complex<double>(0.25 * law.damping * law.damping - law.stiffness));
        const std::complex<double> s1 = -0.5 * law.damping + root;
        const std::complex<double> s2 = -0.5 * law.damping - root;
        const std::complex<double> c1 = (y[1] - s2 * (y[0] - rest)) / (s1 - s2);
        const std::complex<double> c2 = (y[0] - rest) - c1;
        const std::complex<double> e1 = c1 * std::exp(s1 * t);
        const std::complex<double> e2 = c2 * std::exp(s2 * t);
        return {rest + (e1 + e2).real(), (s1 * e1 + s2 * e2).real()};
    }
};

/// One law everywhere.
inline PiecewiseOscillator smoothOscillator(const PiecewiseOscillator::Law& law)
{
    return {.upper = law, .lower = law, .switches = false, .wall = false};
}
/// A law above and one below zero.
inline PiecewiseOscillator switchedOscillator(const PiecewiseOscillator::Law& upper,
                                              const PiecewiseOscillator::Law& lower, bool wall = false)
{
    return {.upper = upper, .lower = lower, .switches = true, .wall = wall};
}

/// Keeps nothing, so that what allocates is the integrator.
struct EventCount {
    template <class Mode, class At>
    bool step(double, const PiecewiseOscillator::State&, Mode, At&&)
    {
        return true;
    }
    template <class Mode>
    void event(double, int, bool, Mode, Mode)
    {
        ++events;
    }
    int events = 0;
};

/// Keeps all that an integrator tells.
struct Log {
    struct Event {
        double time;
        int guard;
        bool upper;
    };
    std::vector<double> times;
    std::vector<PiecewiseOscillator::State> states;
    std::vector<Event> events;
    std::vector<double> askedTimes; // of the dense output, ascending
    std::vector<PiecewiseOscillator::State> dense;

    template <class Mode, class At>
    bool step(double t, const PiecewiseOscillator::State& y, Mode, At&& at)
    {
        while (dense.size() < askedTimes.size() && askedTimes[dense.size()] <= t)
            dense.push_back(at(askedTimes[dense.size()]));
        times.push_back(t);
        states.push_back(y);
        return times.size() < stopAfter;
    }
    template <class Mode>
    void event(double t, int guard, bool upper, Mode, Mode)
    {
        events.push_back({t, guard, upper});
    }
    const PiecewiseOscillator::State& last() const { return states.back(); }
    std::size_t stopAfter = static_cast<std::size_t>(-1);
};

/// Observed order between two errors of a step and its half.
inline double observedOrder(double error, double errorOfHalf) { return std::log2(error / errorOfHalf); }

} // namespace touchdown::test
