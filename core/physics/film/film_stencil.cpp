// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_stencil.h"

#include "core/numerics/vector_clones.h"

namespace touchdown {

namespace {

/// Of a row, from its first cell.
struct StencilRow {
    std::array<const float*, 8> beside;
    const float* sum;
    std::array<const float*, 2> storedBelow, storedAbove;
};

TOUCHDOWN_VECTOR_CLONES void applyRow(std::size_t count, std::size_t up, const StencilRow row, double rate,
                                      const double* volume, const double* v, double* out)
{
    const auto [c0, c1, c2, c3, c4, c5, c6, c7] = row.beside;
    const float *sum = row.sum, *xBelow = row.storedBelow[0], *xAbove = row.storedAbove[0];
    const float *yBelow = row.storedBelow[1], *yAbove = row.storedAbove[1];
    const double *south = v - up, *north = v + up, *volumeSouth = volume - up, *volumeNorth = volume + up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t e = k + 1, t = k + up; // the faces east and on top
        const double own = v[k], east = v[k + 1], west = v[k - 1];
        const double below = c0[k] * (south[k - 1] - own) + c1[k] * (south[k] - own) + c2[k] * (south[k + 1] - own);
        const double beside = c3[k] * (west - own) + c4[k] * (east - own);
        const double above = c5[k] * (north[k - 1] - own) + c6[k] * (north[k] - own) + c7[k] * (north[k + 1] - own);
        const double stored = volume[k] * own;
        const double passedX = (xBelow[e] * stored + xAbove[e] * (volume[k + 1] * east)) -
                               (xBelow[k] * (volume[k - 1] * west) + xAbove[k] * stored);
        const double passedY = (yBelow[t] * stored + yAbove[t] * (volumeNorth[k] * north[k])) -
                               (yBelow[k] * (volumeSouth[k] * south[k]) + yAbove[k] * stored);
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
    rows.assign(12 * pad.stride(), 0.0);
    width.assign(pad.stride(), 0.0);
}

NinePoints FilmStencil::points() const
{
    NinePoints points;
    for (std::size_t k = 0; k < beside.size(); ++k) points.beside[k] = beside[k];
    points.sum = sum;
    return points;
}

void FilmStencil::apply(std::span<const double> v, double rate, std::span<const double> volume,
                        std::span<double> out) const
{
    for (int j = 0; j < pad.ny; ++j) {
        const std::size_t at = pad.at(0, j);
        StencilRow row{
            {}, &sum[at], {&storedBelow[0][at], &storedBelow[1][at]}, {&storedAbove[0][at], &storedAbove[1][at]}};
        for (std::size_t k = 0; k < beside.size(); ++k) row.beside[k] = &beside[k][at];
        applyRow(static_cast<std::size_t>(pad.nx), pad.stride(), row, rate, &volume[at], &v[at], &out[at]);
    }
}

void FilmStencil::addStored(std::size_t axis, double rate, std::span<const double> volume, const Own& own,
                            std::span<double> effective, std::span<double> convection) const
{
    for (int j = 0; j < pad.ny + (axis == 1); ++j) {
        const std::size_t at = pad.at(0, j);
        addStoredRow(static_cast<std::size_t>(pad.nx + (axis == 0)), pad.step(static_cast<int>(axis)), rate,
                     &volume[at], &storedBelow[axis][at], &storedAbove[axis][at], &own.effective[at],
                     &own.convection[at], &effective[at], &convection[at]);
    }
}

} // namespace touchdown
