// SPDX-License-Identifier: GPL-3.0-or-later
//
// Derivatives of load and shear by the pressures and the attitude.
#include <algorithm>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"

namespace touchdown {

namespace {

/// Derivatives of 1/(h + s/p) by h, in place of the gaps, and by p, in place of the pressures.
TOUCHDOWN_VECTOR_CLONES void couetteSlopes(std::size_t count, const double* gap, const double* p, double slip,
                                           double* byGap, double* byPressure)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const bool open = gap[k] > closedGap;
        const double inverse = 1.0 / ((open ? gap[k] : 1.0) * p[k] + slip), square = open ? inverse * inverse : 0.0;
        byGap[k] = -p[k] * p[k] * square;
        byPressure[k] = slip * square;
    }
}

/// Of the forces at places, their derivatives by the gap, as sums of them and of their moments about the origin.
struct GapSums {
    double force = 0.0, x = 0.0, y = 0.0;

    void add(double byGap, double atX, double atY)
    {
        force += byGap;
        x += byGap * atX;
        y += byGap * atY;
    }
    void addTo(std::array<double, 3>& byAttitude, const FilmGaps& gaps) const
    {
        byAttitude[0] += force;
        byAttitude[1] += gaps.length * force - x;
        byAttitude[2] += 0.5 * gaps.width * force - y;
    }
};

} // namespace

void GasFilm::addCouetteSlopes(std::span<const double> p, ForceDerivatives& out) const
{
    const PaddedGrid& pad = gaps_.pad;
    const double slip = slipLength();
    std::array<GapSums, 2> sums;
    const auto setSlopes = [&](std::size_t count) {
        couetteSlopes(count, forceWork_.gap.data(), forceWork_.pressure.data(), slip, forceWork_.byGap.data(),
                      forceWork_.byPressure.data());
    };
    for (int j = 0; j < pad.ny; ++j) {
        setCellRow(j, p);
        setSlopes(static_cast<std::size_t>(pad.nx));
        const std::size_t first = pad.at(0, j);
        const double y = gaps_.grid.centreY(j);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (std::size_t i = 0; i < centreX_.size(); ++i) {
                const double weight = couette_[axis][first + i];
                out.byPressure[3 + axis][first + i] = weight * forceWork_.byPressure[i];
                sums[axis].add(weight * forceWork_.byGap[i], centreX_[i], y);
            }
    }
    for (std::size_t first = 0; first < cutPieces_.at.size(); first += ForceWork::pieces) {
        const std::size_t count = setCutPieces(first, p);
        setSlopes(count);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t n = first + k;
                const double weight = cutPieces_.couette[axis][n];
                out.byPressure[3 + axis][cutPieces_.at[n]] += weight * forceWork_.byPressure[k];
                sums[axis].add(weight * forceWork_.byGap[k], cutPieces_.x[n], cutPieces_.y[n]);
            }
    }
    for (std::size_t axis = 0; axis < 2; ++axis) sums[axis].addTo(out.byAttitude[3 + axis], gaps_);
}

void GasFilm::addPoiseuilleSlopes(std::size_t axis, std::span<const double> p, ForceDerivatives& out) const
{
    const PaddedGrid& pad = gaps_.pad;
    const AxisState& a = axes_[axis];
    const std::vector<double>& middle = gaps_.faces[axis].pathMid;
    const double* x = axis == 0 ? middle.data() : centreX_.data();
    const std::size_t step = pad.step(static_cast<int>(axis)), count = static_cast<std::size_t>(pad.nx + (axis == 0));
    std::vector<double>& byPressure = out.byPressure[3 + axis];
    GapSums sums;
    for (int j = 0; j < pad.ny + (axis == 1); ++j) {
        const std::size_t first = pad.at(0, j), line = static_cast<std::size_t>(j);
        const double y = axis == 0 ? gaps_.grid.centreY(j) : middle[line];
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = first + i;
            const double half = a.gap[at] > closedGap ? 0.5 * a.width[axis == 0 ? line : i] : 0.0;
            byPressure[at - step] += half * a.gap[at];
            byPressure[at] -= half * a.gap[at];
            sums.add(-half * (p[at] - p[at - step]), x[i], y);
        }
    }
    sums.addTo(out.byAttitude[3 + axis], gaps_);
}

void GasFilm::addCutSlopes(std::size_t axis, std::span<const double> p, ForceDerivatives& out) const
{
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis));
    cutPaths_[axis].forces(motionShare_[axis] > 0.0, p, attitude_, axes_[axis].cutSurface, table_,
                           setting_.air.viscosity, cutWork_, cutForcesByAll_);
    for (std::size_t n = 0; n < cutForcesByAll_.size(); ++n) {
        const std::size_t at = gaps_.faces[axis].cut[n].at;
        const auto addTo = [&](std::size_t k, double share, const ByAll& force) {
            out.byPressure[k][at - step] += share * force.by[0];
            out.byPressure[k][at] += share * force.by[1];
            for (std::size_t m = 0; m < 3; ++m) out.byAttitude[k][m] += share * force.by[m + 2];
        };
        const CutForces<ByAll>& force = cutForcesByAll_[n];
        addTo(0, motionShare_[axis], force.excess);
        addTo(1, motionShare_[axis] * axes_[axis].cutArms[n][0], force.excess);
        addTo(2, motionShare_[axis] * axes_[axis].cutArms[n][1], force.excess);
        addTo(3 + axis, 1.0, force.drag);
    }
}

void GasFilm::forceDerivatives(std::span<const double> p, ForceDerivatives& out) const
{
    const PaddedGrid& pad = gaps_.pad;
    out.value = loadAndShear(p);
    out.byAttitude = {};
    for (auto& field : out.byPressure) field.resize(pad.size());
    for (int j = 0; j < pad.ny; ++j) {
        const double armY = 0.5 * gaps_.width - gaps_.grid.centreY(j);
        for (std::size_t i = 0; i < centreX_.size(); ++i) {
            const std::size_t at = pad.at(0, j) + i;
            out.byPressure[0][at] = area_[at];
            out.byPressure[1][at] = area_[at] * (0.5 * gaps_.length - centreX_[i]);
            out.byPressure[2][at] = area_[at] * armY;
        }
    }
    addCouetteSlopes(p, out);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        addPoiseuilleSlopes(axis, p, out);
        addCutSlopes(axis, p, out);
    }
    for (auto& field : out.byPressure) clearRings(field);
}

} // namespace touchdown
