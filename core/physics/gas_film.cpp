// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/gas_film.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

GasFilm::GasFilm(const FilmGaps& gaps, const FilmSetting& setting)
    : gaps_(gaps), setting_(setting), table_(setting.slip, setting.air)
{
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        AxisState& a = axes_[axis];
        for (auto* field : {&a.gap, &a.speed, &a.K, &a.dK, &a.H, &a.dH}) field->assign(pad.size(), 0.0);
        LinearisedFaces& l = linear_[axis];
        for (auto* field : {&l.lower, &l.upper, &l.far, &l.diffusion, &l.effective, &l.convection})
            field->assign(pad.size(), 0.0);
        l.downward.assign(pad.size(), 0);
        const int across = axis == 0 ? pad.ny : pad.nx;
        for (int k = 0; k < across; ++k) a.width.push_back(axis == 0 ? grid.widthY(k) : grid.widthX(k));
    }
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i <= pad.nx; ++i) {
            const double x = grid.x[static_cast<std::size_t>(i)];
            const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, x, grid.centreY(j));
            axes_[0].speed[pad.at(i, j)] = 0.5 * v.x;
        }
    for (int j = 0; j <= pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const double y = grid.y[static_cast<std::size_t>(j)];
            const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, grid.centreX(i), y);
            axes_[1].speed[pad.at(i, j)] = 0.5 * v.y;
        }
    volume_.assign(pad.size(), 0.0);
    area_.assign(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) area_[pad.at(i, j)] = grid.widthX(i) * grid.widthY(j);
    setAttitude({});
}

void GasFilm::setAttitude(const Attitude& attitude)
{
    attitude_ = attitude;
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    for (int j = 0; j < pad.ny; ++j) {
        const double y = grid.centreY(j);
        for (int i = 0; i <= pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double x = gaps_.faces[0].pathMid[static_cast<std::size_t>(i)];
            axes_[0].gap[at] = std::max(0.0, gaps_.faces[0].recess[at] + gaps_.lift(attitude, x, y));
        }
    }
    for (int j = 0; j <= pad.ny; ++j) {
        const double y = gaps_.faces[1].pathMid[static_cast<std::size_t>(j)];
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            axes_[1].gap[at] = std::max(0.0, gaps_.faces[1].recess[at] + gaps_.lift(attitude, grid.centreX(i), y));
        }
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (const CutPlace& place : gaps_.faces[axis].cut) axes_[axis].gap[place.at] = 0.0;

    double total = 0.0;
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            volume_[at] = area_[at] * std::max(0.0, meanGap(i, j));
            total += volume_[at];
        }
    const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, 0.5 * gaps_.length, 0.5 * gaps_.width);
    const double speed = std::max(std::hypot(v.x, v.y), 1e-3);
    flowScale_ = 0.5 * ambient() * speed * std::max(total, gaps_.length * gaps_.width * closedGap) / gaps_.length;
}

double GasFilm::meanGap(int i, int j) const
{
    return gaps_.meanRecess[gaps_.pad.at(i, j)] + gaps_.lift(attitude_, gaps_.grid.centreX(i), gaps_.grid.centreY(j));
}

GasFilm::PathFlow GasFilm::cutFlow(const CutPlace& place, double pm) const
{
    const double perViscosity = 1.0 / (12.0 * setting_.air.viscosity);
    PathFlow sum{};
    for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) {
        const GapRow& row = gaps_.rows[r];
        // Resistance of the row, its derivative by pm, and the gap weighted with resistance.
        double R = 0.0, dR = 0.0, S = 0.0, dS = 0.0;
        bool open = true;
        for (std::uint32_t k = row.pieces; open && k < row.pieceEnd; ++k) {
            const GapPiece& piece = gaps_.pieces[k];
            const double h = piece.recess + gaps_.lift(attitude_, piece.x, piece.y);
            open = h > closedGap;
            const FlowTable::Value g = table_.at(pm * std::max(h, closedGap), h);
            const double resistance = piece.extent / (perViscosity * h * h * g.mobility);
            const double slope = -resistance * h * g.derivative / g.mobility;
            R += resistance;
            dR += slope;
            S += h * resistance;
            dS += h * slope;
        }
        if (!open) continue;
        const double conductance = row.width / R;
        const double h = S / R;
        sum.K += conductance;
        sum.dK -= conductance * dR / R;
        sum.H += row.width * h;
        sum.dH += row.width * (dS - h * dR) / R;
    }
    return sum;
}

