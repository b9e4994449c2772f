// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of flows over cells, and the change of the film's residual with small changes of the pressure.
#include <algorithm>
#include <complex>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

/// Flows through a row of faces, by the cells below and above.
template <typename T>
TOUCHDOWN_VECTOR_CLONES void setFlows(std::size_t count, const double* lower, const double* upper, const T* below,
                                      const T* above, T* flow)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) flow[k] = lower[k] * below[k] + upper[k] * above[k];
}

/// Storage of a row of cells, perTime V v; on vectors, a product of complex numbers.
template <typename T>
void setStoredRow(std::size_t count, T perTime, const double* volume, const T* v, T* stored)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) stored[k] = perTime * volume[k] * v[k];
}

template <typename T>
TOUCHDOWN_VECTOR_CLONES void scaleRow(std::size_t count, double scale, const T* in, T* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = scale * in[k];
}

/// Mass balance of a row of cells: change of the flow along x = -change of the flow along y - storage.
template <typename T>
TOUCHDOWN_VECTOR_CLONES void setSlopeRow(std::size_t count, const double* perWidth, double perWidthAcross,
                                         const T* flowX, const T* flowY, const T* flowYAbove, const T* stored,
                                         T* slopeX, T* slopeY)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        slopeX[k] = ((flowY[k] - flowYAbove[k]) - stored[k]) * perWidth[k];
        slopeY[k] = ((flowX[k] - flowX[k + 1]) - stored[k]) * perWidthAcross;
    }
}

template <typename T>
TOUCHDOWN_VECTOR_CLONES void addPassedRow(std::size_t count, const double* below, const double* above,
                                          const T* sourceBelow, const T* sourceAbove, const T* flow, T* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = flow[k] + (below[k] * sourceBelow[k] + above[k] * sourceAbove[k]);
}

/// Subtracts from the flows through a row of faces the corrections by the slopes in the cells below and above.
template <typename T>
TOUCHDOWN_VECTOR_CLONES void completeRow(std::size_t count, const double* share, const double* below,
                                         const double* above, const T* slopeBelow, const T* slopeAbove, T* flow)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) flow[k] -= share[k] * (slopeBelow[k] * below[k] + slopeAbove[k] * above[k]);
}

/// Also adds the change of the corrections with the pressures in the cells below and above.
template <typename T>
TOUCHDOWN_VECTOR_CLONES void
completeRow(std::size_t count, const double* share, const double* below, const double* above, const double* ownLower,
            const double* ownUpper, const T* slopeBelow, const T* slopeAbove, const T* vBelow, const T* vAbove, T* flow)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k)
        flow[k] = (flow[k] - share[k] * (slopeBelow[k] * below[k] + slopeAbove[k] * above[k])) +
                  (ownLower[k] * vBelow[k] + ownUpper[k] * vAbove[k]);
}

template <typename T>
TOUCHDOWN_VECTOR_CLONES void divergeRow(std::size_t count, const T* flowX, const T* flowY, const T* flowYAbove,
                                        const T* stored, T* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k)
        out[k] = ((flowX[k + 1] - flowX[k]) + (flowYAbove[k] - flowY[k])) + stored[k];
}

} // namespace

template <typename T>
void GasFilm::setSlopes(int j, const T* flowX, const T* flowY, const T* flowYAbove, const T* stored, T* slopeX,
                        T* slopeY) const
{
    setSlopeRow(static_cast<std::size_t>(gaps().pad.nx), axes()[0].perWidth.data(),
                axes()[1].perWidth[static_cast<std::size_t>(j)], flowX, flowY, flowYAbove, stored, slopeX, slopeY);
    clearStepped(j, slopeX);
    clearStepped(j, slopeY);
}

/// Beside a step the flow across leaves by the deep side alone: spread over the cell it would starve the rail.
template <typename T>
void GasFilm::clearStepped(int j, T* slope) const
{
    const std::size_t first = gaps().pad.at(0, j), row = static_cast<std::size_t>(j);
    for (std::size_t n = steppedRows_[row]; n < steppedRows_[row + 1]; ++n) slope[gaps().steppedCells[n] - first] = T{};
}

