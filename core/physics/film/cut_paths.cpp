// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/cut_paths.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/flow_table.h"
#include "core/physics/film/gaps/film_gaps.h"
#include "core/physics/film/path_flow.h"

namespace touchdown {

namespace {

/// Sums along the paths of rows, and at last what they pass.
template <typename Number>
struct PathLanes {
    Lanes<Number> I, R, decay, before, after;

    PathLanes(double* first, std::size_t rows)
        : I(first, rows),
          R(first + I.parts * rows, rows),
          decay(first + 2 * I.parts * rows, rows),
          before(first + 3 * I.parts * rows, rows),
          after(first + 4 * I.parts * rows, rows)
    {}
    PathIntegral<Number> get(std::size_t k) const
    {
        return {I.get(k), R.get(k), decay.get(k), before.get(k), after.get(k)};
    }
};

/// The same piece of many rows.
struct PieceLanes {
    const double *gap, *mobility, *mobilityBy, *x, *y, *extent, *lead, *feed, *speed, *drift;
    double length, halfWidth; // of the slider [m]
    double least;             // gap [m]
};

/// Gaps, and their products with the mean pressure; any number where they are closed.
TOUCHDOWN_VECTOR_CLONES void setGaps(const Attitude& attitude, std::size_t rows, const double* lift,
                                     const double* recess, const double* x, const double* y, const double* mean,
                                     double least, double* gap, double* product)
{
    const double pitch = attitude.pitch, roll = attitude.roll;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const double h = std::max(least, recess[k] + (lift[k] - pitch * x[k] - roll * y[k]));
        gap[k] = h;
        product[k] = mean[k] * (h > closedGap ? h : 1e-6);
    }
}

template <typename Number>
TOUCHDOWN_VECTOR_CLONES void addPieces(const PathLanes<Number> path, const PieceLanes piece, double* open,
                                       std::size_t rows, double viscosity)
{
    const double *gap = piece.gap, *G = piece.mobility, *by = piece.mobilityBy, *x = piece.x, *y = piece.y;
    const double *extent = piece.extent, *lead = piece.lead, *feed = piece.feed, *speed = piece.speed,
                 *drift = piece.drift;
    const double length = piece.length, halfWidth = piece.halfWidth;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const bool passes = gap[k] > closedGap;
        Number h(passes ? gap[k] : 1.0), mobility(G[k]);
        if constexpr (derivatives<Number> == 1) mobility.by[0] = by[k];
        if constexpr (derivatives<Number> == 3) {
            const double free = gap[k] > piece.least ? 1.0 : 0.0;
            h.by = {free, free * (length - x[k]), free * (halfWidth - y[k])};
            for (std::size_t n = 0; n < 3; ++n) mobility.by[n] = by[k] * h.by[n];
        }
        const Number r = (12.0 * viscosity * extent[k]) / (h * h * mobility);
        PathIntegral<Number> sum = path.get(k);
        sum.add(r, (speed[k] * h - drift[k]) * r, lead[k], feed[k]);
        path.I.set(k, sum.I);
        path.R.set(k, sum.R);
        path.decay.set(k, sum.decay);
        path.before.set(k, sum.before);
        path.after.set(k, sum.after);
        open[k] = passes ? open[k] : 0.0;
    }
}

/// In place of the sums.
template <typename Number>
TOUCHDOWN_VECTOR_CLONES void finish(const PathLanes<Number> path, const double* open, const double* width,
                                    const double* share, const double* direction, std::size_t rows)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        PathFlow<Number> flow;
        flow.add(path.get(k), open[k] * width[k], open[k] * share[k], direction[k] < 0.0);
        path.I.set(k, flow.A);
        path.R.set(k, flow.B);
        path.decay.set(k, flow.K);
        path.before.set(k, flow.below);
        path.after.set(k, flow.above);
    }
}

std::size_t mostPieces(const FilmGaps& gaps)
{
    std::size_t most = CutPaths::Work::pieces;
    for (const FilmGaps::Faces& faces : gaps.faces)
        for (const CutPlace& place : faces.cut)
            for (std::uint32_t r = place.rows; r < place.rowEnd; ++r)
                most = std::max<std::size_t>(most, gaps.rows[r].pieceEnd - gaps.rows[r].pieces);
    return most;
}

} // namespace

