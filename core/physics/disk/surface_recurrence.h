// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often what passes under the slider comes again. What a slider does over a moving disk is known only after the
// rarest feature of the surface has passed under it. The wait for it depends on the part of the surface:
//
//   waves      their sum beats. The mean square over a time T differs from the long mean by less than a fifth (RMS over
//              all times at which T may begin): after 0.56 periods of one wave, 1.1 beats of two equal waves, 32/B of
//              many equal waves whose frequencies fill a band B;
//   maps       generated or measured: likewise, of the heights along the path; and at least the longest path between
//              two places that are 0.8 times as high as the highest one, or as deep as the deepest one; of a wide
//              slider on up to 16 lines of its strip;
//   bumps      the longest path between two that are 0.8 times as high as the highest one; likewise for pits.
//
// Pits do not stand for bumps, as only bumps touch; those below a quarter of the others do not count. If the disk moves
// askew, the path comes back beside itself after each track: all the tracks count until the paths lie as close together
// as two points of the map, or a quarter of the bump's width.
//
// A slider follows long waves, but how long these are depends on it. What it does not follow of a wave or a bump is the
// share f^2/(f^2 + f0^2) of its height, f being the frequency at which it passes; of a map the height above the mean
// over the time 1/f0. The limit f0 is at most that of an oscillating slider, 300 kHz, and at least that at which the
// surface passes once along the slider: where the surface is longer, all of the slider sees the same height. The wait
// is the longest of those for all limits between. So no high frequent feature stands for a rare long one, nor a high
// long one for a rare short one.
#pragma once

#include "core/physics/disk/disk_surface.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"

namespace touchdown {

struct SurfaceRecurrence {
    double period = 0.0; // after which the whole surface is the same again [s]; infinite: not within 1000 of the
                         // longest period of a part; 0: nothing passes
    double wait = 0.0;   // longest time until the rarest feature comes again [s]; 0: nothing passes
    bool moves() const { return wait > 0.0; }
};

/// The strip of the disk under the slider.
struct DiskStrip {
    double inner = 0.0, outer = 0.0; // the same for points on one line [m]
    double length = 0.0;             // of the slider [m]
};

/// Of a surface without problems that moves at this velocity under a slider.
SurfaceRecurrence surfaceRecurrence(const DiskSurface& surface, const DiskTopography& topography,
                                    const Velocity& velocity, const DiskStrip& strip);

/// The tracks after which a path that comes back `shift` beside itself, on a circle of length `around`, has been within
/// `apart` of each place [-]; fewer if the path closes before. At most a million.
double tracksUntilDense(double shift, double around, double apart);

} // namespace touchdown
