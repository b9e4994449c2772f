// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coefficients of a cell's outflow in the nine cells that its faces and the corrections of their flows meet.
#include <algorithm>
#include <array>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/film_stencil.h"
#include "core/physics/film/gas_film.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

/// Slopes of the flow along an axis in a row of cells, by the cells before, here and after across it.
struct SlopeRow {
    double *before, *here, *after;
};

/// Linearised faces before a row of cells; those after it are a cell, or a row, further on.
struct StencilFaces {
    const double *lower, *upper, *share, *below, *above, *ownLower, *ownUpper;
    StencilFaces(const FilmFaces& f, std::size_t at)
        : lower(&f.lower[at]),
          upper(&f.upper[at]),
          share(&f.share[at]),
          below(&f.below[at]),
          above(&f.above[at]),
          ownLower(&f.ownLower[at]),
          ownUpper(&f.ownUpper[at])
    {}
};

/// Mass balance: the change of the flow along one axis is minus that along the other.
TOUCHDOWN_VECTOR_CLONES void setSlopeRow(std::size_t count, std::size_t step, const double* lower, const double* upper,
                                         const double* perWidth, SlopeRow out)
{
    double *before = out.before, *here = out.here, *after = out.after;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        before[k] = lower[k] * perWidth[k];
        here[k] = (upper[k] - lower[k + step]) * perWidth[k];
        after[k] = -upper[k + step] * perWidth[k];
    }
}

/// With the slopes of the flow along x in this row (sx), along y in the rows below (s), here (h), above (n).
TOUCHDOWN_VECTOR_CLONES void setRow(std::size_t count, std::size_t up, StencilFaces x, StencilFaces y, SlopeRow sx,
                                    SlopeRow s, SlopeRow h, SlopeRow n, std::array<float*, 8> c, float* sum)
{
    float *c0 = c[0], *c1 = c[1], *c2 = c[2], *c3 = c[3], *c4 = c[4], *c5 = c[5], *c6 = c[6], *c7 = c[7];
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t e = k + 1, t = k + up; // the faces east and on top
        const double xBelow = x.share[k] * x.below[k], xAbove = x.share[e] * x.above[e];
        const double yBelow = y.share[k] * y.below[k], yAbove = y.share[t] * y.above[t];
        const double alongX = x.share[k] * x.above[k] - x.share[e] * x.below[e];
        const double alongY = y.share[k] * y.above[k] - y.share[t] * y.below[t];
        const double southWest = xBelow * sx.before[k - 1] + yBelow * s.before[k];
        const double south = alongX * sx.before[k] - (y.lower[k] + y.ownLower[k]) + yBelow * s.here[k];
        const double southEast = -xAbove * sx.before[e] + yBelow * s.after[k];
        const double west = -(x.lower[k] + x.ownLower[k]) + xBelow * sx.here[k - 1] + alongY * h.before[k];
        const double east = (x.upper[e] + x.ownUpper[e]) - xAbove * sx.here[e] + alongY * h.after[k];
        const double northWest = xBelow * sx.after[k - 1] - yAbove * n.before[k];
        const double north = alongX * sx.after[k] + (y.upper[t] + y.ownUpper[t]) - yAbove * n.here[k];
        const double northEast = -xAbove * sx.after[e] - yAbove * n.after[k];
        const double own = (x.lower[e] + x.ownLower[e]) - (x.upper[k] + x.ownUpper[k]) + (y.lower[t] + y.ownLower[t]) -
                           (y.upper[k] + y.ownUpper[k]) + alongX * sx.here[k] + alongY * h.here[k];
        c0[k] = static_cast<float>(southWest);
        c1[k] = static_cast<float>(south);
        c2[k] = static_cast<float>(southEast);
        c3[k] = static_cast<float>(west);
        c4[k] = static_cast<float>(east);
        c5[k] = static_cast<float>(northWest);
        c6[k] = static_cast<float>(north);
        c7[k] = static_cast<float>(northEast);
        sum[k] =
            static_cast<float>(own + (southWest + south + southEast) + (west + east) + (northWest + north + northEast));
    }
}

