// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numerics/vector_clones.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/film/path_flow.h"
#include "core/work/block_sums.h"

namespace touchdown {

namespace {

/// Gaps at a row of places, none below the least, where the lift is base - pitch x.
TOUCHDOWN_VECTOR_CLONES void setGaps(double base, double pitch, double least, std::size_t count, const double* x,
                                     const double* recess, double* gap)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) gap[k] = std::max(least, recess[k] + (base - pitch * x[k]));
}

/// Change of the gap along each path of a row against the gap; lift falls by slope times length. None where the gap is
/// not above the least.
TOUCHDOWN_VECTOR_CLONES void setTilts(double slope, double least, std::size_t count, const double* length,
                                      const double* rise, const double* gap, double* tilt)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const bool open = gap[k] > least;
        const double change = (rise[k] - slope * length[k]) / (open ? gap[k] : 1.0);
        tilt[k] = open ? std::min(1.0, std::max(-1.0, change)) : 0.0;
    }
}

} // namespace

FilmGeometry::FilmGeometry(std::shared_ptr<const FilmGaps> gaps, const DiskMotion& disk, double leastGap)
    : gaps_(std::move(gaps)), leastGap_(leastGap)
{
    const PaddedGrid& pad = gaps_->pad;
    const CellGrid& grid = gaps_->grid;
    const auto velocity = [&](double x, double y) { return diskVelocity(disk, gaps_->length, gaps_->width, x, y); };
    for (std::size_t axis = 0; axis < 2; ++axis) {
        Axis& a = axes_[axis];
        for (auto* field : {&a.gap, &a.tilt, &a.speed}) field->assign(pad.size(), 0.0);
        a.cutSurface.assign(gaps_->faces[axis].cut.size(), 0.0);
        const int along = axis == 0 ? pad.nx : pad.ny, across = axis == 0 ? pad.ny : pad.nx;
        for (int k = 0; k < across; ++k) a.width.push_back(axis == 0 ? grid.widthY(k) : grid.widthX(k));
        for (int k = 0; k < along; ++k) a.perWidth.push_back(1.0 / (axis == 0 ? grid.widthX(k) : grid.widthY(k)));
    }
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i <= pad.nx; ++i)
            axes_[0].speed[pad.at(i, j)] = 0.5 * velocity(grid.x[static_cast<std::size_t>(i)], grid.centreY(j)).x;
    for (int j = 0; j <= pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i)
            axes_[1].speed[pad.at(i, j)] = 0.5 * velocity(grid.centreX(i), grid.y[static_cast<std::size_t>(j)]).y;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        std::vector<double> cross; // of the disk across the paths of cut faces, halved [m/s]
        for (const CutPlace& place : gaps_->faces[axis].cut) {
            const int i = pad.column(place.at), j = pad.row(place.at);
            cross.push_back(axis == 0 ? 0.5 * velocity(grid.x[static_cast<std::size_t>(i)], grid.centreY(j)).y
                                      : 0.5 * velocity(grid.centreX(i), grid.y[static_cast<std::size_t>(j)]).x);
        }
        axes_[axis].cutPaths = CutPaths(*gaps_, axis, axes_[axis].speed, cross, leastGap_);
    }
    const Velocity v = velocity(0.5 * gaps_->length, 0.5 * gaps_->width);
    const double square = v.x * v.x + v.y * v.y;
    if (square > 0.0) motionShare_ = {v.x * v.x / square, v.y * v.y / square};
    speed_ = std::hypot(v.x, v.y);
    rowWork_.resize(static_cast<std::size_t>(Team::mine().size()));
    for (RowWork& work : rowWork_)
        for (auto* row : {&work.recess, &work.rise, &work.length}) row->assign(pad.stride(), 0.0);
    volume_.assign(pad.size(), 0.0);
    area_.assign(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) area_[pad.at(i, j)] = grid.widthX(i) * grid.widthY(j);
    for (int i = 0; i < pad.nx; ++i) centreX_.push_back(grid.centreX(i));
    setAttitude({});
}

void FilmGeometry::setRowOverSurface(std::size_t axis, int j, RowWork& work)
{
    const PaddedGrid& pad = gaps_->pad;
    const FilmGaps::Faces& faces = gaps_->faces[axis];
    const std::size_t first = pad.at(0, j), nx = static_cast<std::size_t>(pad.nx),
                      step = pad.step(static_cast<int>(axis));
    const auto set = [&](std::size_t k, double below, double above) {
        work.recess[k] = faces.recess[first + k] - 0.5 * (below + above);
        work.rise[k] = faces.rise[first + k] - (above - below);
    };
    const bool lowest = axis == 1 && j == 0, highest = axis == 1 && j == pad.ny;
    const double *above = surface_.data() + (highest ? first - step : first),
                 *below = lowest ? above : surface_.data() + first - step;
    for (std::size_t k = 0; k < nx; ++k) set(k, below[k], above[k]);
    if (axis == 1) return;
    set(0, surface_[first], surface_[first]);
    set(nx, surface_[first + nx - 1], surface_[first + nx - 1]);
}