template <typename T>
void GasFilm::setSource(int j, const T* stored, T* source) const
{
    const std::size_t nx = static_cast<std::size_t>(gaps().pad.nx);
    if (j >= gaps().pad.ny) {
        std::fill_n(source, nx, T{});
        return;
    }
    scaleRow(nx, axes()[1].perWidth[static_cast<std::size_t>(j)], stored, source);
    clearStepped(j, source);
}

template <typename T>
void GasFilm::addPassed(const double* below, const double* above, const T* sourceBelow, const T* sourceAbove,
                        const T* flow, T* out) const
{
    addPassedRow(static_cast<std::size_t>(gaps().pad.nx), below, above, sourceBelow, sourceAbove, flow, out);
}

void GasFilm::spreadStorage(FaceFlows<double>& flows) const
{
    if (flows.stored.empty()) return;
    flows.passing.assign(gaps().pad.stride(), 0.0);
    for (int j = 0; j < gaps().pad.ny; ++j) spread_.spread(j, &flows.stored[gaps().pad.at(0, j)], flows.passing.data());
}

void GasFilm::setSlopes(FaceFlows<double>& flows) const
{
    const PaddedGrid& pad = gaps().pad;
    const std::size_t up = pad.stride();
    flows.passing.assign(4 * up, 0.0); // the last two rows of sources and of flows along y
    const auto cross = [&](int j) {
        const std::size_t at = pad.at(0, j), even = static_cast<std::size_t>(j % 2) * up;
        double *source = &flows.passing[even], *out = &flows.passing[2 * up + even];
        setSource(j, j < pad.ny ? storedRow(flows, j) : nullptr, source);
        addPassed(&faces_[1].below[at], &faces_[1].above[at], &flows.passing[up - even], source, &flows.flow[1][at],
                  out);
        return out;
    };
    const double* below = cross(0);
    for (int j = 0; j < pad.ny; ++j) {
        const std::size_t at = pad.at(0, j);
        const double* above = cross(j + 1);
        setSlopes(j, &flows.flow[0][at], below, above, storedRow(flows, j), &flows.slope[0][at], &flows.slope[1][at]);
        below = above;
    }
}

void GasFilm::completeChanges(FaceFlows<double>& flows) const
{
    const PaddedGrid& pad = gaps().pad;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const FilmFaces& f = faces_[axis];
        forEachRow(pad.ny + (axis == 1), [&](int j) {
            const std::size_t at = pad.at(0, j);
            const double* slope = &flows.slope[axis][at];
            completeRow(static_cast<std::size_t>(pad.nx + (axis == 0)), &f.share[at], &f.below[at], &f.above[at],
                        slope - pad.step(static_cast<int>(axis)), slope, &flows.flow[axis][at]);
        });
    }
}

template <typename T>
void GasFilm::divergence(int j, const T* flowX, const T* flowY, const T* flowYAbove, const T* stored,
                         std::span<T> out) const
{
    divergeRow(static_cast<std::size_t>(gaps().pad.nx), flowX, flowY, flowYAbove, stored, &out[gaps().pad.at(0, j)]);
}

void GasFilm::divergence(const FaceFlows<double>& flows, std::span<double> out) const
{
    forEachRow(gaps().pad.ny, [&](int j) {
        const std::size_t at = gaps().pad.at(0, j);
        const double* flowY = &flows.flow[1][at];
        divergence(j, &flows.flow[0][at], flowY, flowY + gaps().pad.stride(), storedRow(flows, j), out);
    });
}

template void GasFilm::setSlopes(int, const double*, const double*, const double*, const double*, double*,
                                 double*) const;
template void GasFilm::clearStepped(int, double*) const;
template void GasFilm::setSource(int, const double*, double*) const;
template void GasFilm::addPassed(const double*, const double*, const double*, const double*, const double*,
                                 double*) const;
