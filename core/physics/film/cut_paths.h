// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paths through the faces of one axis that an edge or a wall meets, laid out for vectors: rows of as many pieces
// stand side by side, each from its upstream end, so that one pass adds the same piece of many rows
// (core/physics/film/path_flow.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/work/team.h"

namespace touchdown {

class FlowTable;
struct Attitude;
struct FilmGaps;
template <typename Number>
struct PathFlow;

/// What the pressure between the two cells of a cut face does to the slider.
template <typename Number>
struct CutForces {
    Number excess{0.0}; // of the pressure's integral over the path, over what the cells' own pressures make [N]
    Number drag{0.0};   // shear of the pressure gradient along the axis [N]
};

class CutPaths {
public:
    /// Work space for a group of rows.
    class Work;

    CutPaths() = default;
    /// `speed`: that of the disk along the axis by face, `cross`: across it by cut face, halved [m/s]; `leastGap` as in
    /// FilmSetting; the gaps must last.
    CutPaths(const FilmGaps& gaps, std::size_t axis, std::span<const double> speed, std::span<const double> cross,
             double leastGap);

    /// What each cut face passes at these pressures (padded) above a disk of these heights under the faces, in the
    /// order of FilmGaps: as numbers, with the derivative by the mean pressure along the path (Dual<1>), or with those
    /// by height, pitch and roll (Dual<3>).
    /// Work space for as many threads as may take part.
    template <typename Number>
    void flows(std::span<const double> p, const Attitude& attitude, std::span<const double> surface,
               const FlowTable& table, double viscosity, std::span<Work> work,
               std::vector<PathFlow<Number>>& out) const;

    /// Forces at each cut face in the same way: as numbers, or with derivatives by the pressure below, above, and by
    /// height, pitch and roll (Dual<5>). Without layers, the excess is zero.
    template <typename Number>
    void forces(bool layers, std::span<const double> p, const Attitude& attitude, std::span<const double> surface,
                const FlowTable& table, double viscosity, std::span<Work> work,
                std::vector<CutForces<Number>>& out) const;

private:
    struct Group {
        std::size_t piece, row;  // the first ones
        std::size_t rows, depth; // side by side, pieces of each
    };

    /// solve(group, work) for all groups.
    template <typename Solve>
    void forGroups(std::span<Work> work, const Solve& solve) const;
    /// add(sum of the face, group, row of the group, row) for the rows of each face.
    template <typename Sum, typename Add>
    void sumByFace(std::vector<Sum>& out, const Add& add) const;
    /// Of the pieces of a group, with derivatives by the product of pressure and gap; of its rows, the mean pressures.
    void setMobilities(const Group& group, std::span<const double> p, const Attitude& attitude,
                       std::span<const double> surface, const FlowTable& table, Work& work) const;

    const FilmGaps* gaps_ = nullptr;
    std::size_t axis_ = 0;
    double leastGap_ = 0.0; // [m]
    std::vector<Group> groups_;
    std::vector<double> recess_, x_, y_, extent_, lead_, feed_; // by group, piece of the row, row [m]
    std::vector<double> drift_; // the same order: by how much less walls convect, gap times speed [m^2/s]
    std::vector<std::uint32_t> face_, groupOf_; // by row: among the cut ones, among the groups
    /// Rows of each face in ascending order: from faceRows_[firstRow_[face]] to before faceRows_[firstRow_[face + 1]].
    std::vector<std::uint32_t> faceRows_, firstRow_;
    std::vector<double> speed_, width_, share_, direction_; // by row [m/s], [m], of the face [-], -1: against the axis
    std::vector<double> upstream_, downstream_;             // by row, of the path on either side of the face [m]
};

class CutPaths::Work {
public:
    static constexpr std::size_t pieces = 512; // of a group, at least one row

    explicit Work(const FilmGaps& gaps);

private:
    friend class CutPaths;
    std::vector<double> gap_, product_, mobility_, mobilityBy_, byGap_; // by piece
    std::vector<double> mean_, open_, lift_, before_, beyond_;          // by row
    std::vector<double> path_; // of the first: sums along all rows, by group, number and row
};

template <typename Solve>
void CutPaths::forGroups(std::span<Work> work, const Solve& solve) const
{
    Team& team = Team::mine();
    const auto one = [&](int g, int thread) {
        solve(groups_[static_cast<std::size_t>(g)], work[static_cast<std::size_t>(thread)]);
    };
    const int count = static_cast<int>(groups_.size());
    if (work.size() >= static_cast<std::size_t>(team.size()))
        team.items(count, 2, 1, [&](int first, int end, int thread) {
            for (int g = first; g < end; ++g) one(g, thread);
        });
    else
        for (int g = 0; g < count; ++g) one(g, 0);
}

template <typename Sum, typename Add>
void CutPaths::sumByFace(std::vector<Sum>& out, const Add& add) const
{
    const int count = static_cast<int>(firstRow_.size()) - 1;
    out.resize(static_cast<std::size_t>(std::max(0, count)));
    Team::mine().items(count, 256, 1, [&](int first, int end, int) {
        for (std::size_t face = static_cast<std::size_t>(first); face < static_cast<std::size_t>(end); ++face) {
            Sum sum{};
            for (std::uint32_t n = firstRow_[face]; n < firstRow_[face + 1]; ++n) {
                const std::size_t row = faceRows_[n];
                const Group& group = groups_[groupOf_[row]];
                add(sum, group, row - group.row, row);
            }
            out[face] = sum;
        }
    });
}

} // namespace touchdown
