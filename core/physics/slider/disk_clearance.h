// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clearance: the least gap between the slider and the disk's actual surface w, which moves under it,
//
//   min over x, y of  s(x, y) + lift(x, y) - w(x - U t, y - V t).
//
// The nearest point to the mean plane (minimum_spacing.h) is a first bound. The slider is divided into 128 x 128 tiles;
// only those remain whose least gap to the highest point of the disk is below the bound. They are sampled on points of
// 1/1920 of the slider's sides, fewer where many tiles remain, and the lowest samples are followed downwards by halved
// steps. Of 60 drawn pairs of slider and disk none had a lower point among nine million others by more than 0.3 % of
// the disk's RMS height; tests/physics/slider/test_disk_clearance.cpp draws twelve.
#pragma once

#include <vector>

#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/slider/minimum_spacing.h"

namespace touchdown {

/// Keeps the recess at the samples of a tile once it was asked for: not for several threads.
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
    /// Height of the disk under a point of the slider, above its mean plane [m].
    double diskHeight(SurfacePoint under, double time) const
    {
        return disk_.height(under.x - velocity_.x * time, under.y - velocity_.y * time);
    }

private:
    static constexpr int tiles = 128;  // along each side
    static constexpr int samples = 16; // along each side of a tile
    struct Found {
        double gap;
        double x, y;
    };
    double lift(const Attitude& attitude, double x, double y) const;
    double gapAt(const Attitude& attitude, double x, double y, double time) const;
    double bound(const Attitude& attitude, int tile) const;
    const std::vector<float>& recessOf(int tile);
    /// Downhill from a point by `step` of the distance between samples, halved until it does not matter.
    Found followed(Found from, double step, const Attitude& attitude, double time) const;

    const Recess& recess_;
    const MinimumSpacing& spacing_;
    const DiskTopography& disk_;
    Velocity velocity_;
    double tileLength_, tileWidth_;                 // [m]
    std::vector<float> least_;                      // recess of each tile [m]
    std::vector<std::vector<float>> recessSamples_; // by tile, empty until asked for [m]
    std::vector<int> open_;                         // tiles that remain
};

} // namespace touchdown
