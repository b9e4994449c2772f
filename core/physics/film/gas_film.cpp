// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gas_film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numerics/vector_clones.h"

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

GasFilm::GasFilm(std::shared_ptr<const FilmGaps> shared, const FilmSetting& setting)
    : FilmGeometry(std::move(shared), setting.disk, setting.leastGap),
      setting_(setting),
      table_(setting.slip, setting.air),
      spread_(pad(), sharedGaps()->grid.x, facesThatSpreadNothing(*sharedGaps())),
      row_(*sharedGaps())
{
    const FilmGaps& gaps = *sharedGaps();
    for (std::size_t axis = 0; axis < 2; ++axis) {
        FilmFaces& f = faces_[axis];
        for (auto* field : {&f.flow, &f.inflow, &f.lower, &f.upper, &f.share, &f.inflowShare, &f.below, &f.above,
                            &f.ownLower, &f.ownUpper, &f.diffusion, &f.effective, &f.convection, &slope_[axis]})
            field->assign(pad().size(), 0.0);
        for (FaceMoments& m : rows_.moments[axis])
            for (auto* row : {&m.below, &m.above, &m.belowByMean, &m.aboveByMean, &m.inflowByLower, &m.inflowByUpper})
                row->assign(pad().stride(), 0.0);
        for (auto* rows : {&rows_.flow[axis], &rows_.slope[axis]}) rows->assign(2 * pad().stride(), 0.0);
        cutFlows_[axis].resize(gaps.faces[axis].cut.size());
        cutFlowsByPressure_[axis].resize(gaps.faces[axis].cut.size());
    }
    rows_.stored.assign(3 * pad().stride(), 0.0);
    for (auto* rows : {&rows_.source, &rows_.crossing}) rows->assign(2 * pad().stride(), 0.0);
    for (auto* row : {&noStorage_, &rows_.spread}) row->assign(pad().stride(), 0.0);
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

/// The residual, with its linearisation where Number has derivatives, row by row for the cache: the faces above a row
/// of cells give its slopes, its slopes complete the faces below it, and these the sum of the row below.
template <typename Number>
void GasFilm::evaluate(std::span<const double> p, std::span<double> out)
{
    constexpr bool derived = !std::is_same_v<Number, double>;
    const PaddedGrid& pad = gaps().pad;
    const std::size_t nx = static_cast<std::size_t>(pad.nx);
    const auto row = [&](std::vector<double>& rows, int j) {
        return rows.data() + static_cast<std::size_t>((j + 2) % 2) * pad.stride() + PaddedGrid::rings;
    };
    const bool stores = storagePerTime_ != 0.0;
    const auto slope = [&](std::size_t axis, int j) {
        return derived ? slope_[axis].data() + pad.at(0, j) : row(rows_.slope[axis], j);
    };
    const auto stored = [&](int j) {
        return stores ? &rows_.stored[static_cast<std::size_t>(j % 3) * pad.stride()] : noStorage_.data();
    };
    const auto store = [&](int j) {
        if (!stores) return;
        if (j < pad.ny) {
            const std::size_t first = pad.at(0, j);
            setStored(nx, storagePerTime_, &volumes()[first], &p[first], &history_[first], stored(j));
            if (isComplete()) spread_.spread(j, stored(j), rows_.spread.data());
        }
        if (isComplete()) setSource(j, stored(j), row(rows_.source, j));
    };
    // Flows along y through the faces before row j, with what they pass on of the storage.
    const auto cross = [&](int j) {
        const double* flow = &faces_[1].flow[pad.at(0, j)];
        if (!stores || !isComplete()) return flow;
        const FaceMoments& m = rows_.moments[1][static_cast<std::size_t>(j % 2)];
        double* crossing = row(rows_.crossing, j);
        addPassed(m.below.data(), m.above.data(), row(rows_.source, j - 1), row(rows_.source, j), flow, crossing);
        return static_cast<const double*>(crossing);
    };
    const auto finish = [&](std::size_t axis, int j) {
        const std::size_t first = pad.at(0, j), count = nx + (axis == 0);
        double* flow = row(rows_.flow[axis], j);
        if (isComplete())
            limitRow<derived>(first, count, rows_.moments[axis][static_cast<std::size_t>(j % 2)],
                              axis == 0 ? slope(0, j) - 1 : slope(1, j - 1), slope(axis, j), faces_[axis], flow);
        else
            std::copy_n(&faces_[axis].flow[first], count, flow);
    };
    massFlow_ = 0.0;
    setCutFlows<Number>(p);
    setFaceRow<Number>(1, 0, p);
    std::fill_n(slope(1, -1), nx, 0.0);
    std::fill_n(row(rows_.source, -1), nx, 0.0);
    store(0);
    const double* below = cross(0);
    for (int j = 0; j <= pad.ny; ++j) {
        const std::size_t first = pad.at(0, j);
        if (j < pad.ny) {
            setFaceRow<Number>(0, j, p);
            setFaceRow<Number>(1, j + 1, p);
            store(j + 1);
            const double* above = cross(j + 1);
            if (isComplete()) setSlopes(j, &faces_[0].flow[first], below, above, stored(j), slope(0, j), slope(1, j));
            below = above;
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
    for (int j = 0; j < pad.ny + (axis == 1); ++j) {
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
    }
}

void GasFilm::attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out,
                              AttitudeWork& work) const
{
    work.resize(p.size());
    auto& [row, slopes, flows, cutFlows] = work;
    setGapSlopes(p, work);
    for (std::size_t axis = 0; axis < 2; ++axis)
        axes()[axis].cutPaths.flows(p, attitude(), axes()[axis].cutSurface, table_, air().viscosity, row.cut,
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