template void GasFilm::divergence(int, const double*, const double*, const double*, const double*,
                                  std::span<double>) const;

/// Row by row for the cache, as evaluate() in gas_film.cpp.
template <typename T>
void GasFilm::applyJacobian(std::span<const T> v, std::span<T> out, FaceFlows<T>& work, T perTime) const
{
    Team& team = Team::mine();
    const std::size_t up = gaps().pad.stride(), threads = static_cast<std::size_t>(team.size());
    const bool fits = work.slope[0].size() >= 3 * threads * up;
    work.stored.resize(3 * threads * up);
    work.passing.resize(7 * threads * up);
    const int ny = gaps().pad.ny;
    team.items(ny, fits ? 24 : ny, 1, [&](int first, int end, int thread) {
        applyRows<T>(v, out, work, perTime, {first, end}, static_cast<std::size_t>(thread));
    });
}

template <typename T>
void GasFilm::applyRows(std::span<const T> v, std::span<T> out, FaceFlows<T>& work, T perTime, Block block,
                        std::size_t thread) const
{
    const PaddedGrid& pad = gaps().pad;
    const std::size_t up = pad.stride(), nx = static_cast<std::size_t>(pad.nx), ring = PaddedGrid::rings;
    // The work space holds the last three rows, by thread.
    const auto row = [&](std::vector<T>& field, int j) {
        return field.data() + (3 * thread + static_cast<std::size_t>((j + 3) % 3)) * up + ring;
    };
    T* passing = &work.passing[7 * thread * up];
    const auto source = [&](int j) { return passing + static_cast<std::size_t>((j + 3) % 3) * up + ring; };
    const auto crossing = [&](int j) { return source(j) + 3 * up; };
    for (std::vector<T>* slope : {&work.slope[0], &work.slope[1]})
        std::fill_n(slope->data() + 3 * thread * up, 3 * up, T{}); // the rings'
    const auto start = [&](std::size_t axis, int j) {
        const FilmFaces& f = faces_[axis];
        const std::size_t at = pad.at(0, j), step = pad.step(static_cast<int>(axis));
        setFlows(nx + (axis == 0), &f.lower[at], &f.upper[at], &v[at - step], &v[at], row(work.flow[axis], j));
    };
    const auto finish = [&](std::size_t axis, int j) {
        if (!isComplete()) return;
        const FilmFaces& f = faces_[axis];
        const std::size_t at = pad.at(0, j), step = pad.step(static_cast<int>(axis)), count = nx + (axis == 0);
        T* flow = row(work.flow[axis], j);
        const T *slope = row(work.slope[axis], j), *before = axis == 0 ? slope - 1 : row(work.slope[axis], j - 1);
        completeRow(count, &f.share[at], &f.below[at], &f.above[at], &f.ownLower[at], &f.ownUpper[at], before, slope,
                    &v[at - step], &v[at], flow);
    };
    const auto store = [&](int j) {
        if (j < pad.ny)
            onVectors<T, setStoredRow<T>>(nx, perTime, &volumes()[pad.at(0, j)], &v[pad.at(0, j)], row(work.stored, j));
        if (!isComplete()) return;
        if (j < pad.ny && perTime != T{}) spread_.spread(j, row(work.stored, j), passing + 6 * up);
        const FilmFaces& f = faces_[1];
        const std::size_t at = pad.at(0, j);
        setSource(j, row(work.stored, j), source(j));
        addPassed(&f.below[at], &f.above[at], source(j - 1), source(j), row(work.flow[1], j), crossing(j));
    };
    // Beyond the block, the slopes along y alone.
    const auto slopesBeyond = [&](int j) {
        if (!isComplete()) return;
        start(0, j);
        const T* flow = row(work.flow[0], j);
        setSlopes(j, flow, flow, flow, row(work.stored, j), row(work.slope[0], j), row(work.slope[1], j));
    };
    if (block.first == 0)
        std::fill_n(source(-1), nx, T{});
    else {
        for (int j : {block.first - 2, block.first - 1}) std::fill_n(source(j), nx, T{});
        std::fill_n(row(work.flow[1], block.first - 1), nx, T{});
        store(block.first - 1);
        slopesBeyond(block.first - 1);
    }
    start(1, block.first);
    store(block.first);
    for (int j = block.first; j <= block.end; ++j) {
        if (j < block.end) {
            start(0, j);
            start(1, j + 1);
            store(j + 1);
            if (isComplete())
                setSlopes(j, row(work.flow[0], j), crossing(j), crossing(j + 1), row(work.stored, j),
                          row(work.slope[0], j), row(work.slope[1], j));
            finish(0, j);
        } else if (j < pad.ny) {
            slopesBeyond(j);
        } else {
            std::fill_n(row(work.slope[1], j), nx, T{});
        }
        finish(1, j);
        if (j > block.first)
            divergence<T>(j - 1, row(work.flow[0], j - 1), row(work.flow[1], j - 1), row(work.flow[1], j),
                          row(work.stored, j - 1), out);
    }
}

