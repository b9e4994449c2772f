// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/physics/gas_film.h"

namespace touchdown {

/// Shear of the pressure gradient on a face that pieces cross: -(h/2)(p2 - p1) times the width, h weighted by resistance.
template <typename Number>
Number GasFilm::cutPoiseuille(const CutPlace& place, double surface, const Number& p1, const Number& p2) const
{
    const Number pm = Number(0.5) * (p1 + p2);
    Number sum(0.0);
    for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) {
        const GapRow& row = gaps_.rows[r];
        Number R(0.0), weighted(0.0);
        bool open = true;
        for (std::uint32_t k = row.pieces; open && k < row.pieceEnd; ++k) {
            Number resistance, peclet;
            open = pieceOf(gaps_.pieces[k], surface, 1.0, pm, resistance, peclet);
            if (!open) break;
            R = R + resistance;
            weighted = weighted + peclet; // at unit speed: gap times resistance
        }
        if (open) sum = sum - Number(0.5 * row.width) * (p2 - p1) * weighted / R;
    }
    return sum;
}

/// What the pressure between two cell centres adds to the cells' own. A step across the motion's path makes a layer that may be
/// thinner than a cell; where none is, kinks at edges and bends between them cancel in the sum of cells. So only the part along
/// the motion counts. Profile of a constant flow (path_flow.h), from the downstream end: over a piece of length l the mean of the
/// pressure is end phi + flow r chi.
template <typename Number>
Number GasFilm::layerExcess(std::size_t axis, const CutPlace& place, double surface, const Number& p1, const Number& p2) const
{
    const double speed = axes_[axis].speed[place.at];
    const bool against = speed < 0.0;
    const Number pm = Number(0.5) * (p1 + p2), upstream = against ? p2 : p1, downstream = against ? p1 : p2;
    Number sum(0.0);
    for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) {
        const GapRow& row = gaps_.rows[r];
        const std::uint32_t count = row.pieceEnd - row.pieces;
        const auto piece = [&](std::uint32_t k) -> const GapPiece& {
            return gaps_.pieces[against ? row.pieceEnd - 1 - k : row.pieces + k];
        };
        Number integral(0.0), decay(1.0), resistance, peclet; // from the upstream end
        bool open = true;
        for (std::uint32_t k = 0; open && k < count; ++k) {
            open = pieceOf(piece(k), surface, std::abs(speed), pm, resistance, peclet);
            if (!open) break;
            const PathFunctions<Number> f(peclet);
            integral = integral + decay * resistance * f.phi;
            decay = decay * f.decay;
        }
        if (!open) continue;
        const Number flow = (upstream - downstream * decay) / integral;
        Number end = downstream, excess(0.0);
        for (std::uint32_t k = count; k-- > 0;) {
            pieceOf(piece(k), surface, std::abs(speed), pm, resistance, peclet);
            const PathFunctions<Number> f(peclet);
            const Number mean = end * f.phi + flow * resistance * f.chi;
            excess = excess + Number(piece(k).extent) * (mean - (piece(k).start < 0.0 ? p1 : p2));
            end = end * f.decay + flow * resistance * f.phi;
        }
        sum = sum + Number(row.width) * excess;
    }
    return Number(motionShare_[axis]) * sum;
}

/// Calls visit(cell below, above, the excess between them, its force and torques per pressure and area [-], [m]).
template <typename Number, typename Visit>
void GasFilm::forLayers(std::span<const double> p, Visit&& visit) const
{
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        if (!(motionShare_[axis] > 0.0)) continue;
        const FilmGaps::Faces& faces = gaps_.faces[axis];
        const std::size_t step = gaps_.pad.step(static_cast<int>(axis));
        for (std::size_t n = 0; n < faces.cut.size(); ++n) {
            const CutPlace& place = faces.cut[n];
            const int i = gaps_.pad.column(place.at), j = gaps_.pad.row(place.at);
            Number p1(p[place.at - step]), p2(p[place.at]);
            if constexpr (!std::is_same_v<Number, double>) p1.by[0] = p2.by[1] = 1.0;
            const double middle = faces.pathMid[static_cast<std::size_t>(axis == 0 ? i : j)];
            const double x = axis == 0 ? middle : gaps_.grid.centreX(i), y = axis == 0 ? gaps_.grid.centreY(j) : middle;
            visit(place.at - step, place.at, layerExcess(axis, place, axes_[axis].cutSurface[n], p1, p2),
                  std::array<double, 3>{1.0, 0.5 * gaps_.length - x, 0.5 * gaps_.width - y});
        }
    }
}

