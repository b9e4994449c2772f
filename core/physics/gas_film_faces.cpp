// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flows through faces with their derivatives by the pressure and by the attitude, in passes: the mobility from its table; all
// that runs on vectors; and for cut faces, what their pieces amount to.
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

/// One row of faces; those that are cut pass nothing here.
struct FaceRow {
    std::size_t first, count, step; // of the row in padded arrays; from the cell below a face to the one above
    std::span<const double> p, gap, tilt, speed;
    std::span<const double> length, lowerShare, width; // of the paths
    std::span<const double> mobility, mobilityByProduct;
    double viscosity;
};

/// Mean pressure times gap; any number where the gap is closed.
TOUCHDOWN_VECTOR_CLONES void setProducts(std::size_t count, const double* below, const double* above, const double* gap, double* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = 0.5 * (below[k] + above[k]) * (gap[k] > closedGap ? gap[k] : 1e-6);
}

template <ConvectionScheme scheme, typename Number>
TOUCHDOWN_VECTOR_CLONES void setSmoothFaces(FilmFaces& faces, const FaceRow& row)
{
    const double* p = row.p.data() + row.first - row.step;
    const double* gap = row.gap.data() + row.first;
    const double* tilt = row.tilt.data() + row.first;
    const double* speed = row.speed.data() + row.first;
    const double *length = row.length.data(), *lowerShare = row.lowerShare.data(), *width = row.width.data();
    const double *G = row.mobility.data(), *byProduct = row.mobilityByProduct.data();
    const std::size_t step = row.step, first = row.first;
    const double viscosity = row.viscosity;
#pragma GCC ivdep
    for (std::size_t k = 0; k < row.count; ++k) {
        Number mobility(G[k]);
        if constexpr (!std::is_same_v<Number, double>) mobility.by[0] = byProduct[k] * gap[k];
        const PathFlow<Number> flow = smoothFlow<scheme>(SmoothPath{length[k], lowerShare[k], width[k]}, viscosity, speed[k],
                                                         Number(gap[k]), Number(tilt[k]), mobility);
        setFace(faces, first + k, flow, speed[k] < 0.0, p[k], p[k + step]);
    }
}

} // namespace

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
        const double *gap = a.gap.data() + first, *below = p.data() + first - step, *above = p.data() + first;
        setProducts(count, below, above, gap, rowProduct_.data());
        table_.at({rowProduct_.data(), count}, {gap, count}, mobility_, mobilityByProduct_);
        FaceRow row{first, count, step, p, a.gap, a.tilt, a.speed, paths.pathLength, paths.upperShare, a.width, mobility_,
                    mobilityByProduct_, setting_.air.viscosity};
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
    const auto setCut = [&](auto& flows) {
        cutPaths_[axis].flows(p, attitude_, a.cutSurface, table_, setting_.air.viscosity, cutWork_, flows);
        for (std::size_t n = 0; n < flows.size(); ++n) {
            const std::size_t at = paths.cut[n].at;
            setFace(faces_[axis], at, flows[n], a.speed[at] < 0.0, p[at - step], p[at]);
        }
    };
    if constexpr (std::is_same_v<Number, double>) setCut(cutFlows_);
    else setCut(cutFlowsByPressure_);
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

template <ConvectionScheme scheme>
void GasFilm::setAttitudeFlows(std::size_t axis, std::span<const double> p, std::array<FaceFlows<double>, 3>& flows,
                               std::array<std::array<std::vector<double>, 2>, 3>& own) const
{
    const PaddedGrid& pad = gaps_.pad;
    const AxisState& a = axes_[axis];
    const FilmFaces& f = faces_[axis];
    const FilmGaps::Faces& paths = gaps_.faces[axis];
    const std::size_t step = pad.step(static_cast<int>(axis));
    const auto set = [&](std::size_t at, const auto& flow, double p1, double p2, const auto& by) {
        const double before = flows_.slope[axis][at - step], after = flows_.slope[axis][at];
        for (std::size_t k = 0; k < 3; ++k) {
            flows[k].flow[axis][at] = by(flow.A, k) * p1 - by(flow.B, k) * p2;
            const double inflow = a.speed[at] < 0.0 ? by(flow.B, k) * p2 : by(flow.A, k) * p1;
            own[k][axis][at] = -f.share[at] * (before * by(flow.below, k) + after * by(flow.above, k)) -
                               f.inflowShare[at] * inflow;
        }
    };
    for (int j = 0; j < pad.ny + (axis == 1); ++j)
        for (int i = 0; i < pad.nx + (axis == 0); ++i) {
            const std::size_t at = pad.at(i, j);
            const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
            const double width = a.width[static_cast<std::size_t>(axis == 0 ? j : i)];
            const double p1 = p[at - step], p2 = p[at], middle = gaps_.faces[axis].pathMid[line];
            const std::array<double, 3> lift = axis == 0 ? liftDirections(middle, gaps_.grid.centreY(j))
                                                         : liftDirections(gaps_.grid.centreX(i), middle);
            const ByGap gap = ByGap::variable(a.gap[at], 0);
            ByGap tilt(a.tilt[at]);
            if (std::abs(tilt.value) < 1.0 && gap.value > closedGap) tilt = ByGap::variable(tilt.value * gap.value, 1) / gap;
            const double length = paths.pathLength[line];
            const std::array<double, 3> rise{0.0, axis == 0 ? -length : 0.0, axis == 0 ? 0.0 : -length};
            set(at, smoothFlow<scheme>(SmoothPath{paths.pathLength[line], paths.upperShare[line], width},
                                       setting_.air.viscosity, a.speed[at], gap, tilt, mobility(ByGap(0.5 * (p1 + p2)), gap)),
                p1, p2, [&](const ByGap& number, std::size_t k) { return number.by[0] * lift[k] + number.by[1] * rise[k]; });
        }
    CutPaths::Work work(gaps_);
    std::vector<PathFlow<ByAttitude>> cutFlows;
    cutPaths_[axis].flows(p, attitude_, a.cutSurface, table_, setting_.air.viscosity, work, cutFlows);
    for (std::size_t n = 0; n < cutFlows.size(); ++n) {
        const std::size_t at = paths.cut[n].at;
        set(at, cutFlows[n], p[at - step], p[at], [](const ByAttitude& number, std::size_t k) { return number.by[k]; });
    }
}