template void GasFilm::applyJacobian(std::span<const double>, std::span<double>, FaceFlows<double>&, double) const;
template void GasFilm::applyJacobian(std::span<const std::complex<double>>, std::span<std::complex<double>>,
                                     FaceFlows<std::complex<double>>&, std::complex<double>) const;

void GasFilm::applyTransposedJacobian(std::span<const double> v, std::span<double> out, FaceFlows<double>& work) const
{
    // Backwards through applyJacobian: a face's flow leaves the cell below and enters the one above.
    const PaddedGrid& pad = gaps().pad;
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
        if (!isComplete()) return;
        work.slope[axis][before] -= f.share[at] * f.below[at] * drop;
        work.slope[axis][at] -= f.share[at] * f.above[at] * drop;
        out[before] += f.ownLower[at] * drop;
        out[at] += f.ownUpper[at] * drop;
    });
    for (const std::size_t at : gaps().steppedCells) work.slope[0][at] = work.slope[1][at] = 0.0;
    work.stored.assign(v.begin(), v.end());
    work.passing.assign(v.size(), 0.0);
    if (isComplete()) {
        const std::size_t up = pad.stride();
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j);
                const double alongX = work.slope[0][at] * axes()[0].perWidth[static_cast<std::size_t>(i)];
                const double alongY = work.slope[1][at] * axes()[1].perWidth[static_cast<std::size_t>(j)];
                work.slope[0][at] = alongX;
                work.flow[0][at] += alongY;
                work.flow[0][at + 1] -= alongY;
                work.stored[at] -= alongX + alongY;
            }
        // What faces across y pass on.
        for (int j = 0; j <= pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j);
                const double crossing = work.slope[0][at] - work.slope[0][at - up];
                work.flow[1][at] += crossing;
                work.passing[at - up] += crossing * faces_[1].below[at];
                work.passing[at] += crossing * faces_[1].above[at];
            }
        for (const std::size_t at : gaps().steppedCells) work.passing[at] = 0.0;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i)
                work.stored[pad.at(i, j)] +=
                    work.passing[pad.at(i, j)] * axes()[1].perWidth[static_cast<std::size_t>(j)];
        // What neighbours along x store of it; the slopes along y have been used.
        for (int j = 0; j < pad.ny; ++j) spread_.spreadTransposed(j, &work.stored[pad.at(0, j)], work.slope[1].data());
    }
    forFaces([&](std::size_t axis, std::size_t at, std::size_t before) {
        const FilmFaces& f = faces_[axis];
        out[before] += f.lower[at] * work.flow[axis][at];
        out[at] += f.upper[at] * work.flow[axis][at];
    });
    for (std::size_t at = 0; at < out.size(); ++at) out[at] += storagePerTime_ * volumes()[at] * work.stored[at];
    clearRings(out);
    for (auto& slope : work.slope) clearRings(slope);
}

} // namespace touchdown
