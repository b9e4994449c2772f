// SPDX-License-Identifier: GPL-3.0-or-later
//
// Derivatives of load and shear by the pressures and the attitude.

#include "core/numerics/vector_clones.h"
#include "core/physics/film/film_loads.h"
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

void FilmLoads::addCouetteSlopes(std::span<const double> p, Derivatives& out)
{
    const PaddedGrid& pad = film_.gaps().pad;
    const double slip = slipLength();
    std::array<GapSums, 2> sums;
    const auto setSlopes = [&](std::size_t count) {
        couetteSlopes(count, gap_.data(), pressure_.data(), slip, byGap_.data(), byPressure_.data());
    };
    for (int j = 0; j < pad.ny; ++j) {
        setCellRow(j, p);
        setSlopes(static_cast<std::size_t>(pad.nx));
        const std::size_t first = pad.at(0, j);
        const double y = film_.gaps().grid.centreY(j);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (std::size_t i = 0; i < film_.centresX().size(); ++i) {
                const double weight = couette_[axis][first + i];
                out.byPressure[3 + axis][first + i] = weight * byPressure_[i];
                sums[axis].add(weight * byGap_[i], film_.centresX()[i], y);
            }
    }
    for (std::size_t first = 0; first < cutPieces_.at.size(); first += groupSize) {
        const std::size_t count = setCutPieces(first, p);
        setSlopes(count);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t n = first + k;
                const double weight = cutPieces_.couette[axis][n];
                out.byPressure[3 + axis][cutPieces_.at[n]] += weight * byPressure_[k];
                sums[axis].add(weight * byGap_[k], cutPieces_.x[n], cutPieces_.y[n]);
            }
    }
    for (std::size_t axis = 0; axis < 2; ++axis) sums[axis].addTo(out.byAttitude[3 + axis], film_.gaps());
}

void FilmLoads::addPoiseuilleSlopes(std::size_t axis, std::span<const double> p, Derivatives& out) const
{
    const PaddedGrid& pad = film_.gaps().pad;
    const FilmGeometry::Axis& a = film_.axes()[axis];
    const std::vector<double>& middle = film_.gaps().faces[axis].pathMid;
    const double* x = axis == 0 ? middle.data() : film_.centresX().data();
    const std::size_t step = pad.step(static_cast<int>(axis)), count = static_cast<std::size_t>(pad.nx + (axis == 0));
    std::vector<double>& byPressure = out.byPressure[3 + axis];
    GapSums sums;
    for (int j = 0; j < pad.ny + (axis == 1); ++j) {
        const std::size_t first = pad.at(0, j), line = static_cast<std::size_t>(j);
        const double y = axis == 0 ? film_.gaps().grid.centreY(j) : middle[line];
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = first + i;
            const double half = a.gap[at] > closedGap ? 0.5 * a.width[axis == 0 ? line : i] : 0.0;
            byPressure[at - step] += half * a.gap[at];
            byPressure[at] -= half * a.gap[at];
            sums.add(-half * (p[at] - p[at - step]), x[i], y);
        }
    }
    sums.addTo(out.byAttitude[3 + axis], film_.gaps());
}

void FilmLoads::addCutSlopes(std::size_t axis, std::span<const double> p, Derivatives& out)
{
    const std::size_t step = film_.gaps().pad.step(static_cast<int>(axis));
    film_.axes()[axis].cutPaths.forces(film_.motionShare()[axis] > 0.0, p, film_.attitude(),
                                       film_.axes()[axis].cutSurface, film_.flowTable(), film_.air().viscosity,
                                       cutWork_, cutForcesByAll_);
    for (std::size_t n = 0; n < cutForcesByAll_.size(); ++n) {
        const std::size_t at = film_.gaps().faces[axis].cut[n].at;
        const auto addTo = [&](std::size_t k, double share, const ByAll& force) {
            out.byPressure[k][at - step] += share * force.by[0];
            out.byPressure[k][at] += share * force.by[1];
            for (std::size_t m = 0; m < 3; ++m) out.byAttitude[k][m] += share * force.by[m + 2];
        };
        const CutForces<ByAll>& force = cutForcesByAll_[n];
        addTo(0, film_.motionShare()[axis], force.excess);
        addTo(1, film_.motionShare()[axis] * cutArms_[axis][n][0], force.excess);
        addTo(2, film_.motionShare()[axis] * cutArms_[axis][n][1], force.excess);
        addTo(3 + axis, 1.0, force.drag);
    }
}

void FilmLoads::derivatives(std::span<const double> p, Derivatives& out)
{
    const PaddedGrid& pad = film_.gaps().pad;
    out.value = loadAndShear(p);
    out.byAttitude = {};
    for (auto& field : out.byPressure) field.resize(pad.size());
    for (int j = 0; j < pad.ny; ++j) {
        const double armY = 0.5 * film_.gaps().width - film_.gaps().grid.centreY(j);
        for (std::size_t i = 0; i < film_.centresX().size(); ++i) {
            const std::size_t at = pad.at(0, j) + i;
            out.byPressure[0][at] = film_.areas()[at];
            out.byPressure[1][at] = film_.areas()[at] * (0.5 * film_.gaps().length - film_.centresX()[i]);
            out.byPressure[2][at] = film_.areas()[at] * armY;
        }
    }
    addCouetteSlopes(p, out);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        addPoiseuilleSlopes(axis, p, out);
        addCutSlopes(axis, p, out);
    }
    for (auto& field : out.byPressure) film_.clearRings(field);
}

} // namespace touchdown
