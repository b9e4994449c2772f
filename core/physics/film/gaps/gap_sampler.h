// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples the recess along the paths through one face: rows side by side between the breaks across the face, each
// divided at its own breaks into pieces, so that edges are exact and slopes are followed.
#pragma once

#include <cstdint>
#include <vector>

#include "core/physics/film/gaps/film_gaps.h"

namespace touchdown {

class Recess;

/// A row through a face, with its pieces in the sampler.
struct SampledRow {
    double middle, width;           // across the face [m]
    double recess;                  // at the face [m]
    std::uint32_t pieces, pieceEnd; // in GapSampler::pieces
};

/// A path along `axis` from `start` to `end`, across a face from `low` to `high` at `face` [m].
struct FacePath {
    int axis;
    double start, end, face, low, high;
};

class GapSampler {
public:
    /// The recess must last.
    explicit GapSampler(const Recess& recess) : recess_(recess) {}

    /// Gaps that differ so much that flows do.
    static bool isStep(double lowest, double highest);
    double at(int axis, double along, double across) const;

    /// Sets rows and pieces. False if the path is so gentle that one number stands for it: small change over its length
    /// and width, and no jump.
    bool divide(const FacePath& path);
    /// The one row through the middle of the face, which stands for its whole width.
    void setMiddleRow(const FacePath& path);

    const std::vector<SampledRow>& rows() const { return rows_; }
    const std::vector<GapPiece>& pieces() const { return pieces_; }
    double lowest() const { return lowest_; }   // recess of the rows [m]
    double highest() const { return highest_; } // [m]
    /// Whether a vertical step crosses the rows below the face, above it; a wall, however steep, is none.
    bool stepsBelow() const { return stepBelow_; }
    bool stepsAbove() const { return stepAbove_; }

private:
    void clear();
    void breaks(int axis, double across, double from, double to);
    void addRow(const FacePath& path, double middle, double width);
    void addRows(const FacePath& path, double from, double to);
    void addPieces(const FacePath& path, double across);
    void joinSamples();
    template <typename Iterator>
    void joinAlike(Iterator from, Iterator to);
    void joinRows(double pathLength);

    const Recess& recess_;
    std::vector<SampledRow> rows_;
    std::vector<GapPiece> pieces_;
    std::vector<double> breaks_, ends_;
    std::vector<GapPiece> samples_;
    std::vector<double> means_;                               // recess of each row [m]
    double atFace_ = 0.0;                                     // of the last row [m]
    double lowest_ = 0.0, highest_ = 0.0, largestJump_ = 0.0; // of the face [m]
    bool stepBelow_ = false, stepAbove_ = false;
};

} // namespace touchdown
