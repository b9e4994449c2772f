// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_stencil.h"

#include <algorithm>
#include <numeric>

#include "core/numerics/row_spread.h"
#include "core/numerics/vector_clones.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr int leastStencilRows = 24; // of a block

/// Of a row, from its first cell.
struct StencilRow {
    std::array<const float*, 8> beside;
    const float* sum;
    std::array<const float*, 2> storedBelow, storedAbove;
};

/// V v of three rows of cells, south, here and north, and of this row with what the faces across y pass on of it.
struct StoredRows {
    const double *south, *here, *north;
    double* crossed;
};

TOUCHDOWN_VECTOR_CLONES void multiplyRow(std::size_t count, const double* volume, const double* v, double* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = volume[k] * v[k];
}

TOUCHDOWN_VECTOR_CLONES void crossRow(std::size_t count, std::size_t up, const float* below, const float* above,
                                      const StoredRows stored)
{
    const double *south = stored.south, *here = stored.here, *north = stored.north;
    double* out = stored.crossed;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t t = k + up; // the face on top
        out[k] = here[k] + (below[t] * here[k] + above[t] * north[k]) - (below[k] * south[k] + above[k] * here[k]);
    }
}

TOUCHDOWN_VECTOR_CLONES void applyRow(std::size_t count, std::size_t up, const StencilRow row, double rate,
                                      const StoredRows rows, const double* v, double* out)
{
    const double *storedSouth = rows.south, *storedHere = rows.here, *storedNorth = rows.north, *crossed = rows.crossed;
    const auto [c0, c1, c2, c3, c4, c5, c6, c7] = row.beside;
    const float *sum = row.sum, *xBelow = row.storedBelow[0], *xAbove = row.storedAbove[0];
    const float *yBelow = row.storedBelow[1], *yAbove = row.storedAbove[1];
    const double *south = v - up, *north = v + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t e = k + 1, t = k + up; // the faces east and on top
        const double own = v[k], east = v[k + 1], west = v[k - 1];
        const double below = c0[k] * (south[k - 1] - own) + c1[k] * (south[k] - own) + c2[k] * (south[k + 1] - own);
        const double beside = c3[k] * (west - own) + c4[k] * (east - own);
        const double above = c5[k] * (north[k - 1] - own) + c6[k] * (north[k] - own) + c7[k] * (north[k + 1] - own);
        const double stored = storedHere[k];
        const double passedX = (xBelow[e] * crossed[k] + xAbove[e] * crossed[k + 1]) -
                               (xBelow[k] * crossed[k - 1] + xAbove[k] * crossed[k]);
        const double passedY =
            (yBelow[t] * stored + yAbove[t] * storedNorth[k]) - (yBelow[k] * storedSouth[k] + yAbove[k] * stored);
        out[k] = ((below + beside + above) + sum[k] * own) + rate * (stored + (passedX + passedY));
    }
}

TOUCHDOWN_VECTOR_CLONES void addStoredRow(std::size_t count, std::size_t step, double rate, const double* volume,
                                          const float* below, const float* above, const double* effective,
                                          const double* convection, double* effectiveOut, double* convectionOut)
{
    const double* volumeBelow = volume - step;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double lower = rate * volumeBelow[k] * below[k], upper = rate * volume[k] * above[k];
        convectionOut[k] = convection[k] + (lower + upper);
        effectiveOut[k] = effective[k] + 0.5 * (lower - upper);
    }
}

} // namespace

FilmStencil::FilmStencil(const PaddedGrid& grid) : pad(grid)
{
    for (auto& field : beside) field.assign(pad.size(), 0.0f);
    sum.assign(pad.size(), 0.0f);
    for (auto* pair : {&storedBelow, &storedAbove})
        for (auto& field : *pair) field.assign(pad.size(), 0.0f);
    for (auto* field : {&crossBelow, &crossAbove}) field->assign(pad.size(), 0.0f);
    threads = Team::mine().size();
    const std::size_t count = static_cast<std::size_t>(threads);
    rows.assign(count * 12 * pad.stride(), 0.0);
    width.assign(count * pad.stride(), 0.0);
    stored.assign(count * 5 * pad.stride(), 0.0);
}

NinePoints FilmStencil::points() const
{
    NinePoints points;
    for (std::size_t k = 0; k < beside.size(); ++k) points.beside[k] = beside[k];
    points.sum = sum;
    return points;
}

