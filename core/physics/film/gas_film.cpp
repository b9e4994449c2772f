// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gas_film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numerics/vector_clones.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr int leastFaceRows = 16;     // of a block
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
    double *outBelow = faces.below.data() + first, *outAbove = faces.above.data() + first;
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
            outBelow[k] = below[k];
            outAbove[k] = above[k];
            ownLower[k] = -byMean - byInflow * inflowByLower[k];
            ownUpper[k] = -byMean - byInflow * inflowByUpper[k];
        }
    }
}

/// Faces across x where the storage jumps: cut ones, and those of stepped cells, which pass nothing on.
std::vector<std::size_t> facesThatSpreadNothing(const FilmGaps& gaps)
{
    std::vector<std::size_t> faces;
    for (const CutPlace& face : gaps.faces[0].cut) faces.push_back(face.at);
    for (const std::size_t cell : gaps.steppedCells) faces.insert(faces.end(), {cell, cell + 1});
    return faces;
}

} // namespace

FaceWork::FaceWork(const FilmGaps& gaps) : cut(gaps)
{
    for (auto* row : {&product, &mobility, &mobilityByProduct, &mobilityByGap, &width, &length, &share})
        row->assign(gaps.pad.stride(), 0.0);
}

GasFilm::RowWork::RowWork(const FilmGaps& gaps) : stride(gaps.pad.stride()), face(gaps)
{
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (FaceMoments& m : moments[axis])
            for (auto* row : {&m.below, &m.above, &m.belowByMean, &m.aboveByMean, &m.inflowByLower, &m.inflowByUpper})
                row->assign(stride, 0.0);
        for (auto* rows : {&flow[axis], &slope[axis]}) rows->assign(4 * stride, 0.0);
    }
    for (auto* rows : {&stored, &source, &crossing}) rows->assign(4 * stride, 0.0);
    spread.assign(stride, 0.0);
}

GasFilm::GasFilm(std::shared_ptr<const FilmGaps> shared, const FilmSetting& setting)
    : FilmGeometry(std::move(shared), setting.disk, setting.leastGap),
      setting_(setting),
      table_(setting.slip, setting.air),
      spread_(pad(), sharedGaps()->grid.x, facesThatSpreadNothing(*sharedGaps()))
{
    const FilmGaps& gaps = *sharedGaps();
    for (std::size_t axis = 0; axis < 2; ++axis) {
        FilmFaces& f = faces_[axis];
        for (auto* field : {&f.flow, &f.inflow, &f.lower, &f.upper, &f.share, &f.inflowShare, &f.below, &f.above,
                            &f.ownLower, &f.ownUpper, &f.diffusion, &f.effective, &f.convection, &slope_[axis]})
            field->assign(pad().size(), 0.0);
        cutFlows_[axis].resize(gaps.faces[axis].cut.size());
        cutFlowsByPressure_[axis].resize(gaps.faces[axis].cut.size());
    }
    const Team& team = Team::mine();
    const std::size_t blocks = static_cast<std::size_t>(team.largestBlocksOf(pad().ny, leastFaceRows, 2));
    for (std::size_t b = 0; b < blocks; ++b) rows_.emplace_back(gaps);
    for (int k = 0; k < team.size(); ++k) cutWork_.emplace_back(gaps);
    inflow_.assign(static_cast<std::size_t>(pad().ny), 0.0);
    noStorage_.assign(pad().stride(), 0.0);
    for (int j = 0; j <= pad().ny + 1; ++j) {
        const std::size_t row = pad().at(-PaddedGrid::rings, j);
        const std::vector<std::size_t>& stepped = gaps.steppedCells;
        steppedRows_.push_back(
            static_cast<std::size_t>(std::lower_bound(stepped.begin(), stepped.end(), row) - stepped.begin()));
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::vector<CutPlace>& cut = gaps.faces[axis].cut;
            const auto isBefore = [](const CutPlace& place, std::size_t at) { return place.at < at; };
            cutRows_[axis].push_back(
                static_cast<std::size_t>(std::lower_bound(cut.begin(), cut.end(), row, isBefore) - cut.begin()));
        }
    }
}

double GasFilm::flowScale() const
{
    const double length = gaps().length, volume = std::max(totalVolume(), length * gaps().width * closedGap);
    return 0.5 * ambient() * std::max(speed(), 1e-3) * volume / length;
}

