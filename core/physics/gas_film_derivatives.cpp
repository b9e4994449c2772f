// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the film's residual answers to small changes of the pressure and of the attitude.
#include <algorithm>
#include <complex>

#include "core/physics/gas_film.h"

namespace touchdown {

template <typename T>
void GasFilm::applyJacobian(std::span<const T> v, std::span<T> out) const
{
    const PaddedGrid& pad = gaps_.pad;
    const std::size_t up = pad.stride();
    const bool limited = setting_.scheme == ConvectionScheme::Limited;
    const LinearisedFaces& x = linear_[0];
    const LinearisedFaces& y = linear_[1];
    // Each face is visited from both sides, so that every cell is written once.
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            out[at] = x.lower[at + 1] * v[at] + x.upper[at + 1] * v[at + 1] //
                      - x.lower[at] * v[at - 1] - x.upper[at] * v[at]       //
                      + y.lower[at + up] * v[at] + y.upper[at + up] * v[at + up] //
                      - y.lower[at] * v[at - up] - y.upper[at] * v[at];
        }
    if (!limited) return;
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            out[at] += x.far[at + 1] * v[x.downward[at + 1] ? at + 2 : at - 1] //
                       - x.far[at] * v[x.downward[at] ? at + 1 : at - 2]       //
                       + y.far[at + up] * v[y.downward[at + up] ? at + 2 * up : at - up] //
                       - y.far[at] * v[y.downward[at] ? at + up : at - 2 * up];
        }
}

template void GasFilm::applyJacobian<double>(std::span<const double>, std::span<double>) const;
template void GasFilm::applyJacobian<std::complex<double>>(std::span<const std::complex<double>>,
                                                           std::span<std::complex<double>>) const;

void GasFilm::applyTransposedJacobian(std::span<const double> v, std::span<double> out) const
{
    const PaddedGrid& pad = gaps_.pad;
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const LinearisedFaces& l = linear_[axis];
        const std::size_t step = pad.step(static_cast<int>(axis));
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t at = pad.at(i, j);
                const double drop = v[at - step] - v[at]; // the face's flow leaves one cell and enters the other
                out[at - step] += l.lower[at] * drop;
                out[at] += l.upper[at] * drop;
                out[l.downward[at] ? at + step : at - 2 * step] += l.far[at] * drop;
            }
    }
    clearRings(out);
}

GasFilm::AttitudeSlopes GasFilm::slopesAt(std::size_t axis, std::size_t at, int i, int j, double pm) const
{
    const FilmGaps::Faces& faces = gaps_.faces[axis];
    const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
    const double x = axis == 0 ? faces.pathMid[line] : gaps_.grid.centreX(i);
    const double y = axis == 0 ? gaps_.grid.centreY(j) : faces.pathMid[line];
    const double width = axes_[axis].width[static_cast<std::size_t>(axis == 0 ? j : i)];
    const double h = axes_[axis].gap[at];
    AttitudeSlopes slopes{};
    if (h <= 0.0) return slopes;
    const FlowTable::Value g = table_.at(pm * h, h);
    // K = k h^2 G(pm h)
    const double byGap = width / faces.pathLength[line] / (12.0 * setting_.air.viscosity) * h *
                         (2.0 * g.mobility + h * (pm * g.derivative + table_.gapDerivative(pm * h, h)));
    const std::array<double, 3> lift = liftDirections(x, y);
    for (std::size_t k = 0; k < 3; ++k) {
        slopes.K[k] = byGap * lift[k];
        slopes.H[k] = width * lift[k];
    }
    return slopes;
}

