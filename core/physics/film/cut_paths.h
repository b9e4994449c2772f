// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paths through the faces of one axis that an edge or a wall meets, laid out for vectors: rows of as many pieces
// stand side by side, each from its upstream end, so that one pass adds the same piece of many rows
// (core/physics/film/path_flow.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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
    template <typename Number>
    void flows(std::span<const double> p, const Attitude& attitude, std::span<const double> surface,
               const FlowTable& table, double viscosity, Work& work, std::vector<PathFlow<Number>>& out) const;

    /// Forces at each cut face in the same way: as numbers, or with derivatives by the pressure below, above, and by
    /// height, pitch and roll (Dual<5>). Without layers, the excess is zero.
    template <typename Number>
    void forces(bool layers, std::span<const double> p, const Attitude& attitude, std::span<const double> surface,
                const FlowTable& table, double viscosity, Work& work, std::vector<CutForces<Number>>& out) const;

private:
    struct Group {
        std::size_t piece, row;  // the first ones
        std::size_t rows, depth; // side by side, pieces of each
    };

    /// Of the pieces of a group, with derivatives by the product of pressure and gap; of its rows, the mean pressures.
    void setMobilities(const Group& group, std::span<const double> p, const Attitude& attitude,
                       std::span<const double> surface, const FlowTable& table, Work& work) const;

    const FilmGaps* gaps_ = nullptr;
    std::size_t axis_ = 0;
    double leastGap_ = 0.0; // [m]
    std::vector<Group> groups_;
    std::vector<double> recess_, x_, y_, extent_, lead_, feed_; // by group, piece of the row, row [m]
    std::vector<double> drift_;       // the same order: by how much less walls convect, gap times speed [m^2/s]
    std::vector<std::uint32_t> face_; // by row, among the cut ones
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
    std::vector<double> path_;                                          // sums along the rows, by number and row
};

} // namespace touchdown
