// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/adhesive_cell.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"

namespace touchdown {
namespace {

constexpr std::size_t lanes = 8;
constexpr int mostNearSteps = 50;
constexpr double settledShare = 1e-4; // of the peak gap: the next step of Newton's method would be its square

/// Of lanes on the near branch and what they start from: g - c f(g) = v. The left side rises and is concave, so that
/// Newton's method passes the root at most once, to its left.
struct NearLanes {
    double v[lanes], gap[lanes], pressure[lanes], slope[lanes];
};

TOUCHDOWN_VECTOR_CLONES void solveNear(const AdhesionLaw::Shifted& law, double c, double peak, NearLanes& near)
{
    for (int step = 0; step < mostNearSteps; ++step) {
        double farthest[lanes];
#pragma GCC ivdep
        for (std::size_t k = 0; k < lanes; ++k) {
            const AdhesionLaw::Sample f = law.sample(near.gap[k]);
            double next = near.gap[k] - (near.gap[k] - c * f.pressure - near.v[k]) / (1.0 - c * f.derivative);
            next = next < 0.0 ? 0.0 : next > peak ? peak : next;
            farthest[k] = std::abs(next - near.gap[k]);
            near.gap[k] = next;
        }
        double most = 0.0;
        for (std::size_t k = 0; k < lanes; ++k) most = farthest[k] > most ? farthest[k] : most;
        if (most <= settledShare * peak) break;
    }
#pragma GCC ivdep
    for (std::size_t k = 0; k < lanes; ++k) {
        const AdhesionLaw::Sample f = law.sample(near.gap[k]);
        near.pressure[k] = f.pressure;
        near.slope[k] = f.derivative;
    }
}

TOUCHDOWN_VECTOR_CLONES void addPressures(const AdhesionLaw::Shifted& law, double peak, double attraction,
                                          std::size_t cells, const double* gap, double* offset)
{
    std::size_t at = 0;
    const auto visit = [&](std::size_t i) {
        const double g = gap[i] > peak ? gap[i] : peak;
        const double pressure = law.sample(g).pressure + attraction;
        offset[i] = gap[i] > peak ? pressure : 0.0;
    };
    for (; at + lanes <= cells; at += lanes)
#pragma GCC ivdep
        for (std::size_t k = 0; k < lanes; ++k) visit(at + k);
    for (; at < cells; ++at) visit(at);
}

} // namespace

AdhesiveCell::AdhesiveCell(const AdhesionLaw& law, double compliance, double hardness)
    : law_(law),
      compliance_(compliance),
      closed_(law.pressure(0.0)),
      farLine_(law.peakGap() + compliance * law.peakAttraction())
{
    if (hardness > 0.0) ceiling_ = closed_ + hardness;
}

AdhesiveCell::Tangent AdhesiveCell::tangent(double gap, double pressure, double offset) const
{
    const double c = compliance_;
    const double v = gap - c * (pressure - offset); // as if the law were not offset
    if (v >= farLine_) return {State::Far, std::max(gap, law_.peakGap()), offset - law_.peakAttraction(), 0.0};
    if (v <= -c * ceiling_) return {State::Flowed, gap, ceiling_ + offset, 0.0};
    if (v <= -c * closed_) return {State::Contact, 0.0, pressure, 0.0};
    // g - c f(g) = v, whose left side rises with a slope of at least 1: Newton's method within bounds, from the present
    // gap. The result is always on the law; close to the solution one step is exact to rounding.
    double lower = 0.0, upper = law_.peakGap();
    double g = std::clamp(gap, lower, upper);
    AdhesionLaw::Sample f = law_.sample(g);
    for (int i = 0; i < 50; ++i) {
        const double rest = g - c * f.pressure - v;
        (rest > 0.0 ? upper : lower) = g;
        double next = g - rest / (1.0 - c * f.derivative);
        if (!(next >= lower && next <= upper)) next = 0.5 * (lower + upper);
        const bool settled = std::abs(next - g) <= 1e-4 * law_.peakGap();
        g = next;
        f = law_.sample(g);
        if (settled) break;
    }
    return {State::Near, g, f.pressure + offset, std::max(-f.derivative, 0.0)};
}

void AdhesiveCell::tangents(std::span<const double> gap, std::span<const double> pressure,
                            std::span<const double> offset, Tangents& out) const
{
    const double c = compliance_, peak = law_.peakGap();
    const auto set = [&](std::size_t i) {
        const Tangent one = tangent(gap[i], pressure[i], offset[i]);
        out.state[i] = one.state;
        out.gap[i] = one.gap;
        out.pressure[i] = one.pressure;
        out.stiffness[i] = one.state == State::Contact ? std::numeric_limits<double>::infinity() : one.stiffness;
    };
    std::size_t at = 0;
    for (; law_.isShifted() && at + lanes <= gap.size(); at += lanes) {
        NearLanes near;
        bool any = false;
        for (std::size_t k = 0; k < lanes; ++k) {
            near.v[k] = gap[at + k] - c * (pressure[at + k] - offset[at + k]);
            near.gap[k] = std::clamp(gap[at + k], 0.0, peak);
            const bool isNear = near.v[k] > -c * closed_ && near.v[k] < farLine_;
            // Others need no step.
            if (!isNear) near.v[k] = near.gap[k] = 0.0;
            any = any || isNear;
        }
        if (any) solveNear(law_.shifted(), c, peak, near);
        for (std::size_t k = 0; k < lanes; ++k) {
            const std::size_t i = at + k;
            const double v = gap[i] - c * (pressure[i] - offset[i]);
            if (!(v > -c * closed_ && v < farLine_)) {
                set(i);
                continue;
            }
            out.state[i] = State::Near;
            out.gap[i] = near.gap[k];
            out.pressure[i] = near.pressure[k] + offset[i];
            out.stiffness[i] = std::max(-near.slope[k], 0.0);
        }
    }
    for (; at < gap.size(); ++at) set(at);
}

void AdhesiveCell::offsets(std::span<const double> gap, std::span<double> offset) const
{
    if (law_.isShifted())
        addPressures(law_.shifted(), law_.peakGap(), law_.peakAttraction(), gap.size(), gap.data(), offset.data());
    else
        for (std::size_t i = 0; i < gap.size(); ++i) offset[i] = this->offset(gap[i]);
}

double AdhesiveCell::energy(double gap) const
{
    const double flowed = gap < 0.0 && std::isfinite(ceiling_) ? -ceiling_ * gap : 0.0;
    return law_.energy(gap) + flowed;
}

double AdhesiveCell::gapUnder(double pressure, double offset) const
{
    const double q = pressure - offset;
    if (q >= closed_) return 0.0;
    double lower = 0.0, upper = law_.peakGap();
    if (q <= -law_.peakAttraction()) return upper;
    double g = 0.0;
    for (int i = 0; i < 50; ++i) {
        const AdhesionLaw::Sample f = law_.sample(g);
        (f.pressure > q ? lower : upper) = g;
        double next = g - (f.pressure - q) / f.derivative;
        if (!(next >= lower && next <= upper)) next = 0.5 * (lower + upper);
        const bool settled = std::abs(next - g) <= 1e-6 * law_.peakGap();
        g = next;
        if (settled) break;
    }
    return g;
}

} // namespace touchdown