/// Shares of the storage of a row of cells that the faces before and after them pass on.
template <bool limited>
TOUCHDOWN_VECTOR_CLONES void setPassed(std::size_t count, std::size_t step, const double* perWidth, const double* share,
                                       const double* below, const double* above, float* storedBelow, float* storedAbove)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        storedAbove[k] = static_cast<float>(perWidth[k] * (limited ? share[k] : 1.0) * above[k]);
        storedBelow[k + step] = static_cast<float>(perWidth[k] * (limited ? share[k + step] : 1.0) * below[k + step]);
    }
}

} // namespace

void GasFilm::setStencil(FilmStencil& out) const
{
    out.spread = isComplete() ? &spread_ : nullptr;
    std::fill(out.rows.begin(), out.rows.end(), 0.0); // below the first row and beside all of them
    Team& team = Team::mine();
    const int ny = gaps().pad.ny;
    team.items(ny, team.size() > out.threads ? ny : 24, 1, [&](int first, int end, int thread) {
        setStencilRows(out, {first, end}, static_cast<std::size_t>(thread));
    });
}

void GasFilm::setStencilRows(FilmStencil& out, Block block, std::size_t thread) const
{
    const PaddedGrid& pad = gaps().pad;
    const std::size_t up = pad.stride(), nx = static_cast<std::size_t>(pad.nx);
    double* width = out.width.data() + thread * up;
    const auto rows = [&](std::size_t place) {
        double* first = out.rows.data() + (12 * thread + 3 * place) * up + PaddedGrid::rings;
        return SlopeRow{first, first + up, first + 2 * up};
    };
    const auto along = [&](std::size_t axis, int j) {
        return rows(axis == 0 ? 0 : static_cast<std::size_t>(1 + (j + 3) % 3));
    };
    const auto setSlopes = [&](std::size_t axis, int j) {
        const SlopeRow row = along(axis, j);
        const std::size_t at = pad.at(0, j), line = static_cast<std::size_t>(j);
        if (j < 0 || j == pad.ny) {
            for (double* part : {row.before, row.here, row.after}) std::fill_n(part, nx, 0.0);
            return;
        }
        const bool own = j >= block.first && j < block.end; // others write what is passed there
        const FilmFaces &f = faces_[axis], &across = faces_[1 - axis];
        if (axis == 1) std::fill_n(width, up, axes()[1].perWidth[line]);
        const double* perWidth = axis == 0 ? axes()[0].perWidth.data() : width;
        const std::size_t step = pad.step(static_cast<int>(axis));
        setSlopeRow(nx, pad.step(axis == 0 ? 1 : 0), &across.lower[at], &across.upper[at], perWidth, row);
        if (own) {
            setPassed<true>(nx, step, perWidth, &f.share[at], &f.below[at], &f.above[at], &out.storedBelow[axis][at],
                            &out.storedAbove[axis][at]);
            if (axis == 1)
                setPassed<false>(nx, step, perWidth, nullptr, &f.below[at], &f.above[at], &out.crossBelow[at],
                                 &out.crossAbove[at]);
        }
        // These have no slopes.
        for (std::size_t n = steppedRows_[line]; n < steppedRows_[line + 1]; ++n) {
            const std::size_t cell = gaps().steppedCells[n];
            for (double* part : {row.before, row.here, row.after}) part[cell - at] = 0.0;
            if (!own) continue;
            out.storedAbove[axis][cell] = out.storedBelow[axis][cell + step] = 0.0f;
            if (axis == 1) out.crossAbove[cell] = out.crossBelow[cell + step] = 0.0f;
        }
    };
    setSlopes(1, block.first - 1);
    setSlopes(1, block.first);
    for (int j = block.first; j < block.end; ++j) {
        const std::size_t at = pad.at(0, j);
        setSlopes(0, j);
        setSlopes(1, j + 1);
        std::array<float*, 8> beside;
        for (std::size_t k = 0; k < beside.size(); ++k) beside[k] = &out.beside[k][at];
        setRow(nx, up, StencilFaces(faces_[0], at), StencilFaces(faces_[1], at), along(0, j), along(1, j - 1),
               along(1, j), along(1, j + 1), beside, &out.sum[at]);
    }
}

} // namespace touchdown