CutPaths::Work::Work(const FilmGaps& gaps)
{
    for (auto* column : {&gap_, &product_, &mobility_, &mobilityBy_, &byGap_}) column->resize(mostPieces(gaps));
    for (auto* column : {&mean_, &open_, &lift_, &before_, &beyond_}) column->resize(pieces);
    std::size_t rows = 0;
    for (const FilmGaps::Faces& faces : gaps.faces) {
        std::size_t ofAxis = 0;
        for (const CutPlace& place : faces.cut) ofAxis += place.rowEnd - place.rows;
        rows = std::max(rows, ofAxis);
    }
    path_.reserve(6 * Lanes<Dual<4>>::parts * rows); // taken from the system when it is first used
}

CutPaths::CutPaths(const FilmGaps& gaps, std::size_t axis, std::span<const double> speed, std::span<const double> cross,
                   double leastGap)
    : gaps_(&gaps), axis_(axis), leastGap_(leastGap)
{
    const std::vector<CutPlace>& cut = gaps.faces[axis].cut;
    struct Entry {
        std::uint32_t row, face, depth;
    };
    std::vector<Entry> rows;
    for (std::uint32_t face = 0; face < cut.size(); ++face)
        for (std::uint32_t r = cut[face].rows; r < cut[face].rowEnd; ++r)
            rows.push_back({r, face, gaps.rows[r].pieceEnd - gaps.rows[r].pieces});
    std::stable_sort(rows.begin(), rows.end(), [](const Entry& a, const Entry& b) { return a.depth < b.depth; });
    for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
        const std::size_t depth = rows[first].depth,
                          most = std::max<std::size_t>(1, Work::pieces / std::max<std::size_t>(1, depth));
        while (end < rows.size() && rows[end].depth == depth && end - first < most) ++end;
        groupOf_.resize(end, static_cast<std::uint32_t>(groups_.size()));
        groups_.push_back({recess_.size(), first, end - first, depth});
        for (std::size_t n = 0; n < depth; ++n)
            for (std::size_t k = first; k < end; ++k) {
                const GapRow& row = gaps.rows[rows[k].row];
                const bool against = speed[cut[rows[k].face].at] < 0.0;
                const GapPiece& piece = gaps.pieces[against ? row.pieceEnd - 1 - n : row.pieces + n];
                recess_.push_back(piece.recess);
                x_.push_back(piece.x);
                y_.push_back(piece.y);
                extent_.push_back(piece.extent);
                lead_.push_back(against ? -piece.lead - piece.feed : piece.lead);
                feed_.push_back(piece.feed);
                const double along = speed[cut[rows[k].face].at] * piece.own - cross[rows[k].face] * piece.other;
                drift_.push_back(against ? -along : along);
            }
    }
    for (const Entry& entry : rows) {
        const CutPlace& place = cut[entry.face];
        double total = 0.0;
        for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) total += gaps.rows[r].width;
        face_.push_back(entry.face);
        speed_.push_back(std::abs(speed[place.at]));
        direction_.push_back(speed[place.at] < 0.0 ? -1.0 : 1.0);
        width_.push_back(gaps.rows[entry.row].width);
        share_.push_back(gaps.rows[entry.row].width / total);
        double below = 0.0, above = 0.0;
        for (std::uint32_t k = gaps.rows[entry.row].pieces; k < gaps.rows[entry.row].pieceEnd; ++k)
            (gaps.pieces[k].start < 0.0 ? below : above) += gaps.pieces[k].extent;
        upstream_.push_back(speed[place.at] < 0.0 ? above : below);
        downstream_.push_back(speed[place.at] < 0.0 ? below : above);
    }
    firstRow_.assign(cut.size() + 1, 0);
    for (const std::uint32_t face : face_) ++firstRow_[face + 1];
    for (std::size_t face = 0; face < cut.size(); ++face) firstRow_[face + 1] += firstRow_[face];
    std::vector<std::uint32_t> next(firstRow_.begin(), firstRow_.end() - 1);
    faceRows_.resize(face_.size());
    for (std::uint32_t row = 0; row < face_.size(); ++row) faceRows_[next[face_[row]]++] = row;
}

