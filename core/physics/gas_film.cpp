// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/gas_film.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"

namespace touchdown {

namespace {

constexpr double tinyFlow = 1e-200; // keeps ratios of closed faces finite [Pa m^3/s]

/// Takes the limited corrections off the flows of a row of faces.
TOUCHDOWN_VECTOR_CLONES void limitRow(FilmFaces& faces, const std::vector<double>& slope, std::vector<double>& flow,
                                      std::size_t first, std::size_t count, std::size_t step)
{
    const double *after = slope.data() + first, *before = after - step;
    const double *below = faces.below.data() + first, *above = faces.above.data() + first;
    const double* inflow = faces.inflow.data() + first;
    double *out = flow.data() + first, *share = faces.share.data() + first, *inflowShare = faces.inflowShare.data() + first;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double full = before[k] * below[k] + after[k] * above[k];
        const double ratio = full / (inflow[k] + tinyFlow), inverse = 1.0 / std::sqrt(1.0 + ratio * ratio);
        out[k] -= full * inverse;
        share[k] = inverse * inverse * inverse;
        inflowShare[k] = ratio * ratio * ratio * share[k];
    }
}

double tiltOf(double rise, double gap) { return gap > closedGap ? std::clamp(rise / gap, -1.0, 1.0) : 0.0; }

} // namespace

GasFilm::GasFilm(const FilmGaps& gaps, const FilmSetting& setting)
    : gaps_(gaps), setting_(setting), table_(setting.slip, setting.air)
{
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        AxisState& a = axes_[axis];
        for (auto* field : {&a.gap, &a.tilt, &a.speed}) field->assign(pad.size(), 0.0);
        FilmFaces& f = faces_[axis];
        for (auto* field : {&f.flow, &f.lower, &f.upper, &f.below, &f.above, &f.belowByMean, &f.aboveByMean, &f.inflow,
                            &f.inflowByLower, &f.inflowByUpper, &f.ownLower, &f.ownUpper, &f.share, &f.inflowShare,
                            &f.diffusion, &f.effective, &f.convection})
            field->assign(pad.size(), 0.0);
        const int along = axis == 0 ? pad.nx : pad.ny, across = axis == 0 ? pad.ny : pad.nx;
        for (int k = 0; k < across; ++k) a.width.push_back(axis == 0 ? grid.widthY(k) : grid.widthX(k));
        for (int k = 0; k < along; ++k) a.perWidth.push_back(1.0 / (axis == 0 ? grid.widthX(k) : grid.widthY(k)));
    }
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i <= pad.nx; ++i) {
            const double x = grid.x[static_cast<std::size_t>(i)];
            const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, x, grid.centreY(j));
            axes_[0].speed[pad.at(i, j)] = 0.5 * v.x;
        }
    for (int j = 0; j <= pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const double y = grid.y[static_cast<std::size_t>(j)];
            const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, grid.centreX(i), y);
            axes_[1].speed[pad.at(i, j)] = 0.5 * v.y;
        }
    const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, 0.5 * gaps_.length, 0.5 * gaps_.width);
    const double square = v.x * v.x + v.y * v.y;
    if (square > 0.0) motionShare_ = {v.x * v.x / square, v.y * v.y / square};
    flows_.resize(pad.size());
    std::size_t mostPieces = 0; // of one face
    for (const FilmGaps::Faces& f : gaps_.faces)
        for (const CutPlace& place : f.cut)
            mostPieces = std::max<std::size_t>(mostPieces, gaps_.rows[place.rowEnd - 1].pieceEnd - gaps_.rows[place.rows].pieces);
    block_.resize(PieceBlock::enough + mostPieces);
    for (auto* row : {&mobility_, &mobilityByPressure_, &rowProduct_, &rowWidth_, &rowLength_, &rowShare_}) row->assign(pad.stride(), 0.0);
    volume_.assign(pad.size(), 0.0);
    area_.assign(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) area_[pad.at(i, j)] = grid.widthX(i) * grid.widthY(j);
    setAttitude({});
}

