// SPDX-License-Identifier: GPL-3.0-or-later
//
// The infinitely wide plane slider, solved without any code of the film's: a reference for its models and schemes.
//
// In units of the outlet's gap h0, the ambient pressure p0 and the length L, with X = 0 at the inlet, H = 2 - X (inlet
// gap twice the outlet's) or any other, and Lambda = 6 mu U L/(p0 h0^2), the mass flow through each section is the
// same:
//
//   H^2 G(P H) dP/dX - Lambda P H = C,   P(0) = P(1) = 1,   G(w) = w Q(Kn0/w).
//
// Shooting for C from the outlet to the inlet, in which direction all solutions of the equation come together;
// classical Runge-Kutta method, secant method for C. The error falls with the fourth power of the steps.
#pragma once

#include <cmath>

namespace touchdown::test {

struct WideSlider {
    double load = 0.0;     // int (P - 1) dX
    double flow = 0.0;     // C
    double mismatch = 0.0; // P(0) - 1
};

/// `mobility(w)` is G in units of p0 h0; `gap(X)` is H.
template <typename MobilityLaw, typename Gap>
WideSlider wideSlider(double bearingNumber, const MobilityLaw& mobility, int steps, const Gap& gap)
{
    const auto shoot = [&](double flow) {
        const auto slope = [&](double x, double p) {
            const double h = gap(x);
            return (bearingNumber * p * h + flow) / (h * h * mobility(p * h));
        };
        const double dx = -1.0 / steps;
        double p = 1.0, load = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double x = 1.0 + i * dx;
            const double k1 = slope(x, p), p2 = p + 0.5 * dx * k1;
            const double k2 = slope(x + 0.5 * dx, p2), p3 = p + 0.5 * dx * k2;
            const double k3 = slope(x + 0.5 * dx, p3), p4 = p + dx * k3;
            const double k4 = slope(x + dx, p4);
            load -= dx / 6.0 * (p + 2.0 * p2 + 2.0 * p3 + p4 - 6.0); // the same method for d(load)/dX = P - 1
            p += dx / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
        return WideSlider{load, flow, p - 1.0};
    };
    // Without diffusion the flow would be that of the inlet, 2 Lambda; with much of it, that of a mean gap.
    WideSlider a = shoot(-1.5 * bearingNumber), b = shoot(-1.6 * bearingNumber);
    for (int i = 0; i < 30 && std::abs(b.mismatch) > 1e-13 && b.mismatch != a.mismatch; ++i) {
        const WideSlider next = shoot(b.flow - b.mismatch * (b.flow - a.flow) / (b.mismatch - a.mismatch));
        a = b;
        b = next;
    }
    return b;
}
template <typename MobilityLaw>
WideSlider wideSlider(double bearingNumber, const MobilityLaw& mobility, int steps)
{
    return wideSlider(bearingNumber, mobility, steps, [](double x) { return 2.0 - x; });
}

} // namespace touchdown::test
