// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flows through faces with their derivatives by the pressure and by the attitude, in passes: the mobility from its
// table; all that runs on vectors; and for cut faces, what their pieces amount to.
#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"

namespace touchdown {

/// Those that are cut pass nothing here.
struct GasFilm::FaceRow {
    std::size_t first, count, step; // of the row in padded arrays; from the cell below a face to the one above
    std::span<const double> p, gap, tilt, speed;
    std::span<const double> length, lowerShare, width; // of the paths
    std::span<const double> mobility, mobilityByProduct;
    double viscosity, leastGap;
};

namespace {

using ByPressure = Dual<1>;

/// Face number k of a row, `at` in padded arrays.
void setFace(FilmFaces& f, FaceMoments& m, std::size_t at, std::size_t k, const PathFlow<double>& flow, bool against,
             double p1, double p2)
{
    f.flow[at] = flow.A * p1 - flow.B * p2;
    f.inflow[at] = against ? flow.B * p2 : flow.A * p1;
    m.below[k] = flow.below;
    m.above[k] = flow.above;
}

void setFace(FilmFaces& f, FaceMoments& m, std::size_t at, std::size_t k, const PathFlow<ByPressure>& flow,
             bool against, double p1, double p2)
{
    const double A = flow.A.value, B = flow.B.value;
    setFace(f, m, at, k, PathFlow<double>{A, B, flow.K.value, flow.below.value, flow.above.value}, against, p1, p2);
    const double byMeanA = 0.5 * flow.A.by[0] * p1, byMeanB = 0.5 * flow.B.by[0] * p2;
    const double lower = A + (byMeanA - byMeanB), upper = (byMeanA - byMeanB) - B;
    f.lower[at] = lower;
    f.upper[at] = upper;
    m.belowByMean[k] = flow.below.by[0];
    m.aboveByMean[k] = flow.above.by[0];
    m.inflowByLower[k] = against ? byMeanB : A + byMeanA;
    m.inflowByUpper[k] = against ? B + byMeanB : byMeanA;
    f.diffusion[at] = flow.K.value;
    f.convection[at] = lower + upper;
    f.effective[at] = std::max(0.5 * (A + B), 0.5 * std::abs(lower + upper));
}

/// Mean pressure times gap; any number where the gap is closed.
TOUCHDOWN_VECTOR_CLONES void setProducts(std::size_t count, const double* below, const double* above, const double* gap,
                                         double* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = 0.5 * (below[k] + above[k]) * (gap[k] > closedGap ? gap[k] : 1e-6);
}

template <ConvectionScheme scheme, typename Number, typename FaceRow>
TOUCHDOWN_VECTOR_CLONES void setSmoothFaces(FilmFaces& faces, FaceMoments& moments, const FaceRow& row)
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
        const PathFlow<Number> flow = smoothFlow<scheme>(SmoothPath{length[k], lowerShare[k], width[k]}, viscosity,
                                                         speed[k], Number(gap[k]), Number(tilt[k]), mobility);
        setFace(faces, moments, first + k, k, flow, speed[k] < 0.0, p[k], p[k + step]);
    }
}

/// Derivatives of the flows by the gap and by its change along the path; `byGap`: that of the mobility by the gap.
template <ConvectionScheme scheme, typename FaceRow>
TOUCHDOWN_VECTOR_CLONES void setSmoothSlopes(GapSlopes& out, const FilmFaces& faces, const double* slope,
                                             const double* byGap, const FaceRow& row)
{
    using Number = Dual<2>; // gap, its change
    const std::size_t step = row.step, first = row.first;
    const double *below = row.p.data() + first - step, *above = row.p.data() + first, *before = slope - step;
    const double *gap = row.gap.data() + first, *tilt = row.tilt.data() + first, *speed = row.speed.data() + first;
    const double *length = row.length.data(), *lowerShare = row.lowerShare.data(), *width = row.width.data();
    const double *G = row.mobility.data(), *byProduct = row.mobilityByProduct.data();
    const double *share = faces.share.data() + first, *inflowShare = faces.inflowShare.data() + first;
    double *flowByGap = out.flowByGap.data() + first, *flowByRise = out.flowByRise.data() + first;
    double *ownByGap = out.ownByGap.data() + first, *ownByRise = out.ownByRise.data() + first;
    const double viscosity = row.viscosity, least = std::max(row.leastGap, closedGap);
#pragma GCC ivdep
    for (std::size_t k = 0; k < row.count; ++k) {
        const double p1 = below[k], p2 = above[k];
        const bool open = gap[k] > least, free = open && std::abs(tilt[k]) < 1.0;
        const double perGap = free ? 1.0 / (open ? gap[k] : 1.0) : 0.0;
        Number h(gap[k]), e(tilt[k]), mobility(G[k]);
        h.by = {open ? 1.0 : 0.0, 0.0};
        e.by = {-tilt[k] * perGap, perGap};
        mobility.by[0] = open ? byProduct[k] * (0.5 * (p1 + p2)) + byGap[k] : 0.0;
        const PathFlow<Number> flow =
            smoothFlow<scheme>(SmoothPath{length[k], lowerShare[k], width[k]}, viscosity, speed[k], h, e, mobility);
        const Number passed = flow.A * Number(p1) - flow.B * Number(p2);
        const Number inflow = select(speed[k] < 0.0, flow.B * Number(p2), flow.A * Number(p1));
        const Number correction = share[k] * (before[k] * flow.below + slope[k] * flow.above) + inflowShare[k] * inflow;
        flowByGap[k] = passed.by[0];
        flowByRise[k] = passed.by[1];
        ownByGap[k] = -correction.by[0];
        ownByRise[k] = -correction.by[1];
    }
}

} // namespace

