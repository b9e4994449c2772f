// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flow along a path of pieces in series from one cell centre to the next, each piece with its own gap: F = c p - D dp/dx with
// c = U h/2, D = h^2 G/(12 mu). With the integrating factor exp(-Q), Q the integral of c/D from the upstream end,
//
//   p1 - p2 exp(-Q_end) = integral of F w,  w = exp(-Q)/D,
//
// exactly, for any Peclet number and across any step. So where F is constant, F = (p1 - p2 exp(-Q_end))/I, I the integral of w
// (exponential fitting, piece by piece). Where F has the slopes s1 before and s2 after the face, as the flow across the path
// feeds or drains it, the flow at the face is F - s1 m1 - s2 m2, m the first moments of w/I about the face on either side (the
// complete flux scheme: ten Thije Boonkkamp & Anthonissen 2011). That is second order at any Peclet number, and keeps the
// exact boundary layers of exponential fitting.
//
// With r = length/D and q = c r of a piece: phi(q) = (1 - exp(-q))/q, chi(q) = (1 - phi(q))/q, xi = phi - chi.
#pragma once

#include <cmath>

#include "core/numerics/dual.h"

namespace touchdown {

/// phi and chi for q >= 0, with exp(-q).
template <typename Number>
struct PathFunctions {
    Number decay, phi, chi;

    explicit PathFunctions(const Number& q)
    {
        using std::exp;
        decay = exp(-q);
        if (valueOf(q) > 0.05) {
            const Number inverse = Number(1.0) / q;
            phi = (Number(1.0) - decay) * inverse;
            chi = (Number(1.0) - phi) * inverse;
        } else {
            chi = Number(0.5) -
                  q * (Number(1.0 / 6) - q * (Number(1.0 / 24) - q * (Number(1.0 / 120) - q * Number(1.0 / 720))));
            phi = Number(1.0) - q * chi;
        }
    }
};

/// Grows piece by piece from the upstream end.
template <typename Number>
struct PathIntegral {
    Number I{0.0}, R{0.0};            // integrals of w and of 1/D
    Number decay{1.0};                // exp(-Q) so far
    Number before{0.0}, after{0.0};   // of (x - face) w, on either side of the face

    /// A piece `length` long that starts at `start` from the face; it lies on one side of it.
    void add(const Number& r, const Number& q, double start, double length)
    {
        const PathFunctions<Number> f(q);
        const Number weight = decay * r;
        I = I + weight * f.phi;
        R = R + r;
        Number& moment = start < 0.0 ? before : after;
        moment = moment + weight * (Number(start) * f.phi + Number(length) * (f.phi - f.chi));
        decay = decay * f.decay;
    }
};

/// What one or several paths side by side pass: F = A p1 - B p2 along the axis; K = A = B without convection [m^3/s]; the
/// moments below and above the face [m].
template <typename Number>
struct PathFlow {
    Number A{0.0}, B{0.0}, K{0.0}, below{0.0}, above{0.0};

    /// Adds a path of this width that has this share of the face; `against`: upstream is above.
    void add(const PathIntegral<Number>& path, double width, double share, bool against)
    {
        const Number inverse = Number(1.0) / path.I;
        const Number upstream = Number(width) * inverse, downstream = upstream * path.decay;
        A = A + (against ? downstream : upstream);
        B = B + (against ? upstream : downstream);
        K = K + Number(width) / path.R;
        const Number scale = Number(against ? -share : share) * inverse;
        below = below + scale * (against ? path.after : path.before);
        above = above + scale * (against ? path.before : path.after);
    }
};

} // namespace touchdown
