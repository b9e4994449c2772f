// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clearance: the least gap between the slider and the disk's actual surface w, which moves under it,
//
//   min over x, y of  s(x, y) + lift(x, y) - w(x - U t, y - V t).
//
// Branch and bound (Land & Doig 1960): the slider is divided into boxes, halved along both sides, and the smaller ones
// along that side on which the gap changes more. The box with the
// least bound is looked at in its middle and divided, until no bound is below the least gap found by more than 1/1000
// of the disk's range of heights. There are two bounds of the gap in a box: its least recess, plus the lift at its
// lowest corner, less a bound of the disk under it; and in small boxes the tangents in the middle, less what recess and
// disk bend. Edges and lines where walls kink are searched by themselves, in the same way along each line: a box that
// one of them crosses is left out where the gap beside the line is nowhere level. At first the nearest point to the
// mean plane (minimum_spacing.h) and the last place found are followed downhill, at the end the least gap found. Under
// 300 drawn sliders over one to eight waves of 1.3 to 300 um, roughness or bumps, 1.4 million other points and a search
// from their lowest found none lower by more than 1e-4 of the disk's RMS height (of 1 nm for bumps); under rails askew
// up to 1e-3.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/slider/minimum_spacing.h"

namespace touchdown {

/// Remembers the last place: not for several threads.
class DiskClearance {
public:
    /// `velocity` of the surface under the slider, zero where it is held still [m/s]. The others must last.
    DiskClearance(const Recess& recess, const MinimumSpacing& spacing, const DiskTopography& disk,
                  const Velocity& velocity);

    struct Place {
        double gap;        // [m]; negative: the disk reaches into the undeformed slider
        SurfacePoint at;   // [m]
        double diskHeight; // of the disk there, above its mean plane [m]
    };
    Place at(const Attitude& attitude, double time);
    /// Where the search begins, written or read.
    void pass(auto& stream) { stream(last_, lastTime_); }
    /// Whether the disk's highest point is as high as a minimum spacing above the mean plane [m].
    bool mayReach(double spacing) const { return !disk_.flat() && spacing <= disk_.highest(); }
    /// Height of the disk under a point of the slider, above its mean plane [m].
    double diskHeight(SurfacePoint under, double time) const
    {
        return disk_.height(under.x - velocity_.x * time, under.y - velocity_.y * time);
    }

private:
    /// At levels m, n the slider has 2^m by 2^n boxes.
    struct Box {
        double bound; // of the gap [m]
        int levelX, levelY, i, j;
        bool operator<(const Box& other) const { return bound > other.bound; } // the least first in a heap
    };
    struct Found {
        double gap;
        double x, y;
    };
    struct Sides {
        double x, y;                  // of the middle [m]
        double halfLength, halfWidth; // [m]
    };
    /// The recess in a box is at least that of the plane, less the slack.
    struct Plane {
        double recess = 0.0;               // in the middle [m]
        double slopeX = 0.0, slopeY = 0.0; // [-]
        double slack = 0.0;                // [m]
    };
    /// Of the disk, in the middle of a box; curvature in all of it.
    struct DiskUnder : DiskPoint {
        CurvatureBound curvature;
    };
    void seekNearEdges(const Attitude& attitude, double spacing);
    double lift(const Attitude& attitude, double x, double y) const;
    Found gapAt(const Attitude& attitude, double x, double y, double time) const;
    Found followed(Found from, const Attitude& attitude, double time) const;
    void lookAlong(const MinimumSpacing::EdgePart& edge, int level, const Attitude& attitude, double time,
                   double tolerance, Found& least) const;

    Sides sidesOf(const Box& box) const;
    bool isSmooth(const Sides& sides) const;
    Plane planeOf(const Sides& sides) const;
    double leastRecess(const Sides& sides, int parts) const;    // [m]
    double highestUnder(const Sides& sides, double time) const; // a bound [m]
    DiskUnder under(const Sides& sides, double time) const;
    double leastOf(const Box& box) const; // what least_ knows [m]
    Box boxOf(int levelX, int levelY, int i, int j, const Attitude& attitude, double time) const;
    bool halvesLength(const Box& box, const Sides& sides, const Attitude& attitude, const DiskUnder& disk) const;
    double boundOf(const Plane& plane, const Sides& sides, const Attitude& attitude, const DiskUnder& disk) const;
    bool canHold(double below, const Box& box, const Sides& sides, const Attitude& attitude, const DiskUnder& disk);
    /// Of a box that edges may cross [m]; remembered, as neighbouring times look at the same boxes.
    struct Known {
        double middle = 0.0;
        std::optional<double> least; // of nine places, once it was asked for
    };
    Known& known(const Box& box, const Sides& sides);

    const Recess& recess_;
    const MinimumSpacing& spacing_;
    const DiskTopography& disk_;
    Velocity velocity_;
    std::vector<std::vector<float>> least_; // recess in the boxes of a level; those of the finest known one below [m]
    std::vector<Box> heap_;
    std::optional<Attitude> edgesAt_;                 // where nearEdges_ were sought
    std::vector<MinimumSpacing::EdgePart> nearEdges_; // that may hold the least gap within a margin of it
    std::unordered_map<std::uint64_t, Known> known_;  // by level and place of a box
    std::optional<SurfacePoint> last_;
    double lastTime_ = 0.0; // [s]
};

} // namespace touchdown