GasFilm::FaceRow GasFilm::smoothRow(std::size_t axis, int j, std::span<const double> p, FaceWork& work) const
{
    const PaddedGrid& pad = gaps().pad;
    const Axis& a = axes()[axis];
    const FilmGaps::Faces& paths = gaps().faces[axis];
    const std::size_t step = pad.step(static_cast<int>(axis));
    const std::size_t first = pad.at(0, j), count = static_cast<std::size_t>(pad.nx + (axis == 0));
    const double *gap = a.gap.data() + first, *below = p.data() + first - step, *above = p.data() + first;
    setProducts(count, below, above, gap, work.product.data());
    table_.at({work.product.data(), count}, {gap, count}, work.mobility, work.mobilityByProduct);
    FaceRow row{first,
                count,
                step,
                p,
                a.gap,
                a.tilt,
                a.speed,
                paths.pathLength,
                paths.upperShare,
                a.width,
                work.mobility,
                work.mobilityByProduct,
                setting_.air.viscosity,
                leastGap()};
    if (axis == 0) {
        std::fill(work.width.begin(), work.width.end(), a.width[static_cast<std::size_t>(j)]);
        row.width = work.width;
    } else {
        std::fill(work.length.begin(), work.length.end(), paths.pathLength[static_cast<std::size_t>(j)]);
        std::fill(work.share.begin(), work.share.end(), paths.upperShare[static_cast<std::size_t>(j)]);
        row.length = work.length;
        row.lowerShare = work.share;
    }
    return row;
}

template <typename Number>
void GasFilm::setCutFlows(std::span<const double> p)
{
    const auto set = [&](auto& flows) {
        for (std::size_t axis = 0; axis < 2; ++axis)
            axes()[axis].cutPaths.flows(p, attitude(), axes()[axis].cutSurface, table_, air().viscosity, cutWork_,
                                        flows[axis]);
    };
    if constexpr (std::is_same_v<Number, double>)
        set(cutFlows_);
    else
        set(cutFlowsByPressure_);
}

template <ConvectionScheme scheme, typename Number>
void GasFilm::setFaceRow(std::size_t axis, int j, std::span<const double> p, RowWork& work)
{
    FaceMoments& moments = work.moments[axis][work.slot(j)];
    const FaceRow row = smoothRow(axis, j, p, work.face);
    setSmoothFaces<scheme, Number>(faces_[axis], moments, row);
    const std::vector<std::size_t>& rows = cutRows_[axis];
    const auto setCut = [&](const auto& flows) {
        for (std::size_t n = rows[static_cast<std::size_t>(j)]; n < rows[static_cast<std::size_t>(j) + 1]; ++n) {
            const std::size_t at = gaps().faces[axis].cut[n].at;
            setFace(faces_[axis], moments, at, at - row.first, flows[n], row.speed[at] < 0.0, p[at - row.step], p[at]);
        }
    };
    if constexpr (std::is_same_v<Number, double>)
        setCut(cutFlows_[axis]);
    else
        setCut(cutFlowsByPressure_[axis]);
}

template <typename Number>
void GasFilm::setFaceRow(std::size_t axis, int j, std::span<const double> p, RowWork& work)
{
    switch (setting_.scheme) {
        using enum ConvectionScheme;
    case Upwind: return setFaceRow<Upwind, Number>(axis, j, p, work);
    case Hybrid: return setFaceRow<Hybrid, Number>(axis, j, p, work);
    case PowerLaw: return setFaceRow<PowerLaw, Number>(axis, j, p, work);
    case Exponential: return setFaceRow<Exponential, Number>(axis, j, p, work);
    case CompleteFlux: return setFaceRow<CompleteFlux, Number>(axis, j, p, work);
    }
}

template void GasFilm::setCutFlows<double>(std::span<const double>);
template void GasFilm::setCutFlows<Dual<1>>(std::span<const double>);
template void GasFilm::setFaceRow<double>(std::size_t, int, std::span<const double>, RowWork&);
template void GasFilm::setFaceRow<Dual<1>>(std::size_t, int, std::span<const double>, RowWork&);

template <ConvectionScheme scheme>
void GasFilm::setGapSlopes(std::size_t axis, std::span<const double> p, AttitudeWork& work) const
{
    FaceWork& w = work.row;
    for (int j = 0; j < gaps().pad.ny + (axis == 1); ++j) {
        const FaceRow row = smoothRow(axis, j, p, w);
        const double* gap = axes()[axis].gap.data() + row.first;
        for (std::size_t k = 0; k < row.count; ++k) w.mobilityByGap[k] = table_.gapDerivative(w.product[k], gap[k]);
        setSmoothSlopes<scheme>(work.slopes[axis], faces_[axis], slope_[axis].data() + row.first,
                                w.mobilityByGap.data(), row);
    }
}

void GasFilm::setGapSlopes(std::span<const double> p, AttitudeWork& work) const
{
    for (std::size_t axis = 0; axis < 2; ++axis) switch (setting_.scheme) {
            using enum ConvectionScheme;
        case Upwind: setGapSlopes<Upwind>(axis, p, work); break;
        case Hybrid: setGapSlopes<Hybrid>(axis, p, work); break;
        case PowerLaw: setGapSlopes<PowerLaw>(axis, p, work); break;
        case Exponential: setGapSlopes<Exponential>(axis, p, work); break;
        case CompleteFlux: setGapSlopes<CompleteFlux>(axis, p, work); break;
        }
}

} // namespace touchdown
