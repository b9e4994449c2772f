// SPDX-License-Identifier: GPL-3.0-or-later
//
// The recess of a surface on the film's cells. A path runs from one cell centre to the next, across their face; the
// gaps along it act in series, and neighbouring paths in parallel. Where the recess is smooth, one sample in the middle
// represents the face. Where an edge or a wall meets it, the face has rows (core/physics/film/gaps/cut_rows.h), each
// divided at its breaks into pieces, exactly where the recess jumps: so the load converges also on grids that ignore
// the rails. The air in a cell is that under its centre's side of an edge.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/padded_grid.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

class CutRowArranger;
class GapSampler;
class Recess;

/// Gaps of flying sliders are some ten nanometres above the recess [m].
inline constexpr double typicalLift = 20e-9;

/// A part of a row in which the recess hardly changes.
struct GapPiece {
    double extent;                 // length along the path [m]; of a cell's piece, its area [m^2]
    double recess;                 // [m]
    double x, y;                   // where it was taken [m]
    double start;                  // of a path's piece, from the face [m]; none lies on both sides
    double own = 0.0, other = 0.0; // at a slanted wall, the disk's speed along the path convects with the gap less
                                   // `own`, its speed across the path with `other` (path_flow.h) [m]
    double lead = 0.0, feed = 0.0; // of the flow across: between face and start, along the piece; as lengths [m]
};

/// A face that an edge or a wall meets, or such a cell, whose pieces are one row and count for shear alone.
struct CutPlace {
    std::size_t at;             // padded index
    std::uint32_t rows, rowEnd; // in `rows`
};
/// How a row shares in the flow across: not, in proportion to h^2, or as far as it is like the centres
/// (cross_feed.cpp).
enum class Feed { None, ByGap, ByCentre };
struct GapRow {
    double width;                   // [m]; below zero where the row already counts at another face
    std::uint32_t pieces, pieceEnd; // in `pieces`
    Feed feed;
};

struct FilmGaps {
    /// `goOn` is asked at each row; if it returns false the result is incomplete and invalid.
    FilmGaps(const Recess& recess, CellGrid grid, const std::function<bool()>& goOn = {});

    CellGrid grid;
    PaddedGrid pad;
    double length, width; // of the slider [m]

    /// Per axis and face: middle of the path, its length, the width of the face, the recess there.
    struct Faces {
        std::vector<double> recess;     // padded [m]
        std::vector<double> rise;       // of the recess from end to end of a smooth path, padded [m]
        std::vector<double> pathMid;    // along the axis, by line [m]; nx + 1 or ny + 1
        std::vector<double> pathLength; // by line [m]
        std::vector<double> upperShare; // by line: (face - lower centre)/path length [-]
        std::vector<CutPlace> cut;
    };
    std::array<Faces, 2> faces;
    std::vector<double> centreRecess; // at the centres of the cells, padded [m]
    std::vector<double> meanRecess;   // of each cell, padded [m]
    std::vector<CutPlace> cutCells;
    std::size_t partedFaces = 0;           // of the cut ones, those that ridges part (cut_rows.h)
    std::vector<std::size_t> steppedCells; // cut cells in which a vertical step stands, padded indices
    std::vector<GapRow> rows;
    std::vector<GapPiece> pieces;

    /// What the attitude adds to the recess at a point [m].
    double lift(const Attitude& attitude, double x, double y) const
    {
        return attitude.height + attitude.pitch * (length - x) - attitude.roll * (y - 0.5 * width);
    }

private:
    /// A row of faces; cells in which a step stands are added to `stepped`.
    void sampleRow(const Recess& recess, int axis, int j, GapSampler& sampler, CutRowArranger& arranger,
                   std::vector<std::size_t>& stepped);
    void setCutCells(const CutRowArranger& sampled);
    /// Sets lead and feed of the pieces of paths (cross_feed.cpp).
    void setCrossFeed();
};

} // namespace touchdown
