// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the faces across one axis that an edge or a wall meets. A cell's pressure is that of the side of the edge
// on which its centre lies:
//
//   across  Where a centre is shallow, the row through both centres stands for the whole face: the flow into the
//           shallow side needs the distance from its centre to the edge along the path (Gibou et al. 2002).
//   along   The open width of each line of faces is exact (Ng, Min & Gibou 2009). The deep parts of a face with a
//           shallow centre belong to deep cells beside it: they count at the nearest face in the line whose centres are
//           both deep, less the row through the centres that already stands for them.
//
// A ridge is a shallow part between two deeper ones. Air flows over it, hardly round it. It blocks a face if it stands
// between the two centres, or, where both are deep, between a centre and the end of some row, which then lies beyond
// the ridge. For a parted face, too, the row through the centres stands for the whole face. So a slanted ridge lies in
// exactly one path of each line, and what the faces along x and y pass through it adds up.
//
// Rows that were merely parallel would close a channel that runs slantwise by half a cell on either side, as each of
// them enters a rail before it reaches the next centre, though the air flows round.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/physics/film/gaps/film_gaps.h"
#include "core/physics/film/gaps/gap_sampler.h"

namespace touchdown {

/// A face as the sampler divided it.
struct SampledFace {
    std::size_t at; // padded index
    FacePath path;
    std::uint32_t rows, rowEnd; // in CutRowArranger::rows
    double lowest, highest;     // recess [m]
};

class CutRowArranger {
public:
    /// `gaps` with the recess at its centres; it must last.
    CutRowArranger(FilmGaps& gaps, GapSampler& sampler, std::size_t axis);

    FacePath pathOf(std::size_t at) const;
    /// A face as the sampler has just divided it; faces come in ascending order.
    void add(std::size_t at, const FacePath& path);
    /// Adds the faces of another one of the same axis, which follow.
    void append(const CutRowArranger& next);
    /// Adds cut faces, their rows and pieces to the gaps.
    void finish();

    const std::vector<SampledFace>& faces() const { return faces_; }
    const std::vector<SampledRow>& rows() const { return rows_; }
    const std::vector<GapPiece>& pieces() const { return pieces_; }

private:
    /// A deep part of a face that counts at another one.
    struct Given {
        std::size_t to;       // face, padded index
        std::size_t from;     // face, in faces_
        double width, middle; // across the face [m]
        double recess;        // at the face [m]
    };

    bool isOutermost(const SampledFace& face) const;
    /// Of a face open over its whole width, whose paths meet an edge: the side, -1 or 1, on which they are open; 0
    /// where the edge stands so square to the paths that none within reach is.
    int openSide(const SampledFace& face, double shallowGap) const;
    /// The nearest face in the line, in this direction (-1, 1), whose centres are both deep beside this gap [m] and to
    /// which the faces between are open over their whole width; none beyond a parted face.
    std::optional<std::size_t> receiver(const SampledFace& face, int direction, double shallowGap) const;
    /// Divides face n, which has a shallow centre, into the row through the centres and parts for other faces.
    void give(std::size_t n, double shallowGap);
    /// The row through the middle of a face, its pieces added to pieces_.
    SampledRow keptMiddleRow(const FacePath& path);
    /// Whether a ridge stands between two places along the path that was sampled last [m].
    bool meetsRidge(const FacePath& path, double from, double to) const;
    /// Whether a ridge parts the face whose middle row was sampled last.
    bool isParted(const SampledFace& face, bool areDeep) const;
    void openFace(std::size_t at);
    void addRow(const SampledRow& row, const std::vector<GapPiece>& pieces, double width, Feed feed);
    void addDeepFace(const SampledFace& face);
    void addMiddleRow(std::size_t n);
    void addGiven(const Given& given);

    FilmGaps& gaps_;
    GapSampler& sampler_;
    std::size_t axis_;
    std::vector<SampledFace> faces_;
    std::vector<SampledRow> rows_;
    std::vector<GapPiece> pieces_;
    std::vector<SampledRow> middleRows_; // by face, where an edge with a contrast meets it
    std::vector<bool> parted_;           // by face: a ridge parts its centres or rows
    std::vector<double> keptWidth_;      // by row: what stays at its own face [m]
    std::vector<Given> given_;
};

} // namespace touchdown
