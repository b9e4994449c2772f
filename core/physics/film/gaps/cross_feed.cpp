// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the flow across a path enters or leaves it. The complete flux scheme needs the change of the flow along a path
// and knows the net flow across of whole cells. In a cell with an edge or a wall that flow prefers the deep side, as
// the conductance of rarefied air is h^2 (mean free path longer than the gap). So each piece of a path gets its part in
// proportion to h^2, at most four times the even one. The parts of a cell add up to its area: the corrections at its
// two faces then never exceed what crosses it. If they do, nothing binds the cell's pressure to that flow, and Newton's
// method runs in circles. Spread evenly, the flow has errors of several per cent at slanted walls, with opposite signs
// along x and y.
//
// In a row across an edge so steep that one centre is far deeper than the other, the flow across is that of the
// centre's side of the edge: pieces like the centre's have their even part, the others none. On a rail that is the leak
// towards its side; what a deep cell passes on along its edge is many times what the rail could take.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/physics/film/gaps/film_gaps.h"

namespace touchdown {

namespace {

/// Of a recess, the gap as it may be in flight, squared [m^2].
double conduction(double recess)
{
    const double gap = std::max(0.0, recess) + typicalLift;
    return gap * gap;
}

/// Limit of a narrow deep part, which would take the flow of the whole cell and slow down the solvers' sweeps.
constexpr double mostShare = 4.0;
/// Of the gap of a piece against that at the cell's centre, for rows across a steep edge [-].
constexpr double mostContrast = 3.0;

/// Whether the flow across a cell with this recess at its centre also crosses a piece.
bool isLike(double piece, double centre)
{
    const double ratio = conduction(piece) / conduction(centre);
    return ratio < mostContrast * mostContrast && ratio * mostContrast * mostContrast > 1.0;
}

/// By cell, of the rows along one axis that share by their gap: their area and their conduction times area. A half
/// whose face is smooth is not among them: it has its even part.
struct CellConduction {
    std::vector<double> area, sum; // [m^2], [m^4]

    CellConduction(const FilmGaps& gaps, int axis) : area(gaps.pad.size(), 0.0), sum(gaps.pad.size(), 0.0)
    {
        const FilmGaps::Faces& faces = gaps.faces[static_cast<std::size_t>(axis)];
        const std::size_t step = gaps.pad.step(axis);
        for (const CutPlace& place : faces.cut)
            for (std::uint32_t r = place.rows; r < place.rowEnd; ++r)
                for (std::uint32_t k = gaps.rows[r].pieces;
                     gaps.rows[r].feed == Feed::ByGap && k < gaps.rows[r].pieceEnd; ++k) {
                    const GapPiece& piece = gaps.pieces[k];
                    const std::size_t cell = piece.start < 0.0 ? place.at - step : place.at;
                    const double part = gaps.rows[r].width * piece.extent; // [m^2]
                    area[cell] += part;
                    sum[cell] += part * conduction(piece.recess);
                }
    }
};

} // namespace

void FilmGaps::setCrossFeed()
{
    for (const int axis : {0, 1}) {
        const CellConduction cells(*this, axis);
        const std::size_t step = pad.step(axis);
        for (const CutPlace& place : faces[static_cast<std::size_t>(axis)].cut)
            for (std::uint32_t r = place.rows; r < place.rowEnd; ++r) {
                if (rows[r].feed == Feed::None) continue;
                const auto setFeed = [&](GapPiece& piece, std::size_t cell) {
                    if (rows[r].feed == Feed::ByCentre) {
                        piece.feed = isLike(piece.recess, centreRecess[cell]) ? piece.extent : 0.0;
                        return;
                    }
                    const double share = conduction(piece.recess) * cells.area[cell] / cells.sum[cell];
                    piece.feed = piece.extent * std::min(share, mostShare);
                };
                // From the face outwards, so that no rounding takes a piece to its other side.
                const GapRow& row = rows[r];
                double below = 0.0, above = 0.0;
                for (std::uint32_t k = row.pieceEnd; k-- > row.pieces;) {
                    GapPiece& piece = pieces[k];
                    if (piece.start >= 0.0) continue;
                    setFeed(piece, place.at - step);
                    below += piece.feed;
                    piece.lead = -below;
                }
                for (std::uint32_t k = row.pieces; k < row.pieceEnd; ++k) {
                    GapPiece& piece = pieces[k];
                    if (piece.start < 0.0) continue;
                    setFeed(piece, place.at);
                    piece.lead = above;
                    above += piece.feed;
                }
            }
    }
}

} // namespace touchdown
