// SPDX-License-Identifier: GPL-3.0-or-later
//
// An oscillator with one elastic stop over a waving ground: as a case of springs, and its motions by piecewise exact
// solution (Shaw & Holmes, J. Sound Vib. 90 (1983) 129-155). In units of 1/omega_0 and of the wave's amplitude, with x
// towards the stop,
//
//   x'' + 2 zeta x' + x + kappa (x - g) [x > g] = W^2 sin(W t + phi)
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <Eigen/LU>

#include "core/case/case.h"

namespace touchdown::test {

struct ImpactOscillator {
    double zeta = 0.05;
    double kappa = 2.0; // stiffness of the stop, in that of the spring
    double gap = 3.0;   // g

    static constexpr double frequency = 100e3; // omega_0/(2 pi) [Hz]
    static constexpr double wave = 100e-9;     // its amplitude [m]
    static constexpr double length = 0.125e-3; // of the wave [m]
    static constexpr double height = 10e-3;    // above the ground; the springs are linear to wave/height [m]

    /// Two equal air springs, four waves before and behind the pad, which is in the middle: no pitch.
    Case slider() const
    {
        Case c;
        const double omega = 2.0 * std::numbers::pi * frequency, stiffness = c.slider.mass * omega * omega;
        c.springs = {.frontStiffness = 0.5 * stiffness,
                     .rearStiffness = 0.5 * stiffness,
                     .frontDistance = 0.5e-3,
                     .rearDistance = 0.5e-3,
                     .frontDampingRatio = zeta / std::sqrt(2.0), // 2 xi sqrt(M k/2) each, together 2 zeta sqrt(M k)
                     .rearDampingRatio = zeta / std::sqrt(2.0),
                     .cutoff = 1e-9,
                     .flyingHeight = height,
                     .pitch = 0.0,
                     .potential = PotentialBelowCutoff::Held};
        c.suspension.stiffness = 0.0;
        c.onoYamane.meniscusForce = c.onoYamane.friction = c.springs.padDistance = 0.0;
        c.onoYamane.initialContactForce = 0.0;
        c.onoYamane.touchDown = c.onoYamane.takeOff = height - gap * wave;
        c.onoYamane.contactStiffness = kappa * stiffness;
        c.initial.flyingHeight = height;
        c.initial.pitch = 0.0;
        return c;
    }

    using Pair = std::array<double, 2>; // x, x'
    /// From t0 to t1 with the stiffness k, the constant force c and the force a sin(W t) + b cos(W t).
    Pair moved(double k, double t0, double t1, Pair at, double c, double a, double b, double w) const
    {
        const std::complex<double> h = 1.0 / std::complex<double>(k - w * w, 2.0 * zeta * w);
        const auto forced = [&](double t) -> Pair {
            const std::complex<double> e = h * std::polar(1.0, w * t), de = std::complex<double>(0.0, w) * e;
            return {a * e.imag() + b * e.real() + c / k, a * de.imag() + b * de.real()};
        };
        const Pair p0 = forced(t0), p1 = forced(t1);
        const double wd = std::sqrt(k - zeta * zeta), t = t1 - t0, decay = std::exp(-zeta * t), x = at[0] - p0[0],
                     v = at[1] - p0[1], cosine = std::cos(wd * t), sine = std::sin(wd * t) / wd;
        return {p1[0] + decay * (x * (cosine + zeta * sine) + v * sine),
                p1[1] + decay * (v * (cosine - zeta * sine) - k * x * sine)};
    }

    /// The speed of impact and the force F of the motion of one period with one impact that lasts the share s of it.
    struct Orbit {
        double speed, force;
    };
    Orbit orbit(double w, double s) const
    {
        const double period = 2.0 * std::numbers::pi / w, held = s * period;
        const auto residual = [&](const Eigen::Vector3d& u) { // of the speed and the parts of the force
            const Pair out = moved(1.0 + kappa, 0.0, held, {gap, u[0]}, kappa * gap, u[1], u[2], w);
            const Pair back = moved(1.0, held, period, out, 0.0, u[1], u[2], w);
            return Eigen::Vector3d(out[0] - gap, back[0] - gap, back[1] - u[0]);
        };
        const Eigen::Vector3d none = residual(Eigen::Vector3d::Zero());
        Eigen::Matrix3d slope;
        for (int k = 0; k < 3; ++k) slope.col(k) = residual(Eigen::Vector3d::Unit(k)) - none;
        const Eigen::Vector3d u = slope.fullPivLu().solve(-none);
        return {u[0], std::hypot(u[1], u[2])};
    }

