// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/adhesion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/physics/contact/adhesion_kind.h"

namespace touchdown {

namespace {

constexpr double vacuumPermittivity = 8.8541878128e-12; // eps0 [F/m], CODATA 2018

} // namespace

AdhesionLaw::AdhesionLaw(const Adhesion& adhesion)
    : acts_(adhesion.acts()),
      kind_(adhesion.kind),
      isShifted_(kind_ != AdhesionKind::VanDerWaals),
      shifted_{adhesion.equilibriumDistance, 1.0 / adhesion.equilibriumDistance,
               kind_ == AdhesionKind::LennardJones ? 8.0 * adhesion.surfaceEnergy / (3.0 * adhesion.equilibriumDistance)
                                                   : 0.0,
               0.5 * vacuumPermittivity * adhesion.voltage * adhesion.voltage}
{
    assert(shifted_.z0 > 0.0 && std::isfinite(shifted_.z0) && shifted_.scale >= 0.0 && std::isfinite(shifted_.scale) &&
           std::isfinite(shifted_.electric));
    if (kind_ == AdhesionKind::VanDerWaals) {
        const double pi = std::numbers::pi;
        assert(adhesion.hamakerA >= 0.0 && adhesion.hamakerB >= 0.0);
        attraction_ = adhesion.hamakerA / (6.0 * pi);
        repulsion_ = adhesion.hamakerB / (45.0 * pi);
        // a/g^3 = b/g^9 where g^6 = b/a. Repulsion alone has no such distance either: z0 stands in.
        const bool both = attraction_ > 0.0 && repulsion_ > 0.0;
        const double gap = both ? 0.5 * std::pow(repulsion_ / attraction_, 1.0 / 6.0) : shifted_.z0;
        const double g3 = gap * gap * gap, g9 = g3 * g3 * g3;
        tangentPressure_ = -attraction_ / g3 + repulsion_ / g9;
        tangentSlope_ = repulsion_ > 0.0 ? (3.0 * attraction_ / g3 - 9.0 * repulsion_ / g9) / gap : 0.0;
        tangentEnergy_ = -0.5 * attraction_ / (gap * gap) + 0.125 * repulsion_ / (g9 / gap);
        tangentGap_ = gap;
    }
    peakGap_ = softeningGap();
    peakAttraction_ = std::max(0.0, -pressure(peakGap_));
}

AdhesionLaw::Sample AdhesionLaw::sample(double gap) const
{
    const double g = std::max(gap, 0.0);
    Sample law = shifted_.sample(g);
    if (kind_ == AdhesionKind::VanDerWaals) {
        if (g <= tangentGap_) {
            law.pressure += tangentPressure_ + tangentSlope_ * (g - tangentGap_);
            law.derivative += tangentSlope_;
        } else {
            const double i = 1.0 / g, i3 = i * i * i, i9 = i3 * i3 * i3;
            law.pressure += repulsion_ * i9 - attraction_ * i3;
            law.derivative += (3.0 * attraction_ * i3 - 9.0 * repulsion_ * i9) * i;
        }
    }
    return law;
}

double AdhesionLaw::energy(double gap) const
{
    // The integral of f from g to far away.
    const double g = std::max(gap, 0.0);
    const double s = shifted_.z0 / (g + shifted_.z0);
    double phi = -shifted_.electric * s / shifted_.z0;
    if (kind_ == AdhesionKind::LennardJones) {
        const double s2 = s * s, s8 = (s2 * s2) * (s2 * s2);
        phi -= shifted_.scale * shifted_.z0 * (0.5 * s2 - 0.125 * s8);
    } else if (kind_ == AdhesionKind::VanDerWaals) {
        if (g <= tangentGap_) {
            const double inside = tangentGap_ - g;
            phi += tangentEnergy_ + inside * (tangentPressure_ - 0.5 * tangentSlope_ * inside);
        } else {
            const double i2 = 1.0 / (g * g), i8 = (i2 * i2) * (i2 * i2);
            phi += 0.125 * repulsion_ * i8 - 0.5 * attraction_ * i2;
        }
    }
    return phi;
}

double AdhesionLaw::leastEnergy() const
{
    // f falls up to the peak gap: it is zero there once, or attracts from gap 0 on.
    if (!(pressure(0.0) > 0.0)) return energy(0.0);
    double lower = 0.0, upper = peakGap_;
    for (int i = 0; i < 100 && upper - lower > 1e-15 * upper; ++i) {
        const double middle = 0.5 * (lower + upper);
        (pressure(middle) > 0.0 ? lower : upper) = middle;
    }
    return energy(upper);
}

double AdhesionLaw::softeningGap() const
{
    // df/dg changes its sign once, from below zero to above, not beyond the peak of the law without voltage.
    double lower = 0.0, upper = shifted_.z0;
    if (kind_ == AdhesionKind::VanDerWaals)
        upper = repulsion_ > 0.0 && attraction_ > 0.0 ? 4.0 * tangentGap_ : tangentGap_;
    if (!(derivative(lower) < 0.0)) return 0.0;
    if (!(derivative(upper) > 0.0)) return upper;
    for (int i = 0; i < 100 && upper - lower > 1e-15 * upper; ++i) {
        const double middle = 0.5 * (lower + upper);
        (derivative(middle) < 0.0 ? lower : upper) = middle;
    }
    return lower;
}

} // namespace touchdown