GasFilm::AttitudeSlopes GasFilm::cutSlopes(const CutPlace& place, double pm) const
{
    const double perViscosity = 1.0 / (12.0 * setting_.air.viscosity);
    AttitudeSlopes slopes{};
    for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) {
        const GapRow& row = gaps_.rows[r];
        double R = 0.0, S = 0.0;
        std::array<double, 3> dR{}, dS{};
        bool open = true;
        for (std::uint32_t k = row.pieces; open && k < row.pieceEnd; ++k) {
            const GapPiece& piece = gaps_.pieces[k];
            const double h = piece.recess + gaps_.lift(attitude_, piece.x, piece.y);
            if (!(open = h > closedGap)) break;
            const FlowTable::Value g = table_.at(pm * h, h);
            const double resistance = piece.extent / (perViscosity * h * h * g.mobility);
            const double byGap =
                -resistance * (2.0 / h + (pm * g.derivative + table_.gapDerivative(pm * h, h)) / g.mobility);
            const std::array<double, 3> lift = liftDirections(piece.x, piece.y);
            R += resistance;
            S += h * resistance;
            for (std::size_t m = 0; m < 3; ++m) {
                dR[m] += byGap * lift[m];
                dS[m] += (resistance + h * byGap) * lift[m];
            }
        }
        if (!open) continue;
        for (std::size_t m = 0; m < 3; ++m) {
            slopes.K[m] -= row.width * dR[m] / (R * R);
            slopes.H[m] += row.width * (dS[m] - S / R * dR[m]) / R;
        }
    }
    return slopes;
}

template <ConvectionScheme scheme>
void GasFilm::addAttitudeFlow(std::size_t axis, std::size_t at, std::size_t line, const AttitudeSlopes& slopes,
                              std::span<const double> p, std::array<std::vector<double>, 3>& out) const
{
    const AxisState& a = axes_[axis];
    const FilmGaps::Faces& faces = gaps_.faces[axis];
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis));
    const double p1 = p[at - step], p2 = p[at];
    const double c = a.speed[at] * a.H[at];
    const EffectiveConductance e = effectiveConductance<scheme>(a.K[at], c);
    double limited = 0.0, shift = 0.0;
    if constexpr (scheme == ConvectionScheme::Limited) {
        limited = limitedDifference(axis, at, line, p, c < 0.0).value;
        shift = faces.upperShare[line] - 0.5;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double dc = a.speed[at] * slopes.H[k];
        const double dE = e.byDiffusion * slopes.K[k] + e.byConvection * dc;
        const double flow = 0.5 * (p1 + p2) * dc - dE * (p2 - p1) + limited * (dE - slopes.K[k] + dc * shift);
        out[k][at - step] += flow;
        out[k][at] -= flow;
    }
}

void GasFilm::attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out) const
{
    const PaddedGrid& pad = gaps_.pad;
    for (auto& column : out) column.assign(pad.size(), 0.0);
    const auto add = [&](std::size_t axis, std::size_t at, std::size_t line, const AttitudeSlopes& slopes) {
        switch (setting_.scheme) {
            using enum ConvectionScheme;
        case Upwind: addAttitudeFlow<Upwind>(axis, at, line, slopes, p, out); break;
        case Hybrid: addAttitudeFlow<Hybrid>(axis, at, line, slopes, p, out); break;
        case PowerLaw: addAttitudeFlow<PowerLaw>(axis, at, line, slopes, p, out); break;
        case Exponential: addAttitudeFlow<Exponential>(axis, at, line, slopes, p, out); break;
        case Limited: addAttitudeFlow<Limited>(axis, at, line, slopes, p, out); break;
        }
    };
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t step = pad.step(static_cast<int>(axis));
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t at = pad.at(i, j);
                add(axis, at, static_cast<std::size_t>(axis == 0 ? i : j),
                    slopesAt(axis, at, i, j, 0.5 * (p[at - step] + p[at])));
            }
        for (const CutPlace& place : gaps_.faces[axis].cut) {
            const std::size_t row = place.at / pad.stride() - PaddedGrid::rings;
            const std::size_t column = place.at % pad.stride() - PaddedGrid::rings;
            add(axis, place.at, axis == 0 ? column : row, cutSlopes(place, 0.5 * (p[place.at - step] + p[place.at])));
        }
    }
    for (auto& column : out) clearRings(column);
}

} // namespace touchdown