NinePoints FilmStencil::storagePoints() const
{
    NinePoints points;
    for (std::size_t k = 0; k < beside.size(); ++k) points.beside[k] = storedBeside[k];
    points.sum = storedSum;
    return points;
}

void FilmStencil::apply(std::span<const double> v, double rate, std::span<const double> volume, std::span<double> out)
{
    Team& team = Team::mine();
    team.items(pad.ny, team.size() > threads ? pad.ny : leastStencilRows, 1, [&](int first, int end, int thread) {
        applyRows(v, rate, volume, out, {first, end}, thread);
    });
}

void FilmStencil::applyRows(std::span<const double> v, double rate, std::span<const double> volume,
                            std::span<double> out, Block block, int thread)
{
    const std::size_t nx = static_cast<std::size_t>(pad.nx), up = pad.stride();
    double* own = &stored[static_cast<std::size_t>(thread) * 5 * up];
    const auto row = [&](int j) { return own + static_cast<std::size_t>((j + 3) % 3) * up + PaddedGrid::rings; };
    double* crossed = own + 3 * up + PaddedGrid::rings;
    const auto store = [&](int j) {
        const std::size_t at = pad.at(0, j);
        multiplyRow(nx, &volume[at], &v[at], row(j)); // zero in the ring
        if (spread != nullptr && j < pad.ny) spread->spread(j, row(j), own + 4 * up);
    };
    if (block.first == 0)
        std::fill_n(row(-1), nx, 0.0);
    else
        store(block.first - 1);
    store(block.first);
    for (int j = block.first; j < block.end; ++j) {
        const std::size_t at = pad.at(0, j);
        StencilRow coefficients{
            {}, &sum[at], {&storedBelow[0][at], &storedBelow[1][at]}, {&storedAbove[0][at], &storedAbove[1][at]}};
        for (std::size_t k = 0; k < beside.size(); ++k) coefficients.beside[k] = &beside[k][at];
        store(j + 1);
        const StoredRows around{row(j - 1), row(j), row(j + 1), crossed};
        crossRow(nx, up, &crossBelow[at], &crossAbove[at], around);
        applyRow(nx, up, coefficients, rate, around, &v[at], &out[at]);
    }
}

void FilmStencil::reserve()
{
    for (auto& field : storedBeside) field.resize(pad.size());
    storedSum.resize(pad.size());
}

void FilmStencil::setStorage(std::span<const double> volume)
{
    reserve();
    const std::size_t up = pad.stride();
    // Of a cell's storage with what faces across y pass on: by those of the cell and its neighbours along y.
    const auto here = [&](std::size_t at) { return volume[at] * (1.0 + crossBelow[at + up] - crossAbove[at]); };
    const auto south = [&](std::size_t at) { return -volume[at - up] * crossBelow[at]; };
    const auto north = [&](std::size_t at) { return volume[at + up] * crossAbove[at + up]; };
    const auto setRow = [&](int j) {
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j), e = at + 1, w = at - 1, t = at + up;
            const std::array<std::vector<float>, 2>&b = storedBelow, &a = storedAbove;
            const double west = -b[0][at], own = b[0][e] - a[0][at], east = a[0][e];
            const double alongY = b[1][t] - a[1][at];
            const std::array<double, 9> c{
                west * south(w), own * south(at) - b[1][at] * volume[at - up], east * south(e),
                west * here(w),  own * here(at) + volume[at] * (1.0 + alongY), east * here(e),
                west * north(w), own * north(at) + a[1][t] * volume[t],        east * north(e)};
            for (std::size_t k = 0; k < 8; ++k) storedBeside[k][at] = static_cast<float>(c[k < 4 ? k : k + 1]);
            storedSum[at] = static_cast<float>(std::accumulate(c.begin(), c.end(), 0.0));
        }
    };
    Team::mine().items(pad.ny, leastStencilRows, 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) setRow(j);
    });
}

void FilmStencil::addStored(std::size_t axis, double rate, std::span<const double> volume, const Own& own,
                            std::span<double> effective, std::span<double> convection) const
{
    Team::mine().items(pad.ny + (axis == 1), leastStencilRows, 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) {
            const std::size_t at = pad.at(0, j);
            addStoredRow(static_cast<std::size_t>(pad.nx + (axis == 0)), pad.step(static_cast<int>(axis)), rate,
                         &volume[at], &storedBelow[axis][at], &storedAbove[axis][at], &own.effective[at],
                         &own.convection[at], &effective[at], &convection[at]);
        }
    });
}

} // namespace touchdown