void GasFilm::setConductances(std::span<const double> p)
{
    const PaddedGrid& pad = gaps_.pad;
    const double perViscosity = 1.0 / (12.0 * setting_.air.viscosity);
    for (int axis = 0; axis < 2; ++axis) {
        AxisState& a = axes_[static_cast<std::size_t>(axis)];
        const FilmGaps::Faces& faces = gaps_.faces[static_cast<std::size_t>(axis)];
        const std::size_t step = pad.step(axis);
        for (int j = 0; j < pad.ny + axis; ++j)
            for (int i = 0; i < pad.nx + 1 - axis; ++i) {
                const std::size_t at = pad.at(i, j);
                const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
                const double width = a.width[static_cast<std::size_t>(axis == 0 ? j : i)];
                const double h = a.gap[at];
                const double w = 0.5 * (p[at - step] + p[at]) * h;
                const FlowTable::Value g = table_.at(std::max(w, 1e-12), h);
                const double scale = width / faces.pathLength[line] * perViscosity * h * h;
                a.K[at] = scale * g.mobility;
                a.dK[at] = scale * h * g.derivative;
                a.H[at] = width * h;
            }
        for (const CutPlace& place : faces.cut) {
            const PathFlow flow = cutFlow(place, 0.5 * (p[place.at - step] + p[place.at]));
            a.K[place.at] = flow.K;
            a.dK[place.at] = flow.dK;
            a.H[place.at] = flow.H;
            a.dH[place.at] = flow.dH;
        }
    }
}

template <ConvectionScheme scheme, bool linearise>
void GasFilm::flows(int axis, std::span<const double> p, std::span<double> out)
{
    const PaddedGrid& pad = gaps_.pad;
    const AxisState& a = axes_[static_cast<std::size_t>(axis)];
    const FilmGaps::Faces& faces = gaps_.faces[static_cast<std::size_t>(axis)];
    LinearisedFaces& l = linear_[static_cast<std::size_t>(axis)];
    const std::size_t step = pad.step(axis);
    for (int j = 0; j < pad.ny + axis; ++j)
        for (int i = 0; i < pad.nx + 1 - axis; ++i) {
            const std::size_t at = pad.at(i, j);
            const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
            const double p1 = p[at - step], p2 = p[at];
            const double difference = p2 - p1, pm = 0.5 * (p1 + p2);
            const double K = a.K[at], dK = a.dK[at];
            const double c = a.speed[at] * a.H[at], dc = a.speed[at] * a.dH[at];
            const EffectiveConductance e = effectiveConductance<scheme>(K, c);
            double flow = c * pm - e.value * difference;
            // Of the monotone part, by pm.
            const double dE = e.byDiffusion * dK + e.byConvection * dc;
            double byMean = dc * pm - dE * difference;
            if constexpr (linearise) {
                l.diffusion[at] = K;
                l.convection[at] = c + byMean;
                l.effective[at] = std::max(e.value, 0.5 * std::abs(c + byMean));
                l.lower[at] = 0.5 * c + e.value;
                l.upper[at] = 0.5 * c - e.value;
            }
            if constexpr (scheme == ConvectionScheme::Limited) {
                const bool downward = c < 0.0;
                const LimitedDifference limited = limitedDifference(static_cast<std::size_t>(axis), at, line, p, downward);
                const double shift = faces.upperShare[line] - 0.5;
                const double g = (e.value - K) + c * shift;
                flow += g * limited.value;
                if constexpr (linearise) {
                    byMean += limited.value * (dE - dK + dc * shift);
                    l.lower[at] -= g * limited.byLocal;
                    l.upper[at] += g * limited.byLocal;
                    l.downward[at] = downward;
                    const double byUpstream = g * limited.byUpstream;
                    if (downward) {
                        l.upper[at] -= byUpstream;
                        l.far[at] = byUpstream;
                    } else {
                        l.lower[at] += byUpstream;
                        l.far[at] = -byUpstream;
                    }
                }
            }
            if constexpr (linearise) {
                l.lower[at] += 0.5 * byMean;
                l.upper[at] += 0.5 * byMean;
            }
            out[at - step] += flow;
            out[at] -= flow;
        }
}

template <bool linearise>
void GasFilm::flowsOfScheme(std::span<const double> p, std::span<double> out)
{
    setConductances(p);
    std::fill(out.begin(), out.end(), 0.0);
    for (int axis = 0; axis < 2; ++axis) switch (setting_.scheme) {
        using enum ConvectionScheme;
        case Upwind: flows<Upwind, linearise>(axis, p, out); break;
        case Hybrid: flows<Hybrid, linearise>(axis, p, out); break;
        case PowerLaw: flows<PowerLaw, linearise>(axis, p, out); break;
        case Exponential: flows<Exponential, linearise>(axis, p, out); break;
        case Limited: flows<Limited, linearise>(axis, p, out); break;
        }
    clearRings(out); // what flowed into the rings is no residual
}

void GasFilm::clearRings(std::span<double> field) const
{
    const PaddedGrid& pad = gaps_.pad;
    for (int j = -PaddedGrid::rings; j < pad.ny + PaddedGrid::rings; ++j) {
        const bool inside = j >= 0 && j < pad.ny;
        for (int i = -PaddedGrid::rings; i < 0; ++i) field[pad.at(i, j)] = field[pad.at(pad.nx - 1 - i, j)] = 0.0;
        for (int i = 0; !inside && i < pad.nx; ++i) field[pad.at(i, j)] = 0.0;
    }
}

void GasFilm::residual(std::span<const double> p, std::span<double> out) { flowsOfScheme<false>(p, out); }

void GasFilm::linearise(std::span<const double> p, std::span<double> out) { flowsOfScheme<true>(p, out); }

} // namespace touchdown