/// Calls visit(cell, its force and torques per pressure [m^2], [m^3]).
template <typename Visit>
void GasFilm::forLoads(Visit&& visit) const
{
    const PaddedGrid& pad = gaps_.pad;
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            visit(at, std::array<double, 3>{area_[at], area_[at] * (0.5 * gaps_.length - gaps_.grid.centreX(i)),
                                            area_[at] * (0.5 * gaps_.width - gaps_.grid.centreY(j))});
        }
}

/// Calls add(index below, above, shear along x, along y) with numbers that carry their derivatives by the pressure below (or of
/// the cell), above, and by the attitude.
template <typename Number, typename Add>
void GasFilm::addUpShear(std::span<const double> p, Add&& add) const
{
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    constexpr bool plain = std::is_same_v<Number, double>;
    const auto pressure = [&](std::size_t at, [[maybe_unused]] std::size_t index) {
        Number number(p[at]);
        if constexpr (!plain) number.by[index] = 1.0;
        return number;
    };
    const auto gapAt = [&](double gap, [[maybe_unused]] double x, [[maybe_unused]] double y) {
        Number number(gap);
        if constexpr (!plain) {
            const std::array<double, 3> lift = liftDirections(x, y);
            std::copy(lift.begin(), lift.end(), number.by.begin() + 2);
        }
        return number;
    };
    const double slipLength = 2.0 * (2.0 - setting_.slip.accommodation) / setting_.slip.accommodation *
                              setting_.air.meanFreePath * ambient(); // 2 a lambda p [Pa m]
    const auto couette = [&](const Number& pressureHere, const Number& gap, double area) {
        return Number(setting_.air.viscosity * area) / (gap + Number(slipLength) / pressureHere);
    };
    std::vector<std::uint8_t> isCut(pad.size(), 0);
    for (const CutPlace& place : gaps_.cutCells) isCut[place.at] = 1;
    const auto cell = [&](std::size_t at, int i, int j, const Number& perSpeed) {
        const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, grid.centreX(i), grid.centreY(j));
        add(at, at, perSpeed * Number(v.x), perSpeed * Number(v.y));
    };
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            if (isCut[at]) continue;
            const double gap = meanGap(i, j);
            cell(at, i, j,
                 gap > closedGap ? couette(pressure(at, 0), gapAt(gap, grid.centreX(i), grid.centreY(j)), area_[at])
                                 : Number(0.0));
        }
    for (const CutPlace& place : gaps_.cutCells) {
        Number perSpeed(0.0);
        for (std::uint32_t k = gaps_.rows[place.rows].pieces; k < gaps_.rows[place.rows].pieceEnd; ++k) {
            const Number gap = gapOf<Number>(gaps_.pieces[k], surfaceAt(place.at));
            if (valueOf(gap) > closedGap) perSpeed = perSpeed + couette(pressure(place.at, 0), gap, gaps_.pieces[k].extent);
        }
        cell(place.at, pad.column(place.at), pad.row(place.at), perSpeed);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const FilmGaps::Faces& faces = gaps_.faces[axis];
        const std::size_t step = pad.step(static_cast<int>(axis));
        const auto face = [&](std::size_t at, const Number& drag) {
            add(at - step, at, axis == 0 ? drag : Number(0.0), axis == 0 ? Number(0.0) : drag);
        };
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t at = pad.at(i, j);
                const double gap = axes_[axis].gap[at];
                if (gap <= closedGap) continue;
                const double width = axes_[axis].width[static_cast<std::size_t>(axis == 0 ? j : i)];
                const double middle = faces.pathMid[static_cast<std::size_t>(axis == 0 ? i : j)];
                const Number h = gapAt(gap, axis == 0 ? middle : grid.centreX(i), axis == 0 ? grid.centreY(j) : middle);
                face(at, Number(-0.5 * width) * h * (pressure(at, 1) - pressure(at - step, 0)));
            }
        for (std::size_t n = 0; n < faces.cut.size(); ++n) {
            const CutPlace& place = faces.cut[n];
            const Number p1 = pressure(place.at - step, 0), p2 = pressure(place.at, 1);
            face(place.at, cutPoiseuille(place, axes_[axis].cutSurface[n], p1, p2));
        }
    }
}

