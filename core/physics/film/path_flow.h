// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flow along a path of pieces in series from one cell centre to the next, each piece with its own gap: F = c p - D
// dp/dx with c = U h/2, D = h^2 G/(12 mu). With the integrating factor exp(-Q), Q the integral of c/D from the upstream
// end,
//
//   p1 - p2 exp(-Q_end) = integral of F w,  w = exp(-Q)/D,
//
// exactly, for any Peclet number and across any step. For constant F, F = (p1 - p2 exp(-Q_end))/I, I the integral of w
// (exponential fitting). Where F has the slopes s1 before and s2 after the face because of the flow across the path,
// the flow at the face is F - s1 m1 - s2 m2, m the first moments of w/I about the face on either side (the complete
// flux scheme: ten Thije Boonkkamp & Anthonissen 2011). It is second order at any Peclet number, with the exact
// boundary layers of exponential fitting.
//
// Across a slanted wall the pressure depends on the distance n along the normal alone: with F_n = c m_n p - D dp/dn
// constant (m the disk's direction), the flow along the path is n_a F_n + (m_a - n_a m_n) c p, which changes with c.
// With F its value at the shallow end (c there c_s), dp/dx = ((c - (m_a - n_a m_n)(c - c_s)) p - F)/D along the path: a
// wall convects less than its gap, and the rise of pressure across it is that along the normal.
//
// With r = length/D and q = c r of a piece: phi = E_0(q), xi = E_1(q), chi = phi - xi (DecayMoments).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/numerics/convection.h"
#include "core/numerics/dual.h"

namespace touchdown {

/// exp(-z) for z >= 0; beyond 700 that of 700. exp(-z) = 2^n exp(r), |r| <= ln(2)/2, by Taylor's series to r^11.
inline double decay(double z)
{
    constexpr double perLog2 = 1.4426950408889634, log2High = 0x1.62e42fefa3800p-1, log2Low = 0x1.ef35793c76730p-45;
    constexpr double integers = 0x1.8p52; // adding it leaves the nearest integer in the lowest bits
    z = std::min(z, 700.0);
    const double shifted = integers - z * perLog2;
    const double n = shifted - integers;
    const double r = (-z - n * log2High) - n * log2Low;
    const double r2 = r * r, r4 = r2 * r2;
    const double low = (1.0 + r) + r2 * (1.0 / 2 + r * (1.0 / 6));
    const double middle = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
    const double high = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
    const double power = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52);
    return power * (low + r4 * (middle + r4 * high));
}

/// The moments of exp(-z s) over 0 <= s <= 1, what convection and diffusion through a layer need:
///
///   E_k(z) = integral of s^k exp(-z s) ds,   dE_k/dz = -E_(k+1),   z E_k = k E_(k-1) - exp(-z)  (z E_0 = 1 - exp(-z)).
///
/// Relative errors below 2e-13 (exp: 1e-14). Without branches or calls, so that loops over many z run on vectors.
struct DecayMoments {
    double decay, e0, e1, e2; // exp(-z), E_0, E_1, E_2
};

inline DecayMoments decayMoments(double z)
{
    constexpr double small = 0.125;
    DecayMoments m;
    m.decay = decay(z);
    // E_2 first, by the upward recursion or a series where that cancels; E_1, E_0 downwards have positive terms.
    const double inverse = 1.0 / std::max(z, small);
    const double upwards = (2.0 * ((1.0 - m.decay) * inverse - m.decay) * inverse - m.decay) * inverse;
    const double series =
        1.0 / 3 -
        z * (1.0 / 4 - z * (1.0 / 10 -
                            z * (1.0 / 36 - z * (1.0 / 168 - z * (1.0 / 960 - z * (1.0 / 6480 - z * (1.0 / 50400)))))));
    m.e2 = z > small ? upwards : series;
    m.e1 = 0.5 * (z * m.e2 + m.decay);
    m.e0 = z * m.e1 + m.decay;
    return m;
}

/// The same for any z, also without branches.
inline DecayMoments signedDecayMoments(double z)
{
    const DecayMoments m = decayMoments(std::abs(z));
    const bool grows = z < 0.0;
    const double growth = grows ? 1.0 / m.decay : 1.0;
    return {grows ? growth : m.decay, growth * m.e0, growth * (grows ? m.e0 - m.e1 : m.e1),
            growth * (grows ? m.e0 - 2.0 * m.e1 + m.e2 : m.e2)};
}

inline constexpr double closedGap = 1e-12; // a gap below this passes no air [m]

/// Of a piece's q, with exp(-q).
template <typename Number>
struct PathFunctions {
    Number decay, phi, chi, xi;

    /// For q >= 0. At a slanted wall q may be below zero: then with signedDecayMoments(q).
    explicit PathFunctions(const Number& q) : PathFunctions(q, decayMoments(valueOf(q))) {}
    PathFunctions(const Number& q, const DecayMoments& m)
    {
        if constexpr (std::is_same_v<Number, double>) {
            decay = m.decay;
            phi = m.e0;
            chi = m.e0 - m.e1;
            xi = m.e1;
        } else {
            decay = q.chain(m.decay, -m.decay);
            phi = q.chain(m.e0, -m.e1);
            chi = q.chain(m.e0 - m.e1, m.e2 - m.e1);
            xi = q.chain(m.e1, -m.e2);
        }
    }
};

