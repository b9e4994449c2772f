// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/adhesive_cell.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

AdhesiveCell::AdhesiveCell(const AdhesionLaw& law, double compliance, double hardness)
    : law_(law), compliance_(compliance), closed_(law.pressure(0.0)), farLine_(law.peakGap() + compliance * law.peakAttraction())
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
    // g - c f(g) = v, whose left side rises with a slope from 1 upwards: Newton's method within bounds, from the gap there is.
    // What is returned lies on the law however far from the root; close to the solution one step is exact to rounding.
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