double GasFilm::passage() const { return flowScale() / ambient() / std::max(1e-300, totalVolume()); }

void GasFilm::setStorage(double perTime, std::span<const double> history)
{
    storagePerTime_ = perTime;
    history_ = history;
}

template <typename Number>
double* GasFilm::slopeRow(std::size_t axis, int j, RowWork& work)
{
    constexpr bool derived = !std::is_same_v<Number, double>;
    return derived ? slope_[axis].data() + pad().at(0, j) : work.row(work.slope[axis], j);
}

template <typename Number>
void GasFilm::finishRow(std::size_t axis, int j, const double* before, RowWork& work)
{
    constexpr bool derived = !std::is_same_v<Number, double>;
    const std::size_t first = pad().at(0, j), count = static_cast<std::size_t>(pad().nx + (axis == 0));
    double* flow = work.row(work.flow[axis], j);
    if (isComplete())
        limitRow<derived>(first, count, work.moments[axis][work.slot(j)], before, slopeRow<Number>(axis, j, work),
                          faces_[axis], flow);
    else
        std::copy_n(&faces_[axis].flow[first], count, flow);
}

/// The residual, with its linearisation where Number has derivatives, row by row for the cache: the faces above a row
/// of cells give its slopes, its slopes complete the faces below it, and these the sum of the row below. Blocks of rows
/// each begin with the faces below them; what needs the slopes on both sides of a border comes last.
template <typename Number>
void GasFilm::evaluate(std::span<const double> p, std::span<double> out)
{
    setCutFlows<Number>(p);
    Team& team = Team::mine();
    const int ny = pad().ny, blocks = std::min(team.blocksOf(ny, leastFaceRows, 2), static_cast<int>(rows_.size()));
    for (int b = 0; b < blocks; ++b) {
        const Block rows = Team::block(ny, b, blocks);
        rows_[static_cast<std::size_t>(b)].first = rows.first;
        rows_[static_cast<std::size_t>(b)].end = rows.end;
    }
    team.run(blocks, [&](int b, int) {
        RowWork& work = rows_[static_cast<std::size_t>(b)];
        setFaceRow<Number>(1, work.first, p, work);
    });
    team.run(blocks, [&](int b, int) { evaluateRows<Number>(p, out, static_cast<std::size_t>(b)); });
    team.run(blocks - 1, [&](int b, int) { finishBorder<Number>(out, static_cast<std::size_t>(b + 1)); });
    const auto across = [&](RowWork& work, int j, double sign) {
        const double* flow = work.row(work.flow[1], j);
        for (int k = 0; k < pad().nx; ++k) massFlow_ += std::max(0.0, sign * flow[k]);
    };
    massFlow_ = 0.0;
    for (int j = 0; j < ny; ++j) {
        massFlow_ += inflow_[static_cast<std::size_t>(j)];
        if (j == 0) across(rows_.front(), 0, 1.0);
    }
    across(rows_[static_cast<std::size_t>(blocks - 1)], ny, -1.0);
}

