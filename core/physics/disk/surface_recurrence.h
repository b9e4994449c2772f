// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often what passes under the slider comes again. What a slider does over a moving disk is known only after the
// rarest feature of the surface has passed under it. The wait for it depends on the part of the surface:
//
//   waves      their sum beats. The mean square over a time T differs from the long mean by less than a fifth (RMS over
//              all times at which T may begin): after 0.56 periods of one wave, 1.1 beats of two equal waves, 32/B of
//              many equal waves whose frequencies fill a band B;
//   roughness  likewise: for Gaussian heights over a path of length s the RMS deviation of the mean square is
//              sqrt(2 I/s), I the integral of the squared autocorrelation along the path;
//   a file     likewise, of the heights above the local mean; and at least the longest path between two places that are
//              0.8 times as far from it as the furthest one;
//   bumps      the longest path between two that are at least 0.6 times as strong as the strongest one. If the disk
//              moves askew, the path comes back beside itself after each track: all the tracks count until the paths
//              lie as close together as a quarter of the bump's width.
//
// A map's wait is no longer than its period. A slider follows long waves. So a wave or a bump counts with the share
// f^2/(f^2 + f0^2) of its height: f is the frequency at which it passes, f0 that of an oscillating slider.
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

/// The strip of the disk under the slider; for points on one line the line [m].
struct DiskStrip {
    double inner = 0.0, outer = 0.0;
};

/// Of a surface without problems that moves at this velocity under a strip.
SurfaceRecurrence surfaceRecurrence(const DiskSurface& surface, const DiskTopography& topography,
                                    const Velocity& velocity, const DiskStrip& strip);

/// The tracks after which a path that comes back `shift` beside itself, on a circle of length `around`, has been within
/// `apart` of each place [-]; fewer if the path closes before. At most a million.
double tracksUntilDense(double shift, double around, double apart);

} // namespace touchdown
