// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film's residual and its linearisation, row by row, so that each part finds the results of the last one in the
// cache: a row of cells has its slopes when the faces above are there, the faces below it are complete when it has its
// slopes, and the row below then has its sum.
#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"

namespace touchdown {

namespace {

constexpr double tinySquare = 1e-200; // keeps ratios of closed faces finite [(Pa m^3/s)^2]

/// Storage of a row of cells.
TOUCHDOWN_VECTOR_CLONES void setStored(std::size_t count, double perTime, const double* volume, const double* p,
                                       const double* history, double* stored)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) stored[k] = perTime * volume[k] * p[k] - history[k];
}

/// The flows of a row of faces less the limited corrections, and the derivatives of the corrections.
template <bool derived>
TOUCHDOWN_VECTOR_CLONES void limitRow(std::size_t first, std::size_t count, const FaceMoments& moments,
                                      const double* before, const double* after, FilmFaces& faces, double* out)
{
    const double *in = faces.flow.data() + first, *inflow = faces.inflow.data() + first;
    const double *below = moments.below.data(), *above = moments.above.data();
    const double *belowByMean = moments.belowByMean.data(), *aboveByMean = moments.aboveByMean.data();
    const double *inflowByLower = moments.inflowByLower.data(), *inflowByUpper = moments.inflowByUpper.data();
    double *share = faces.share.data() + first, *inflowShare = faces.inflowShare.data() + first;
    double *lessBelow = faces.below.data() + first, *lessAbove = faces.above.data() + first;
    double *ownLower = faces.ownLower.data() + first, *ownUpper = faces.ownUpper.data() + first;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double full = before[k] * below[k] + after[k] * above[k];
        const double inverse = 1.0 / std::sqrt(inflow[k] * inflow[k] + full * full + tinySquare);
        const double part = inflow[k] * inverse, rest = full * inverse;
        out[k] = in[k] - full * part;
        if constexpr (derived) {
            const double byFull = part * part * part, byInflow = rest * rest * rest;
            const double byMean = 0.5 * byFull * (before[k] * belowByMean[k] + after[k] * aboveByMean[k]);
            share[k] = byFull;
            inflowShare[k] = byInflow;
            lessBelow[k] = byFull * below[k];
            lessAbove[k] = byFull * above[k];
            ownLower[k] = -byMean - byInflow * inflowByLower[k];
            ownUpper[k] = -byMean - byInflow * inflowByUpper[k];
        }
    }
}

} // namespace

template <typename Number>
void GasFilm::evaluate(std::span<const double> p, std::span<double> out)
{
    constexpr bool derived = !std::is_same_v<Number, double>;
    const PaddedGrid& pad = gaps().pad;
    const std::size_t nx = static_cast<std::size_t>(pad.nx);
    const auto row = [&](std::vector<double>& rows, int j) {
        return rows.data() + static_cast<std::size_t>((j + 2) % 2) * pad.stride() + PaddedGrid::rings;
    };
    const auto slope = [&](std::size_t axis, int j) {
        return derived ? slope_[axis].data() + pad.at(0, j) : row(rows_.slope[axis], j);
    };
    const auto stored = [&](int j) { return storagePerTime_ != 0.0 ? row(rows_.stored, j) : noStorage_.data(); };
    const auto finish = [&](std::size_t axis, int j) {
        const std::size_t first = pad.at(0, j), count = nx + (axis == 0);
        double* flow = row(rows_.flow[axis], j);
        if (complete())
            limitRow<derived>(first, count, rows_.moments[axis][static_cast<std::size_t>(j % 2)],
                              axis == 0 ? slope(0, j) - 1 : slope(1, j - 1), slope(axis, j), faces_[axis], flow);
        else
            std::copy_n(&faces_[axis].flow[first], count, flow);
    };
    massFlow_ = 0.0;
    setCutFlows<Number>(p);
    setFaceRow<Number>(1, 0, p);
    std::fill_n(slope(1, -1), nx, 0.0);
    for (int j = 0; j <= pad.ny; ++j) {
        const std::size_t first = pad.at(0, j);
        if (j < pad.ny) {
            setFaceRow<Number>(0, j, p);
            setFaceRow<Number>(1, j + 1, p);
            if (storagePerTime_ != 0.0)
                setStored(nx, storagePerTime_, &volumes()[first], &p[first], &history_[first], stored(j));
            const double *flowX = &faces_[0].flow[first], *flowY = &faces_[1].flow[first];
            if (complete()) setSlopes(j, flowX, flowY, flowY + pad.stride(), stored(j), slope(0, j), slope(1, j));
            finish(0, j);
            massFlow_ += std::max(0.0, row(rows_.flow[0], j)[0]) + std::max(0.0, -row(rows_.flow[0], j)[nx]);
        } else {
            std::fill_n(slope(1, j), nx, 0.0);
        }
        finish(1, j);
        if (j > 0)
            divergence<double>(j - 1, row(rows_.flow[0], j - 1), row(rows_.flow[1], j - 1), row(rows_.flow[1], j),
                               stored(j - 1), out);
        if (j > 0 && j < pad.ny) continue;
        for (std::size_t k = 0; k < nx; ++k)
            massFlow_ += std::max(0.0, (j == 0 ? 1.0 : -1.0) * row(rows_.flow[1], j)[k]);
    }
}

void GasFilm::residual(std::span<const double> p, std::span<double> out) { evaluate<double>(p, out); }

void GasFilm::linearise(std::span<const double> p, std::span<double> out) { evaluate<ByPressure>(p, out); }

} // namespace touchdown