std::array<double, 3> GasFilm::load(std::span<const double> p) const
{
    std::array<double, 3> sum{};
    forLoads([&](std::size_t at, const std::array<double, 3>& loads) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += loads[k] * (p[at] - ambient());
    });
    forLayers<double>(p, [&](std::size_t, std::size_t, double excess, const std::array<double, 3>& arms) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += arms[k] * excess;
    });
    return sum;
}

std::array<double, 2> GasFilm::shear(std::span<const double> p) const
{
    std::array<double, 2> sum{};
    addUpShear<double>(p, [&](std::size_t, std::size_t, double x, double y) {
        sum[0] += x;
        sum[1] += y;
    });
    return sum;
}

void GasFilm::forceDerivatives(std::span<const double> p, ForceDerivatives& out) const
{
    out.value = {};
    out.byAttitude = {};
    for (auto& field : out.byPressure) field.assign(gaps_.pad.size(), 0.0);
    forLoads([&](std::size_t at, const std::array<double, 3>& loads) {
        for (std::size_t k = 0; k < 3; ++k) {
            out.value[k] += loads[k] * (p[at] - ambient());
            out.byPressure[k][at] = loads[k];
        }
    });
    forLayers<ByAll>(p, [&](std::size_t below, std::size_t above, const ByAll& excess, const std::array<double, 3>& arms) {
        for (std::size_t k = 0; k < 3; ++k) {
            out.value[k] += arms[k] * excess.value;
            out.byPressure[k][below] += arms[k] * excess.by[0];
            out.byPressure[k][above] += arms[k] * excess.by[1];
            for (std::size_t m = 0; m < 3; ++m) out.byAttitude[k][m] += arms[k] * excess.by[m + 2];
        }
    });
    addUpShear<ByAll>(p, [&](std::size_t below, std::size_t above, const ByAll& shearX, const ByAll& shearY) {
        const auto addTo = [&](std::size_t k, const ByAll& force) {
            out.value[k] += force.value;
            out.byPressure[k][below] += force.by[0];
            out.byPressure[k][above] += force.by[1];
            for (std::size_t m = 0; m < 3; ++m) out.byAttitude[k][m] += force.by[m + 2];
        };
        addTo(3, shearX);
        addTo(4, shearY);
    });
    for (auto& field : out.byPressure) clearRings(field);
}

FilmForces GasFilm::forces(std::span<const double> p) const
{
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    FilmForces result;
    std::array<double, 2> px{}, py{}; // moments of the positive and of the negative part
    result.maximumPressure = result.minimumPressure = p[pad.at(0, 0)];
    result.maximumAt = result.minimumAt = {grid.centreX(0), grid.centreY(0)};
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double x = grid.centreX(i), y = grid.centreY(j), force = (p[at] - ambient()) * area_[at];
            (force > 0.0 ? result.positive : result.negative) += force;
            px[force > 0.0 ? 0 : 1] += force * x;
            py[force > 0.0 ? 0 : 1] += force * y;
            if (p[at] > result.maximumPressure) result.maximumPressure = p[at], result.maximumAt = {x, y};
            if (p[at] < result.minimumPressure) result.minimumPressure = p[at], result.minimumAt = {x, y};
        }
    if (result.positive > 0.0) result.centreOfPositive = {px[0] / result.positive, py[0] / result.positive};
    if (result.negative < 0.0) result.centreOfNegative = {px[1] / result.negative, py[1] / result.negative};
    const std::array<double, 3> total = load(p);
    // What layers hold beyond the cells' pressure belongs to the rails: to the positive part.
    result.positive += total[0] - result.positive - result.negative;
    result.net = total[0];
    result.pitchTorque = total[1];
    result.rollTorque = total[2];
    const std::array<double, 2> drag = shear(p);
    result.shearX = drag[0];
    result.shearY = drag[1];
    for (int j = 0; j < pad.ny; ++j)
        result.massFlow += std::max(0.0, flows_.flow[0][pad.at(0, j)]) + std::max(0.0, -flows_.flow[0][pad.at(pad.nx, j)]);
    for (int i = 0; i < pad.nx; ++i)
        result.massFlow += std::max(0.0, flows_.flow[1][pad.at(i, 0)]) + std::max(0.0, -flows_.flow[1][pad.at(i, pad.ny)]);
    return result;
}

} // namespace touchdown