    /// Shares of the period that the impacts of motions with the force W^2 last, by bisection between 400 values.
    std::vector<double> shares(double w) const
    {
        constexpr int values = 400;
        std::vector<double> found;
        const auto excess = [&](double s) { return orbit(w, s).force - w * w; };
        const auto at = [](int k) { return 0.002 + 0.948 * k / (values - 1); };
        for (int k = 0; k + 1 < values; ++k) {
            double low = at(k), high = at(k + 1);
            const double first = excess(low), last = excess(high);
            const bool pole = std::abs(first - last) > 2.0 * w * w || orbit(w, low).speed < 0.0;
            if (first * last > 0.0 || pole) continue;
            for (int turn = 0; turn < 50; ++turn) {
                const double middle = 0.5 * (low + high);
                (excess(middle) * first > 0.0 ? low : high) = middle;
            }
            found.push_back(low);
        }
        return found;
    }

    /// Trace and determinant of M, the derivative of the motion over one period. The force of the stop begins at zero,
    /// so that the switches leave M as it is.
    std::array<double, 2> invariants(double w, double s) const
    {
        const double period = 2.0 * std::numbers::pi / w;
        Eigen::Matrix2d held, free;
        for (int k = 0; k < 2; ++k) {
            const Pair unit{k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0};
            const Pair a = moved(1.0 + kappa, 0.0, s * period, unit, 0.0, 0.0, 0.0, w);
            const Pair b = moved(1.0, s * period, period, unit, 0.0, 0.0, 0.0, w);
            held.col(k) << a[0], a[1];
            free.col(k) << b[0], b[1];
        }
        const Eigen::Matrix2d all = free * held;
        return {all.trace(), all.determinant()};
    }
    /// tr M/(1 + det M): -1 where a multiplier is -1, and between -1 and 1 where the motion is stable.
    double traceRatio(double w, double s) const
    {
        const auto [trace, determinant] = invariants(w, s);
        return trace / (1.0 + determinant);
    }

    /// The frequency above the resonance at which the motion without an impact grazes the stop, in omega_0.
    double grazing() const
    {
        // g^2 ((1 - q)^2 + 4 zeta^2 q) = q^2 with q = W^2; the smaller root of 1/q is above the resonance.
        const double a = 1.0, b = 4.0 * zeta * zeta - 2.0, c = 1.0 - 1.0 / (gap * gap);
        return 1.0 / std::sqrt((-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a));
    }

    /// The frequency at which the motion with impacts ends, in omega_0; 0 where it ends at the grazing.
    double fold() const
    {
        double low = 1.0005 * grazing(), high = low;
        const auto isThere = [&](double w) { return shares(w).size() >= 2; };
        if (!isThere(low)) return 0.0;
        for (; isThere(high); high *= 1.01) low = high;
        for (int turn = 0; turn < 40; ++turn) {
            const double middle = 0.5 * (low + high);
            (isThere(middle) ? low : high) = middle;
        }
        return low;
    }

    /// The frequency between two at which traceRatio passes -1 on the motion with one impact, in omega_0; 0 for none.
    double doubling(double low, double high) const
    {
        const auto beyond = [&](double w) {
            const std::vector<double> s = shares(w);
            return s.size() == 1 && traceRatio(w, s.front()) < -1.0;
        };
        if (beyond(low) || !beyond(high)) return 0.0;
        for (int turn = 0; turn < 40; ++turn) {
            const double middle = 0.5 * (low + high);
            (beyond(middle) ? high : low) = middle;
        }
        return low;
    }
};

} // namespace touchdown::test