/// Grows piece by piece from the upstream end.
template <typename Number>
struct PathIntegral {
    Number I{0.0}, R{0.0};          // integrals of w and of 1/D
    Number decay{1.0};              // exp(-Q) so far
    Number before{0.0}, after{0.0}; // of (x - face) w, on either side of the face

    /// A piece with r = length/D and q = c r on one side of the face. Where the flow across is spread evenly, `lead` is
    /// the start of the piece from the face and `feed` its length; else as in GapPiece [m].
    void add(const Number& r, const Number& q, double lead, double feed)
    {
        const PathFunctions<Number> f(q, signedDecayMoments(valueOf(q)));
        I = I + decay * (r * f.phi);
        R = R + r;
        const Number part = decay * (r * (lead * f.phi + feed * f.xi));
        before = before + select(lead < 0.0, part, Number(0.0));
        after = after + select(lead < 0.0, Number(0.0), part);
        decay = decay * f.decay;
    }
};

/// Flow through one or several parallel paths: F = A p1 - B p2 along the axis; K = A = B without convection [m^3/s];
/// the moments below and above the face [m].
template <typename Number>
struct PathFlow {
    Number A{0.0}, B{0.0}, K{0.0}, below{0.0}, above{0.0};

    /// Adds a path of this width that has this share of the face; `against`: upstream is above.
    void add(const PathIntegral<Number>& path, double width, double share, bool against)
    {
        const Number inverse = 1.0 / path.I;
        const Number upstream = width * inverse, downstream = upstream * path.decay;
        A = A + select(against, downstream, upstream);
        B = B + select(against, upstream, downstream);
        K = K + width / path.R;
        const Number scale = (against ? -share : share) * inverse;
        below = below + scale * select(against, path.after, path.before);
        above = above + scale * select(against, path.before, path.after);
    }
};

/// A smooth path across a face; a closed gap passes nothing.
struct SmoothPath {
    double length, lowerShare, width; // [m], share of the length below the face, [m]
};

/// Speed: that of the disk along the axis, halved [m/s]; the mobility G at the path's mean pressure.
///
/// `tilt` is the change of the gap along the path against its middle value, e = (h2 - h1)/h, -1 to 1. Convection
/// carries p h: with v = p h, F = (U/2 + D h'/h^2) v - (D/h) dv/dx has constant coefficients, so that F = (v1 - v2
/// exp(-Q - e))/(h (R/L) integral of exp(-(Q + e) x/L)). To first order in e, with an error of second order: I - e int
/// (x/L) w for I, upstream gap (1 - e/2) h.
template <ConvectionScheme scheme, typename Number>
PathFlow<Number> smoothFlow(const SmoothPath& path, double viscosity, double speed, const Number& gap,
                            const Number& tilt, const Number& mobility)
{
    const bool open = valueOf(gap) > closedGap;
    const double width = open ? path.width : 0.0;
    const Number h = select(open, gap, Number(1.0));
    const Number R = 12.0 * viscosity * path.length / (h * h * mobility); // of a width of 1
    PathFlow<Number> flow;
    if constexpr (scheme == ConvectionScheme::CompleteFlux || scheme == ConvectionScheme::Exponential) {
        const bool against = speed < 0.0;
        const double before = against ? 1.0 - path.lowerShare : path.lowerShare, after = 1.0 - before;
        const Number q = std::abs(speed) * h * R;
        const PathFunctions<Number> first(before * q), second(after * q);
        PathIntegral<Number> integral;
        integral.I = R * (before * first.phi + after * first.decay * second.phi);
        integral.R = R;
        integral.decay = first.decay * second.decay;
        integral.before = -before * before * path.length * R * first.chi;
        integral.after = after * after * path.length * R * first.decay * second.xi;
        const Number e = (against ? -1.0 : 1.0) * tilt; // downstream
        integral.I = integral.I - e * ((1.0 / path.length) * (integral.before + integral.after) + before * integral.I);
        flow.add(integral, width, open ? 1.0 : 0.0, against);
        const Number upstreamGap = Number(1.0) - 0.5 * e; // against the middle one
        flow.A = flow.A * upstreamGap;
        flow.B = flow.B * upstreamGap;
    } else {
        flow.K = width / R;
        const Number convection = speed * width * h;
        const EffectiveConductance e = effectiveConductance<scheme>(valueOf(flow.K), valueOf(convection));
        Number E(e.value);
        if constexpr (!std::is_same_v<Number, double>)
            E = flow.K.chain(e.value, e.byDiffusion) + convection.chain(0.0, e.byConvection);
        flow.A = E + 0.5 * convection;
        flow.B = E - 0.5 * convection;
    }
    return flow;
}

} // namespace touchdown