void GasFilm::setAttitudeStorage(std::span<const double> p, double perTime, std::array<FaceFlows<double>, 3>& flows) const
{
    for (FaceFlows<double>& f : flows) f.stored.assign(p.size(), 0.0);
    const auto add = [&](std::size_t at, double area, double x, double y) {
        const std::array<double, 3> lift = liftDirections(x, y);
        for (std::size_t k = 0; k < 3; ++k) flows[k].stored[at] += perTime * p[at] * area * lift[k];
    };
    for (int j = 0; j < gaps_.pad.ny; ++j)
        for (int i = 0; i < gaps_.pad.nx; ++i) {
            const std::size_t at = gaps_.pad.at(i, j);
            if (volume_[at] > 0.0) add(at, area_[at], gaps_.grid.centreX(i), gaps_.grid.centreY(j));
        }
    for (const CutPlace& cell : gaps_.cutCells) {
        for (FaceFlows<double>& f : flows) f.stored[cell.at] = 0.0;
        for (std::uint32_t k = gaps_.rows[cell.rows].pieces; k < gaps_.rows[cell.rows].pieceEnd; ++k) {
            const GapPiece& piece = gaps_.pieces[k];
            if (gapOf<double>(piece, surfaceAt(cell.at)) > 0.0) add(cell.at, piece.extent, piece.x, piece.y);
        }
    }
}

void GasFilm::attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out) const
{
    const std::size_t size = gaps_.pad.size();
    std::array<FaceFlows<double>, 3> flows;
    std::array<std::array<std::vector<double>, 2>, 3> own;
    for (std::size_t k = 0; k < 3; ++k) {
        flows[k].resize(size);
        for (auto& field : own[k]) field.assign(size, 0.0);
        out[k].assign(size, 0.0);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) switch (setting_.scheme) {
            using enum ConvectionScheme;
        case Upwind: setAttitudeFlows<Upwind>(axis, p, flows, own); break;
        case Hybrid: setAttitudeFlows<Hybrid>(axis, p, flows, own); break;
        case PowerLaw: setAttitudeFlows<PowerLaw>(axis, p, flows, own); break;
        case Exponential: setAttitudeFlows<Exponential>(axis, p, flows, own); break;
        case CompleteFlux: setAttitudeFlows<CompleteFlux>(axis, p, flows, own); break;
        }
    if (storagePerTime_ != 0.0) setAttitudeStorage(p, storagePerTime_, flows);
    for (std::size_t k = 0; k < 3; ++k) {
        if (complete()) {
            setSlopes(flows[k]);
            completeChanges(flows[k]);
            for (std::size_t axis = 0; axis < 2; ++axis)
                for (std::size_t at = 0; at < size; ++at) flows[k].flow[axis][at] += own[k][axis][at];
        }
        divergence<double>(flows[k], out[k]);
    }
}

void GasFilm::attitudeStorageColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out) const
{
    std::array<FaceFlows<double>, 3> flows;
    setAttitudeStorage(p, 1.0, flows);
    for (std::size_t k = 0; k < 3; ++k) {
        flows[k].resize(p.size());
        out[k].assign(p.size(), 0.0);
        if (complete()) {
            setSlopes(flows[k]);
            completeChanges(flows[k]);
        }
        divergence<double>(flows[k], out[k]);
    }
}

} // namespace touchdown