void CutPaths::setMobilities(const Group& group, std::span<const double> p, const Attitude& attitude,
                             std::span<const double> surface, const FlowTable& table, Work& work) const
{
    const std::vector<CutPlace>& cut = gaps_->faces[axis_].cut;
    const std::size_t step = gaps_->pad.step(static_cast<int>(axis_)), rows = group.rows;
    const double base = gaps_->lift(attitude, 0.0, 0.0);
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t face = face_[group.row + k], at = cut[face].at;
        work.mean_[k] = 0.5 * (p[at - step] + p[at]);
        work.lift_[k] = base - surface[face];
        work.open_[k] = 1.0;
    }
    for (std::size_t n = 0; n < group.depth; ++n) {
        const std::size_t in = n * rows, from = group.piece + in;
        setGaps(attitude, rows, work.lift_.data(), &recess_[from], &x_[from], &y_[from], work.mean_.data(), leastGap_,
                &work.gap_[in], &work.product_[in]);
    }
    table.at({work.product_.data(), rows * group.depth}, work.gap_, work.mobility_, work.mobilityBy_);
}

template <typename Number>
void CutPaths::flows(std::span<const double> p, const Attitude& attitude, std::span<const double> surface,
                     const FlowTable& table, double viscosity, std::span<Work> works,
                     std::vector<PathFlow<Number>>& out) const
{
    constexpr std::size_t parts = Lanes<Number>::parts;
    std::vector<double>& paths = works[0].path_;
    if (paths.size() < 5 * parts * face_.size()) paths.resize(5 * parts * face_.size());
    const auto lanes = [&](const Group& group) {
        return PathLanes<Number>(paths.data() + 5 * parts * group.row, group.rows);
    };
    forGroups(works, [&](const Group& group, Work& work) {
        const std::size_t rows = group.rows;
        setMobilities(group, p, attitude, surface, table, work);
        for (std::size_t n = 0; n < group.depth; ++n)
            for (std::size_t k = 0; k < rows; ++k) {
                const std::size_t in = n * rows + k;
                if constexpr (parts == 2) work.mobilityBy_[in] *= work.gap_[in];
                if constexpr (parts == 4)
                    work.mobilityBy_[in] =
                        work.mobilityBy_[in] * work.mean_[k] + table.gapDerivative(work.product_[in], work.gap_[in]);
            }
        const PathLanes<Number> path = lanes(group);
        std::fill_n(path.I.part[0], 5 * parts * rows, 0.0);
        std::fill_n(path.decay.part[0], rows, 1.0);
        for (std::size_t n = 0; n < group.depth; ++n) {
            const std::size_t in = n * rows, from = group.piece + in;
            addPieces<Number>(path,
                              {&work.gap_[in], &work.mobility_[in], &work.mobilityBy_[in], &x_[from], &y_[from],
                               &extent_[from], &lead_[from], &feed_[from], &speed_[group.row], &drift_[from],
                               gaps_->length, 0.5 * gaps_->width, leastGap_},
                              work.open_.data(), rows, viscosity);
        }
        finish<Number>(path, work.open_.data(), &width_[group.row], &share_[group.row], &direction_[group.row], rows);
    });
    sumByFace(out, [&](PathFlow<Number>& flow, const Group& group, std::size_t k, std::size_t) {
        const PathLanes<Number> path = lanes(group);
        flow.A = flow.A + path.I.get(k);
        flow.B = flow.B + path.R.get(k);
        flow.K = flow.K + path.decay.get(k);
        flow.below = flow.below + path.before.get(k);
        flow.above = flow.above + path.after.get(k);
    });
}

template void CutPaths::flows(std::span<const double>, const Attitude&, std::span<const double>, const FlowTable&,
                              double, std::span<Work>, std::vector<PathFlow<double>>&) const;
template void CutPaths::flows(std::span<const double>, const Attitude&, std::span<const double>, const FlowTable&,
                              double, std::span<Work>, std::vector<PathFlow<Dual<1>>>&) const;
template void CutPaths::flows(std::span<const double>, const Attitude&, std::span<const double>, const FlowTable&,
                              double, std::span<Work>, std::vector<PathFlow<Dual<3>>>&) const;

} // namespace touchdown
