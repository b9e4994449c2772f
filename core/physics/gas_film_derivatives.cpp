// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of flows over cells, and what the film's residual answers to small changes of the pressure and of the attitude.
#include <algorithm>
#include <complex>

#include "core/physics/gas_film.h"

namespace touchdown {

template <typename T>
void GasFilm::setSlopes(FaceFlows<T>& flows) const
{
    const PaddedGrid& pad = gaps_.pad;
    const std::size_t up = pad.stride();
    for (int j = 0; j < pad.ny; ++j) {
        const double perWidthY = axes_[1].perWidth[static_cast<std::size_t>(j)];
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            flows.slope[0][at] = (flows.flow[1][at] - flows.flow[1][at + up]) * axes_[0].perWidth[static_cast<std::size_t>(i)];
            flows.slope[1][at] = (flows.flow[0][at] - flows.flow[0][at + 1]) * perWidthY;
        }
    }
    // Beside a step the flow across leaves by the deep side alone: spread over the cell it would starve the rail.
    for (const std::size_t at : gaps_.steppedCells) flows.slope[0][at] = flows.slope[1][at] = T{};
}

template <typename T>
void GasFilm::completeChanges(FaceFlows<T>& flows) const
{
    const PaddedGrid& pad = gaps_.pad;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t step = pad.step(static_cast<int>(axis));
        const std::vector<T>& slope = flows.slope[axis];
        const FilmFaces& f = faces_[axis];
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t at = pad.at(i, j);
                flows.flow[axis][at] -= f.share[at] * (slope[at - step] * f.below[at] + slope[at] * f.above[at]);
            }
    }
}

template <typename T>
void GasFilm::divergence(const FaceFlows<T>& flows, std::span<T> out) const
{
    const PaddedGrid& pad = gaps_.pad;
    const std::size_t up = pad.stride();
    const std::vector<T>&x = flows.flow[0], &y = flows.flow[1];
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            out[at] = (x[at + 1] - x[at]) + (y[at + up] - y[at]);
        }
}

template void GasFilm::setSlopes(FaceFlows<double>&) const;
template void GasFilm::completeChanges(FaceFlows<double>&) const;
template void GasFilm::divergence(const FaceFlows<double>&, std::span<double>) const;

template <typename T>
void GasFilm::applyJacobian(std::span<const T> v, std::span<T> out, FaceFlows<T>& work) const
{
    const PaddedGrid& pad = gaps_.pad;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const FilmFaces& f = faces_[axis];
        const std::size_t step = pad.step(static_cast<int>(axis));
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t at = pad.at(i, j);
                work.flow[axis][at] = f.lower[at] * v[at - step] + f.upper[at] * v[at];
            }
    }
    if (complete()) {
        setSlopes(work);
        completeChanges(work);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const FilmFaces& f = faces_[axis];
            const std::size_t step = pad.step(static_cast<int>(axis));
            for (int j = 0; j < pad.ny + (axis == 1); ++j)
                for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                    const std::size_t at = pad.at(i, j);
                    work.flow[axis][at] += f.ownLower[at] * v[at - step] + f.ownUpper[at] * v[at];
                }
        }
    }
    divergence<T>(work, out);
}

template void GasFilm::applyJacobian(std::span<const double>, std::span<double>, FaceFlows<double>&) const;
template void GasFilm::applyJacobian(std::span<const std::complex<double>>, std::span<std::complex<double>>,
                                     FaceFlows<std::complex<double>>&) const;

void GasFilm::applyTransposedJacobian(std::span<const double> v, std::span<double> out, FaceFlows<double>& work) const
{
    // Backwards through applyJacobian: a face's flow leaves the cell below and enters the one above.
    const PaddedGrid& pad = gaps_.pad;
    std::fill(out.begin(), out.end(), 0.0);
    for (auto& slope : work.slope) std::fill(slope.begin(), slope.end(), 0.0);
    const auto forFaces = [&](auto&& visit) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::size_t step = pad.step(static_cast<int>(axis));
            for (int j = 0; j < pad.ny + (axis == 1); ++j)
                for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                    const std::size_t at = pad.at(i, j);
                    visit(axis, at, at - step);
                }
        }
    };
    forFaces([&](std::size_t axis, std::size_t at, std::size_t before) {
        const FilmFaces& f = faces_[axis];
        const double drop = v[before] - v[at];
        work.flow[axis][at] = drop;
        if (!complete()) return;
        work.slope[axis][before] -= f.share[at] * f.below[at] * drop;
        work.slope[axis][at] -= f.share[at] * f.above[at] * drop;
        out[before] += f.ownLower[at] * drop;
        out[at] += f.ownUpper[at] * drop;
    });
    for (const std::size_t at : gaps_.steppedCells) work.slope[0][at] = work.slope[1][at] = 0.0;
    if (complete())
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j), up = pad.stride();
                const double alongX = work.slope[0][at] * axes_[0].perWidth[static_cast<std::size_t>(i)];
                const double alongY = work.slope[1][at] * axes_[1].perWidth[static_cast<std::size_t>(j)];
                work.flow[1][at] += alongX;
                work.flow[1][at + up] -= alongX;
                work.flow[0][at] += alongY;
                work.flow[0][at + 1] -= alongY;
            }
    forFaces([&](std::size_t axis, std::size_t at, std::size_t before) {
        const FilmFaces& f = faces_[axis];
        out[before] += f.lower[at] * work.flow[axis][at];
        out[at] += f.upper[at] * work.flow[axis][at];
    });
    clearRings(out);
    for (auto& slope : work.slope) clearRings(slope);
}

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
            set(at, smoothFlow<scheme>(SmoothPath{paths.pathLength[line], paths.upperShare[line], width},
                                       setting_.air.viscosity, a.speed[at], gap, mobility(ByGap(0.5 * (p1 + p2)), gap)),
                p1, p2, [&](const ByGap& number, std::size_t k) { return number.by[0] * lift[k]; });
        }
    for (const CutPlace& place : gaps_.faces[axis].cut) {
        const double p1 = p[place.at - step], p2 = p[place.at];
        set(place.at, cutFlow(axis, place, ByAttitude(0.5 * (p1 + p2))), p1, p2,
            [](const ByAttitude& number, std::size_t k) { return number.by[k]; });
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

} // namespace touchdown
