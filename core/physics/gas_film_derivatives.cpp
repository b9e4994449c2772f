// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of flows over cells, and what the film's residual answers to small changes of the pressure.
#include <algorithm>
#include <complex>

#include "core/physics/gas_film.h"

namespace touchdown {

template <typename T>
void GasFilm::setStored(std::span<const T> v, T perTime, FaceFlows<T>& flows) const
{
    flows.stored.resize(perTime != T{} ? v.size() : 0);
    for (std::size_t at = 0; at < flows.stored.size(); ++at) flows.stored[at] = perTime * volume_[at] * v[at];
}

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
    // Both slopes in full would take a cell's storage from it twice: each axis counts what is its own of the motion's square.
    if (!flows.stored.empty())
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j);
                flows.slope[0][at] -= flows.stored[at] * (motionShare_[0] * axes_[0].perWidth[static_cast<std::size_t>(i)]);
                flows.slope[1][at] -= flows.stored[at] * (motionShare_[1] * axes_[1].perWidth[static_cast<std::size_t>(j)]);
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
    for (std::size_t at = 0; at < flows.stored.size(); ++at) out[at] += flows.stored[at];
}

template void GasFilm::setStored(std::span<const double>, double, FaceFlows<double>&) const;
template void GasFilm::setSlopes(FaceFlows<double>&) const;
template void GasFilm::completeChanges(FaceFlows<double>&) const;
template void GasFilm::divergence(const FaceFlows<double>&, std::span<double>) const;

void GasFilm::ownOperator(std::size_t axis, std::span<double> effective, std::span<double> convection) const
{
    const PaddedGrid& pad = gaps_.pad;
    const FilmFaces& f = faces_[axis];
    std::copy(f.effective.begin(), f.effective.end(), effective.begin());
    std::copy(f.convection.begin(), f.convection.end(), convection.begin());
    if (!complete() || storagePerTime_ == 0.0) return;
    const std::size_t step = pad.step(static_cast<int>(axis));
    const std::vector<double>& perWidth = axes_[axis].perWidth;
    const int last = (axis == 0 ? pad.nx : pad.ny) - 1;
    for (int j = 0; j < pad.ny + (axis == 1); ++j)
        for (int i = 0; i < pad.nx + (axis == 0); ++i) {
            const std::size_t at = pad.at(i, j);
            const int line = axis == 0 ? i : j;
            const double scale = f.share[at] * storagePerTime_ * motionShare_[axis]; // volumes in the rings are zero
            const double below = scale * f.below[at] * volume_[at - step] * perWidth[static_cast<std::size_t>(std::max(line - 1, 0))];
            const double above = scale * f.above[at] * volume_[at] * perWidth[static_cast<std::size_t>(std::min(line, last))];
            convection[at] += below + above;
            effective[at] += 0.5 * (below - above);
        }
}

template <typename T>
void GasFilm::applyJacobian(std::span<const T> v, std::span<T> out, FaceFlows<T>& work, T perTime) const
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
    setStored(v, perTime, work);
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

template void GasFilm::applyJacobian(std::span<const double>, std::span<double>, FaceFlows<double>&, double) const;
template void GasFilm::applyJacobian(std::span<const std::complex<double>>, std::span<std::complex<double>>,
                                     FaceFlows<std::complex<double>>&, std::complex<double>) const;

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
                out[at] -= storagePerTime_ * volume_[at] * (motionShare_[0] * alongX + motionShare_[1] * alongY);
            }
    forFaces([&](std::size_t axis, std::size_t at, std::size_t before) {
        const FilmFaces& f = faces_[axis];
        out[before] += f.lower[at] * work.flow[axis][at];
        out[at] += f.upper[at] * work.flow[axis][at];
    });
    for (std::size_t at = 0; at < out.size(); ++at) out[at] += storagePerTime_ * volume_[at] * v[at];
    clearRings(out);
    for (auto& slope : work.slope) clearRings(slope);
}

} // namespace touchdown
