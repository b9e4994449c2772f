// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/gap_law.h"

#include <algorithm>
#include <cmath>

#include "core/physics/contact/adhesion_kind.h"

namespace touchdown {

namespace {

constexpr double leastAttraction = 1e-10; // of the largest, that counts: far rails are large [-]
constexpr double farthestGap = 1e-4;      // [m]

double reachOfAttraction(const AdhesionLaw& law)
{
    double gap = law.peakGap() + 1e-10;
    while (gap < farthestGap && -law.pressure(gap) > leastAttraction * law.peakAttraction()) gap *= 1.5;
    return std::min(gap, farthestGap);
}

} // namespace

GapLaw::GapLaw(const Asperities& asperities, const ElasticPair& pair, const Adhesion& adhesion)
    : asperities_(asperities, pair),
      deviation_(asperities.heightDeviation),
      width_(adhesion.equilibriumDistance),
      reach_(asperities_.reach())
{
    if (!adhesion.acts()) return;
    adhesion_.emplace(adhesion);
    if (adhesion.kind == AdhesionKind::VanDerWaals) width_ = std::max(adhesion_->peakGap(), 1e-11);
    reach_ = std::max(reach_, reachOfAttraction(*adhesion_));
}

GapForces GapLaw::pressures(double gap) const
{
    GapForces forces;
    if (gap < asperities_.reach()) forces.contact = asperities_.pressure(gap);
    if (adhesion_) forces.adhesion = adhesion_->pressure(gap);
    return forces;
}

GapForces GapLaw::at(double gap) const
{
    GapForces forces;
    if (gap < asperities_.reach()) {
        forces.contact = asperities_.pressure(gap);
        forces.contactSlope = -asperities_.stiffness(gap);
        forces.area = asperities_.contactArea(gap);
        forces.energy = asperities_.energy(gap);
    }
    if (adhesion_) {
        const AdhesionLaw::Sample sample = adhesion_->sample(gap);
        forces.adhesion = sample.pressure;
        forces.adhesionSlope = gap > 0.0 ? sample.derivative : 0.0; // a gap below zero counts as zero
        forces.energy += adhesion_->energy(std::max(gap, 0.0));
        if (gap < 0.0) forces.energy -= forces.adhesion * gap;
    }
    return forces;
}

double GapLaw::scale(double gap) const
{
    double scale = gap < asperities_.reach() ? deviation_ : std::max(gap, deviation_);
    if (adhesion_) scale = std::min(scale, 0.3 * (std::max(gap, 0.0) + width_));
    return scale;
}

} // namespace touchdown