template <typename Number>
void GasFilm::evaluateRows(std::span<const double> p, std::span<double> out, std::size_t block)
{
    RowWork& work = rows_[block];
    const PaddedGrid& pad = gaps().pad;
    const std::size_t nx = static_cast<std::size_t>(pad.nx);
    const int first = work.first, end = work.end;
    const bool highest = end == pad.ny;
    const bool stores = storagePerTime_ != 0.0;
    const auto stored = [&](int j) {
        return stores ? &work.stored[static_cast<std::size_t>(j == first ? 3 : (j + 3) % 3) * pad.stride()]
                      : noStorage_.data();
    };
    const auto store = [&](int j) {
        if (!stores) return;
        if (j < pad.ny) {
            const std::size_t at = pad.at(0, j);
            setStored(nx, storagePerTime_, &volumes()[at], &p[at], &history_[at], stored(j));
            if (isComplete()) spread_.spread(j, stored(j), work.spread.data());
        }
        if (isComplete()) setSource(j, stored(j), work.row(work.source, j));
    };
    // Flows along y through the faces before row j, with what they pass on of the storage.
    const auto cross = [&](int j) {
        const double* flow = &faces_[1].flow[pad.at(0, j)];
        if (!stores || !isComplete()) return flow;
        const RowWork& of = j == end && !highest ? rows_[block + 1] : work;
        const FaceMoments& m = of.moments[1][of.slot(j)];
        double* crossing = work.row(work.crossing, j);
        addPassed(m.below.data(), m.above.data(), work.row(work.source, j - 1), work.row(work.source, j), flow,
                  crossing);
        return static_cast<const double*>(crossing);
    };
    const auto diverge = [&](int j) {
        divergence<double>(j, work.row(work.flow[0], j), work.row(work.flow[1], j), work.row(work.flow[1], j + 1),
                           stored(j), out);
    };
    if (first == 0) {
        std::fill_n(slopeRow<Number>(1, -1, work), nx, 0.0);
        std::fill_n(work.row(work.source, -1), nx, 0.0);
    } else
        store(first - 1);
    store(first);
    const double* below = cross(first);
    for (int j = first; j < end; ++j) {
        const std::size_t at = pad.at(0, j);
        setFaceRow<Number>(0, j, p, work);
        if (j + 1 < end || highest) setFaceRow<Number>(1, j + 1, p, work);
        store(j + 1);
        const double* above = cross(j + 1);
        double *slopeX = slopeRow<Number>(0, j, work), *slopeY = slopeRow<Number>(1, j, work);
        if (isComplete()) setSlopes(j, &faces_[0].flow[at], below, above, stored(j), slopeX, slopeY);
        below = above;
        finishRow<Number>(0, j, slopeX - 1, work);
        const double* flow = work.row(work.flow[0], j);
        inflow_[static_cast<std::size_t>(j)] = std::max(0.0, flow[0]) + std::max(0.0, -flow[nx]);
        if (j == first && first > 0) continue;
        finishRow<Number>(1, j, slopeRow<Number>(1, j - 1, work), work);
        if (j > first && (j - 1 > first || first == 0)) diverge(j - 1);
    }
    if (!highest) return;
    std::fill_n(slopeRow<Number>(1, end, work), nx, 0.0);
    finishRow<Number>(1, end, slopeRow<Number>(1, end - 1, work), work);
    diverge(end - 1);
}

template <typename Number>
void GasFilm::finishBorder(std::span<double> out, std::size_t block)
{
    RowWork &work = rows_[block], &lower = rows_[block - 1];
    const int j = work.first;
    const auto stored = [&](RowWork& of, std::size_t slot) {
        return storagePerTime_ != 0.0 ? &of.stored[slot * of.stride] : noStorage_.data();
    };
    finishRow<Number>(1, j, slopeRow<Number>(1, j - 1, lower), work);
    const double* border = work.row(work.flow[1], j);
    divergence<double>(j, work.row(work.flow[0], j), border, work.row(work.flow[1], j + 1), stored(work, 3), out);
    divergence<double>(j - 1, lower.row(lower.flow[0], j - 1), lower.row(lower.flow[1], j - 1), border,
                       stored(lower, static_cast<std::size_t>((j + 2) % 3)), out);
}

void GasFilm::residual(std::span<const double> p, std::span<double> out) { evaluate<double>(p, out); }

void GasFilm::linearise(std::span<const double> p, std::span<double> out) { evaluate<ByPressure>(p, out); }

void AttitudeWork::resize(std::size_t size)
{
    if (!flows.flow[0].empty()) return;
    flows.resize(size);
    flows.stored.assign(size, 0.0);
    for (GapSlopes& axis : slopes)
        for (auto* field : {&axis.flowByGap, &axis.flowByRise, &axis.ownByGap, &axis.ownByRise})
            field->assign(size, 0.0);
}

