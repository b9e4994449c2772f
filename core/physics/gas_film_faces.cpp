// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flows through faces, linearised. Smooth faces go row by row in two passes: the mobility from its table, and the rest, which runs
// on vectors.
#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/gas_film.h"

namespace touchdown {

namespace {

using ByPressure = Dual<1>;

void setFace(FilmFaces& f, std::size_t at, const PathFlow<double>& flow, bool against, double p1, double p2)
{
    f.flow[at] = flow.A * p1 - flow.B * p2;
    f.below[at] = flow.below;
    f.above[at] = flow.above;
    f.inflow[at] = against ? flow.B * p2 : flow.A * p1;
}

void setFace(FilmFaces& f, std::size_t at, const PathFlow<ByPressure>& flow, bool against, double p1, double p2)
{
    const double A = flow.A.value, B = flow.B.value;
    setFace(f, at, PathFlow<double>{A, B, flow.K.value, flow.below.value, flow.above.value}, against, p1, p2);
    const double byMeanA = 0.5 * flow.A.by[0] * p1, byMeanB = 0.5 * flow.B.by[0] * p2;
    const double lower = A + (byMeanA - byMeanB), upper = (byMeanA - byMeanB) - B;
    f.lower[at] = lower;
    f.upper[at] = upper;
    f.belowByMean[at] = flow.below.by[0];
    f.aboveByMean[at] = flow.above.by[0];
    f.inflowByLower[at] = against ? byMeanB : A + byMeanA;
    f.inflowByUpper[at] = against ? B + byMeanB : byMeanA;
    f.diffusion[at] = flow.K.value;
    f.convection[at] = lower + upper;
    f.effective[at] = std::max(0.5 * (A + B), 0.5 * std::abs(lower + upper));
}

/// Pressure at the middle of a path.
template <typename Number>
Number meanPressure(double p1, double p2)
{
    Number pm(0.5 * (p1 + p2));
    if constexpr (!std::is_same_v<Number, double>) pm.by[0] = 1.0;
    return pm;
}

/// One row of faces; those that are cut pass nothing here.
struct FaceRow {
    std::size_t first, count, step; // of the row in padded arrays; from the cell below a face to the one above
    std::span<const double> p, gap, speed;
    std::span<const double> length, lowerShare, width; // of the paths
    std::span<const double> mobility, mobilityByPressure;
    double viscosity;
};

template <ConvectionScheme scheme, typename Number>
TOUCHDOWN_VECTOR_CLONES void setSmoothFaces(FilmFaces& faces, const FaceRow& row)
{
    const double* p = row.p.data() + row.first - row.step;
    const double* gap = row.gap.data() + row.first;
    const double* speed = row.speed.data() + row.first;
    const double *length = row.length.data(), *lowerShare = row.lowerShare.data(), *width = row.width.data();
    const double *G = row.mobility.data(), *byPressure = row.mobilityByPressure.data();
    const std::size_t step = row.step, first = row.first;
    const double viscosity = row.viscosity;
#pragma GCC ivdep
    for (std::size_t k = 0; k < row.count; ++k) {
        Number mobility(G[k]);
        if constexpr (!std::is_same_v<Number, double>) mobility.by[0] = byPressure[k];
        const PathFlow<Number> flow = smoothFlow<scheme>(SmoothPath{length[k], lowerShare[k], width[k]}, viscosity, speed[k],
                                                         Number(gap[k]), mobility);
        setFace(faces, first + k, flow, speed[k] < 0.0, p[k], p[k + step]);
    }
}

} // namespace

template <typename Number>
PathFlow<Number> GasFilm::cutFlow(std::size_t axis, const CutPlace& place, const Number& pm) const
{
    // Upstream to downstream: against the axis where the disk moves so.
    const double speed = axes_[axis].speed[place.at];
    const bool against = speed < 0.0;
    double total = 0.0;
    for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) total += gaps_.rows[r].width;
    PathFlow<Number> sum;
    for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) {
        const GapRow& row = gaps_.rows[r];
        const std::uint32_t count = row.pieceEnd - row.pieces;
        PathIntegral<Number> path;
        bool open = true;
        for (std::uint32_t k = 0; open && k < count; ++k) {
            const GapPiece& piece = gaps_.pieces[against ? row.pieceEnd - 1 - k : row.pieces + k];
            Number resistance, peclet;
            open = pieceOf(piece, std::abs(speed), pm, resistance, peclet);
            if (open) path.add(resistance, peclet, against ? -piece.start - piece.extent : piece.start, piece.extent);
        }
        if (open) sum.add(path, row.width, row.width / total, against);
    }
    return sum;
}

template PathFlow<double> GasFilm::cutFlow(std::size_t, const CutPlace&, const double&) const;
template PathFlow<Dual<3>> GasFilm::cutFlow(std::size_t, const CutPlace&, const Dual<3>&) const;

template <ConvectionScheme scheme, typename Number>
void GasFilm::setFaceFlows(std::size_t axis, std::span<const double> p)
{
    const PaddedGrid& pad = gaps_.pad;
    const AxisState& a = axes_[axis];
    const FilmGaps::Faces& paths = gaps_.faces[axis];
    const std::size_t step = pad.step(static_cast<int>(axis));
    const std::size_t count = static_cast<std::size_t>(pad.nx + (axis == 0));
    for (int j = 0; j < pad.ny + (axis == 1); ++j) {
        const std::size_t first = pad.at(0, j);
        for (std::size_t k = 0; k < count; ++k) {
            const double h = a.gap[first + k];
            const FlowTable::Value g = table_.at(0.5 * (p[first + k - step] + p[first + k]) * h, h);
            mobility_[k] = g.mobility;
            mobilityByPressure_[k] = g.derivative * h;
        }
        FaceRow row{first, count, step, p, a.gap, a.speed, paths.pathLength, paths.upperShare, a.width, mobility_,
                    mobilityByPressure_, setting_.air.viscosity};
        if (axis == 0) {
            std::fill(rowWidth_.begin(), rowWidth_.end(), a.width[static_cast<std::size_t>(j)]);
            row.width = rowWidth_;
        } else {
            std::fill(rowLength_.begin(), rowLength_.end(), paths.pathLength[static_cast<std::size_t>(j)]);
            std::fill(rowShare_.begin(), rowShare_.end(), paths.upperShare[static_cast<std::size_t>(j)]);
            row.length = rowLength_;
            row.lowerShare = rowShare_;
        }
        setSmoothFaces<scheme, Number>(faces_[axis], row);
    }
    for (const CutPlace& place : paths.cut) {
        const double p1 = p[place.at - step], p2 = p[place.at];
        setFace(faces_[axis], place.at, cutFlow(axis, place, meanPressure<Number>(p1, p2)), a.speed[place.at] < 0.0, p1, p2);
    }
}

template <typename Number>
void GasFilm::setFaceFlows(std::span<const double> p)
{
    for (std::size_t axis = 0; axis < 2; ++axis) switch (setting_.scheme) {
            using enum ConvectionScheme;
        case Upwind: setFaceFlows<Upwind, Number>(axis, p); break;
        case Hybrid: setFaceFlows<Hybrid, Number>(axis, p); break;
        case PowerLaw: setFaceFlows<PowerLaw, Number>(axis, p); break;
        case Exponential: setFaceFlows<Exponential, Number>(axis, p); break;
        case CompleteFlux: setFaceFlows<CompleteFlux, Number>(axis, p); break;
        }
}

template void GasFilm::setFaceFlows<double>(std::span<const double>);
template void GasFilm::setFaceFlows<Dual<1>>(std::span<const double>);

} // namespace touchdown