void GasFilm::setAttitude(const Attitude& attitude)
{
    attitude_ = attitude;
    const PaddedGrid& pad = gaps_.pad;
    const CellGrid& grid = gaps_.grid;
    for (int j = 0; j < pad.ny; ++j) {
        const double y = grid.centreY(j);
        for (int i = 0; i <= pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double x = gaps_.faces[0].pathMid[static_cast<std::size_t>(i)];
            const double gap = std::max(0.0, gaps_.faces[0].recess[at] + gaps_.lift(attitude, x, y));
            axes_[0].gap[at] = gap;
            axes_[0].tilt[at] = tiltOf(gaps_.faces[0].rise[at] - attitude.pitch * gaps_.faces[0].pathLength[static_cast<std::size_t>(i)], gap);
        }
    }
    for (int j = 0; j <= pad.ny; ++j) {
        const double y = gaps_.faces[1].pathMid[static_cast<std::size_t>(j)];
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double gap = std::max(0.0, gaps_.faces[1].recess[at] + gaps_.lift(attitude, grid.centreX(i), y));
            axes_[1].gap[at] = gap;
            axes_[1].tilt[at] = tiltOf(gaps_.faces[1].rise[at] - attitude.roll * gaps_.faces[1].pathLength[static_cast<std::size_t>(j)], gap);
        }
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (const CutPlace& place : gaps_.faces[axis].cut) axes_[axis].gap[place.at] = 0.0;

    totalVolume_ = 0.0;
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            volume_[at] = area_[at] * std::max(0.0, meanGap(i, j));
        }
    // Where part of a cut cell is closed, the rest holds the air.
    for (const CutPlace& cell : gaps_.cutCells) {
        double volume = 0.0;
        for (std::uint32_t k = gaps_.rows[cell.rows].pieces; k < gaps_.rows[cell.rows].pieceEnd; ++k)
            volume += gaps_.pieces[k].extent * std::max(0.0, gapOf<double>(gaps_.pieces[k]));
        volume_[cell.at] = volume;
    }
    for (const double volume : volume_) totalVolume_ += volume;
    const Velocity v = diskVelocity(setting_.disk, gaps_.length, gaps_.width, 0.5 * gaps_.length, 0.5 * gaps_.width);
    const double speed = std::max(std::hypot(v.x, v.y), 1e-3);
    flowScale_ = 0.5 * ambient() * speed * std::max(totalVolume_, gaps_.length * gaps_.width * closedGap) / gaps_.length;
}

void GasFilm::setStorage(double perTime, std::span<const double> history)
{
    storagePerTime_ = perTime;
    history_ = history;
}

double GasFilm::meanGap(int i, int j) const
{
    return gaps_.meanRecess[gaps_.pad.at(i, j)] + gaps_.lift(attitude_, gaps_.grid.centreX(i), gaps_.grid.centreY(j));
}

void GasFilm::completeFlows(FaceFlows<double>& flows)
{
    const PaddedGrid& pad = gaps_.pad;
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            limitRow(faces_[axis], flows.slope[axis], flows.flow[axis], pad.at(0, j),
                     static_cast<std::size_t>(pad.nx + (axis == 0)), pad.step(static_cast<int>(axis)));
}

template <typename Number>
void GasFilm::evaluate(std::span<const double> p, std::span<double> out)
{
    setFaceFlows<Number>(p);
    for (std::size_t axis = 0; axis < 2; ++axis)
        std::copy(faces_[axis].flow.begin(), faces_[axis].flow.end(), flows_.flow[axis].begin());
    setStored(p, storagePerTime_, flows_);
    for (std::size_t at = 0; at < flows_.stored.size(); ++at) flows_.stored[at] -= history_[at];
    if (complete()) {
        setSlopes(flows_);
        completeFlows(flows_);
        if constexpr (!std::is_same_v<Number, double>)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                FilmFaces& f = faces_[axis];
                const std::vector<double>& slope = flows_.slope[axis];
                const std::size_t step = gaps_.pad.step(static_cast<int>(axis));
                for (std::size_t at = step; at < slope.size(); ++at) {
                    const double byMean =
                        0.5 * f.share[at] * (slope[at - step] * f.belowByMean[at] + slope[at] * f.aboveByMean[at]);
                    f.ownLower[at] = -byMean - f.inflowShare[at] * f.inflowByLower[at];
                    f.ownUpper[at] = -byMean - f.inflowShare[at] * f.inflowByUpper[at];
                }
            }
    }
    divergence<double>(flows_, out);
}

void GasFilm::residual(std::span<const double> p, std::span<double> out) { evaluate<double>(p, out); }

void GasFilm::linearise(std::span<const double> p, std::span<double> out) { evaluate<ByPressure>(p, out); }

void GasFilm::clearRings(std::span<double> field) const
{
    const PaddedGrid& pad = gaps_.pad;
    for (int j = -PaddedGrid::rings; j < pad.ny + PaddedGrid::rings; ++j) {
        const bool inside = j >= 0 && j < pad.ny;
        for (int i = -PaddedGrid::rings; i < 0; ++i) field[pad.at(i, j)] = field[pad.at(pad.nx - 1 - i, j)] = 0.0;
        for (int i = 0; !inside && i < pad.nx; ++i) field[pad.at(i, j)] = 0.0;
    }
}

} // namespace touchdown
