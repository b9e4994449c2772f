// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/physics/gas_film.h"

namespace touchdown {

template <typename Number>
Number GasFilm::cutProfileExcess(std::size_t axis, const CutPlace& place, const Number& p1, const Number& p2) const
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
        PathIntegral<Number> path;
        Number resistance, peclet;
        double length = 0.0;
        bool open = true;
        for (std::uint32_t k = 0; open && k < count; ++k) {
            open = pieceOf(piece(k), std::abs(speed), pm, resistance, peclet);
            if (open) path.add(resistance, peclet, 0.0, 0.0);
            length += piece(k).extent;
        }
        if (!open) continue;
        const Number flow = (upstream - downstream * path.decay) / path.I;
        Number end = downstream, mean(0.0);
        for (std::uint32_t k = count; k-- > 0;) {
            pieceOf(piece(k), std::abs(speed), pm, resistance, peclet);
            const PathFunctions<Number> f(peclet);
            mean = mean + Number(piece(k).extent) * (end * f.phi + flow * resistance * f.chi);
            end = end * f.decay + flow * resistance * f.phi;
        }
        sum = sum + Number(row.width) * (mean - Number(length) * pm);
    }
    return sum;
}

std::array<double, 3> GasFilm::load(std::span<const double> p) const
{
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    std::array<double, 3> sum{};
    const auto add = [&](double force, double x, double y) {
        sum[0] += force;
        sum[1] -= force * (x - 0.5 * gaps_.length);
        sum[2] -= force * (y - 0.5 * gaps_.width);
    };
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            add((p[at] - ambient()) * area_[at], grid.centreX(i), grid.centreY(j));
        }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const FilmGaps::Faces& faces = gaps_.faces[axis];
        for (const CutPlace& place : faces.cut) {
            const int j = static_cast<int>(place.at / pad.stride()) - PaddedGrid::rings;
            const int i = static_cast<int>(place.at % pad.stride()) - PaddedGrid::rings;
            const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
            add(cutProfileExcess<double>(axis, place, p[place.at - pad.step(static_cast<int>(axis))], p[place.at]),
                axis == 0 ? faces.pathMid[line] : grid.centreX(i), axis == 0 ? grid.centreY(j) : faces.pathMid[line]);
        }
    }
    return sum;
}

} // namespace touchdown