/// out += derivatives by the attitude's number k of the faces' gaps and rises times those of the flow by them.
void GasFilm::addByAttitude(std::size_t axis, std::size_t k, const std::vector<double>& byGap,
                            const std::vector<double>& byRise, std::vector<double>& out) const
{
    const PaddedGrid& pad = gaps().pad;
    const FilmGaps::Faces& paths = gaps().faces[axis];
    const double* x = axis == 0 ? paths.pathMid.data() : centresX().data();
    const std::size_t count = static_cast<std::size_t>(pad.nx + (axis == 0));
    const auto addRow = [&](int j) {
        const std::size_t line = static_cast<std::size_t>(j), first = pad.at(0, j);
        const double y = axis == 0 ? gaps().grid.centreY(j) : paths.pathMid[line];
        const double lift = k == 0 ? 1.0 : 0.5 * gaps().width - y; // of height, of roll
        const double *gap = byGap.data() + first, *rise = byRise.data() + first;
        double* to = out.data() + first;
        if (k == 1)
            for (std::size_t i = 0; i < count; ++i) to[i] += (gaps().length - x[i]) * gap[i];
        else
            for (std::size_t i = 0; i < count; ++i) to[i] += lift * gap[i];
        if (k == 1 && axis == 0)
            for (std::size_t i = 0; i < count; ++i) to[i] -= paths.pathLength[i] * rise[i];
        if (k == 2 && axis == 1)
            for (std::size_t i = 0; i < count; ++i) to[i] -= paths.pathLength[line] * rise[i];
    };
    forEachRow(pad.ny + (axis == 1), addRow);
}

void GasFilm::attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out,
                              AttitudeWork& work) const
{
    work.resize(p.size());
    auto& [row, slopes, flows, cutFlows] = work;
    setGapSlopes(p, work);
    for (std::size_t axis = 0; axis < 2; ++axis)
        axes()[axis].cutPaths.flows(p, attitude(), axes()[axis].cutSurface, table_, air().viscosity, {&row.cut, 1},
                                    cutFlows[axis]);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::size_t step = gaps().pad.step(static_cast<int>(axis));
            std::fill(flows.flow[axis].begin(), flows.flow[axis].end(), 0.0);
            addByAttitude(axis, k, slopes[axis].flowByGap, slopes[axis].flowByRise, flows.flow[axis]);
            for (std::size_t n = 0; n < cutFlows[axis].size(); ++n) {
                const std::size_t at = gaps().faces[axis].cut[n].at;
                flows.flow[axis][at] = cutFlows[axis][n].A.by[k] * p[at - step] - cutFlows[axis][n].B.by[k] * p[at];
            }
        }
        if (storagePerTime_ != 0.0)
            setVolumeSlopes(k, storagePerTime_, p, flows.stored);
        else
            flows.stored.clear();
        if (isComplete()) {
            spreadStorage(flows);
            setSlopes(flows);
            completeChanges(flows);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                addByAttitude(axis, k, slopes[axis].ownByGap, slopes[axis].ownByRise, flows.flow[axis]);
                addCutCorrections(axis, k, p, cutFlows[axis], flows.flow[axis]);
            }
        }
        out[k].assign(p.size(), 0.0);
        divergence(flows, out[k]);
    }
}

void GasFilm::addCutCorrections(std::size_t axis, std::size_t k, std::span<const double> p,
                                const std::vector<PathFlow<ByAttitude>>& cutFlows, std::vector<double>& out) const
{
    const FilmFaces& f = faces_[axis];
    const std::size_t step = gaps().pad.step(static_cast<int>(axis));
    for (std::size_t n = 0; n < cutFlows.size(); ++n) {
        const std::size_t at = gaps().faces[axis].cut[n].at;
        const PathFlow<ByAttitude>& flow = cutFlows[n];
        const double inflow = axes()[axis].speed[at] < 0.0 ? flow.B.by[k] * p[at] : flow.A.by[k] * p[at - step];
        out[at] -= f.share[at] * (slope_[axis][at - step] * flow.below.by[k] + slope_[axis][at] * flow.above.by[k]) +
                   f.inflowShare[at] * inflow;
    }
}

void GasFilm::attitudeStorageColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out,
                                     AttitudeWork& work) const
{
    work.resize(p.size());
    FaceFlows<double>& flows = work.flows;
    for (std::size_t k = 0; k < 3; ++k) {
        for (auto& flow : flows.flow) std::fill(flow.begin(), flow.end(), 0.0);
        setVolumeSlopes(k, 1.0, p, flows.stored);
        if (isComplete()) {
            spreadStorage(flows);
            setSlopes(flows);
            completeChanges(flows);
        }
        out[k].assign(p.size(), 0.0);
        divergence(flows, out[k]);
    }
}

} // namespace touchdown