void FilmGeometry::setCutSurface(std::size_t axis)
{
    const std::vector<CutPlace>& cut = gaps_->faces[axis].cut;
    const std::size_t step = gaps_->pad.step(static_cast<int>(axis));
    std::vector<double>& heights = axes_[axis].cutSurface;
    std::fill(heights.begin(), heights.end(), 0.0);
    for (std::size_t n = 0; !surface_.empty() && n < cut.size(); ++n) {
        // The rings' cells have no area.
        const std::size_t above = cut[n].at, below = above - step;
        heights[n] =
            0.5 * (surface_[area_[below] > 0.0 ? below : above] + surface_[area_[above] > 0.0 ? above : below]);
    }
}

void FilmGeometry::setAttitude(const Attitude& attitude)
{
    attitude_ = attitude;
    for (std::size_t axis = 0; axis < 2; ++axis) setFaceGaps(axis);
    setVolumes();
}

template <typename Set>
void FilmGeometry::forRows(int count, const Set& set)
{
    Team& team = Team::mine();
    const bool alone = rowWork_.size() < static_cast<std::size_t>(team.size());
    team.items(count, alone ? count : 48, 1, [&](int first, int end, int thread) {
        for (int j = first; j < end; ++j) set(j, rowWork_[static_cast<std::size_t>(thread)]);
    });
}

void FilmGeometry::setFaceGaps(std::size_t axis)
{
    const PaddedGrid& pad = gaps_->pad;
    const double base = gaps_->lift(attitude_, 0.0, 0.0);
    const std::size_t count = static_cast<std::size_t>(pad.nx + (axis == 0));
    const FilmGaps::Faces& faces = gaps_->faces[axis];
    Axis& a = axes_[axis];
    const auto setRow = [&](int j, RowWork& work) {
        const std::size_t at = pad.at(0, j), line = static_cast<std::size_t>(j);
        const double y = axis == 0 ? gaps_->grid.centreY(j) : faces.pathMid[line];
        if (axis == 1) std::fill(work.length.begin(), work.length.end(), faces.pathLength[line]);
        if (!surface_.empty()) setRowOverSurface(axis, j, work);
        setGaps(base - attitude_.roll * y, attitude_.pitch, leastGap_, count,
                axis == 0 ? faces.pathMid.data() : centreX_.data(),
                surface_.empty() ? &faces.recess[at] : work.recess.data(), &a.gap[at]);
        setTilts(axis == 0 ? attitude_.pitch : attitude_.roll, std::max(leastGap_, closedGap), count,
                 axis == 0 ? faces.pathLength.data() : work.length.data(),
                 surface_.empty() ? &faces.rise[at] : work.rise.data(), &a.gap[at], &a.tilt[at]);
    };
    forRows(pad.ny + (axis == 1), setRow);
    for (const CutPlace& place : faces.cut) a.gap[place.at] = 0.0;
    setCutSurface(axis);
}

void FilmGeometry::setVolumes()
{
    const PaddedGrid& pad = gaps_->pad;
    const double base = gaps_->lift(attitude_, 0.0, 0.0);
    const std::size_t nx = static_cast<std::size_t>(pad.nx);
    forRows(pad.ny, [&](int j, RowWork& work) {
        const std::size_t at = pad.at(0, j);
        const double* recess = &gaps_->centreRecess[at];
        if (!surface_.empty()) {
            for (std::size_t k = 0; k < nx; ++k) work.recess[k] = recess[k] - surface_[at + k];
            recess = work.recess.data();
        }
        setGaps(base - attitude_.roll * gaps_->grid.centreY(j), attitude_.pitch, 0.0, nx, centreX_.data(), recess,
                &volume_[at]);
        for (std::size_t k = at; k < at + nx; ++k) volume_[k] *= area_[k];
    });
    totalVolume_ = sumOfBlocks(volume_.size(), [&](std::size_t first, std::size_t count) {
        return sumInLanes(count, [&](std::size_t k) { return volume_[first + k]; });
    });
}

void FilmGeometry::setVolumeSlopes(std::size_t k, double scale, std::span<const double> factor,
                                   std::vector<double>& out) const
{
    const PaddedGrid& pad = gaps_->pad;
    out.resize(pad.size());
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double area = volume_[at] > 0.0 ? area_[at] : 0.0;
            const std::array<double, 3> lift{1.0, gaps_->length - centreX_[static_cast<std::size_t>(i)],
                                             0.5 * gaps_->width - gaps_->grid.centreY(j)};
            out[at] = scale * factor[at] * area * lift[k];
        }
}

double FilmGeometry::meanGap(int i, int j) const
{
    const std::size_t at = gaps_->pad.at(i, j);
    return gaps_->meanRecess[at] - surfaceAt(at) +
           gaps_->lift(attitude_, gaps_->grid.centreX(i), gaps_->grid.centreY(j));
}

void FilmGeometry::clearRings(std::span<double> field) const
{
    const PaddedGrid& pad = gaps_->pad;
    for (int j = -PaddedGrid::rings; j < pad.ny + PaddedGrid::rings; ++j) {
        const bool inside = j >= 0 && j < pad.ny;
        for (int i = -PaddedGrid::rings; i < 0; ++i) field[pad.at(i, j)] = field[pad.at(pad.nx - 1 - i, j)] = 0.0;
        for (int i = 0; !inside && i < pad.nx; ++i) field[pad.at(i, j)] = 0.0;
    }
}

} // namespace touchdown
