// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of a surface nearest to the mean plane of the disk, independent of the film's grid: at corners and edges of
// rails, where the wall of an edge begins or bends, or, with crown and camber, inside.
//
// Several thousand points are compared, in blocks: a lattice, both sides of each edge, the lines along an edge at the
// distances where its wall begins, bends or ends, from the border with the wall of one neighbour to that with the
// other, and where such lines of two rails cross. A block's least recess at the lowest corner of its box is a lower
// bound of its points, also in rounded numbers; so most blocks are skipped, and the result is that of all points. From
// the nearest one a search by halved steps goes down where the surface does, as where walls of two rails meet at the
// same depth. At 400 drawn attitudes of sliders with one to five rails whose walls overlap, a million other points and
// a search from their lowest found a lower one at 4, by up to 0.1 nm.
#pragma once

#include <optional>
#include <vector>

#include "core/physics/slider/attitude.h"
#include "core/physics/slider/recess.h"

namespace touchdown {

class MinimumSpacing {
public:
    MinimumSpacing(const AirBearingSurface& surface, const Recess& recess);

    const Recess& recess() const { return recess_; }
    struct Place {
        double spacing;  // [m], may be negative
        SurfacePoint at; // [m]
    };
    Place at(const Attitude& attitude) const;
    /// The minimum spacing, at the mean place of all points within `depth` [m], > 0, of it, weighted from 1 at the
    /// nearest to 0 at that depth. Unlike the nearest point it moves continuously with the attitude.
    Place bearing(const Attitude& attitude, double depth) const;

    /// Part of an edge, or of a line where a wall kinks, just beside it: there the recess is that of a straight line,
    /// less the slack at most.
    struct EdgePart {
        SurfacePoint from, to;          // [m]
        double recess, recessTo, slack; // [m]
    };
    const std::vector<EdgePart>& edges() const { return edges_; }

private:
    friend class NearbySpacing;
    struct Candidate {
        double x, y, recess; // [m]
    };
    /// Bounds of x, y and recess of `blockSize` neighbours in the list.
    static constexpr std::size_t blockSize = 16;
    struct Block {
        double x0, x1, y0, y1, recess; // [m]
    };
    Place nearestListed(const Attitude& attitude) const;
    /// Down from the nearest point of the list.
    Place lowestBeside(const Place& listed, const Attitude& attitude) const;
    /// The mean place of those of a part of the list that bear.
    class Bearing;
    void setBlocks();
    void addEdgePart(SurfacePoint from, SurfacePoint to);
    double above(const Candidate& c, const Attitude& attitude) const
    {
        return c.recess + attitude.height + attitude.pitch * (length_ - c.x) - attitude.roll * (c.y - 0.5 * width_);
    }
    /// A lower bound of the points of a block.
    double bound(const Block& b, const Attitude& attitude) const
    {
        return above({attitude.pitch > 0.0 ? b.x1 : b.x0, attitude.roll > 0.0 ? b.y1 : b.y0, b.recess}, attitude);
    }
    Recess recess_;
    double length_, width_; // [m]
    std::vector<Candidate> candidates_;
    std::vector<Block> blocks_;
    std::vector<EdgePart> edges_;
};

/// The minimum spacing in small motions: of all points only those are compared that can be the nearest within `margin`
/// [m] of the attitude that was last searched in full. The way down from the nearest one of the list to the surface's
/// lowest point is taken from there; where there is one and another point comes nearest it is searched again.
class NearbySpacing {
public:
    /// The spacing must last. With a margin of zero each attitude is searched in full.
    NearbySpacing(const MinimumSpacing& spacing, double margin) : spacing_(&spacing), margin_(margin) {}

    double at(const Attitude& attitude); // [m]
    /// As MinimumSpacing::bearing; of a depth above a tenth of the margin by a full search.
    MinimumSpacing::Place bearing(const Attitude& attitude, double depth);

    /// Where it was last searched, written or read.
    void pass(auto& stream)
    {
        stream(searched_);
        if (stream.reads() && searched_) search(*searched_);
    }

private:
    double search(const Attitude& attitude);
    double look(const Attitude& attitude, double& listed);

    const MinimumSpacing* spacing_;
    double margin_; // of the corners' displacement [m]
    std::optional<Attitude> searched_;
    std::vector<MinimumSpacing::Candidate> near_;
    std::size_t nearest_ = 0; // of them, there
    double down_ = 0.0;       // from it [m]
};

} // namespace touchdown
