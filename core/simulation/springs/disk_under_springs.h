// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disk's surface under the pad and the two pressure centres of the spring model, moved with the disk or held still.
//
// The places are those of the film's coordinates, so that both models see the same disk: the mass centre is over the
// slider's middle (L/2, W/2), the front centre d_f before it, the rear one d_r and the pad d_h behind it. The surface
// moves as it does under the slider's centre, with (U, V):
//
//   w = w(x - U t, y - V t),   w' = -U dw/dx - V dw/dy
#pragma once

#include <array>

#include "core/case/case.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/disk/surface_recurrence.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// Constant after construction.
class DiskUnderSprings {
public:
    /// Reads the case's file of a measured surface, which must be valid (core/case/disk_setup.h).
    explicit DiskUnderSprings(const Case& c);

    bool moves() const { return velocity_.x != 0.0 || velocity_.y != 0.0; }
    /// Heights and their rates at a time [s]; constant where nothing moves.
    SpringModel::Under at(double time) const { return moves() ? moved(time) : still_; }

    /// The longest step of time that resolves the surface [s]: a sixteenth of the shortest wave, a sixteenth of the
    /// smallest bump, or half a cell of a map passes in it. Infinite where nothing moves.
    double longestStep() const { return longestStep_; }
    /// The time that the surface takes from its origin to the furthest place [s]; 0 where nothing moves. The round-off
    /// of the places is as large as that of such a time.
    double passage() const;
    /// How often the surface comes again under pad and pressure centres.
    const SurfaceRecurrence& recurrence() const { return recurrence_; }
    /// At least the fastest rate of the heights [m/s].
    double fastestRate() const { return moves() ? (surface_.highest() - surface_.lowest()) / longestStep_ : 0.0; }

private:
    SpringModel::Under moved(double time) const;

    DiskTopography surface_;
    Velocity velocity_;                    // [m/s]
    std::array<Eigen::Vector2d, 3> place_; // in the order of SpringModel::Guard [m]
    double longestStep_;                   // [s]
    SurfaceRecurrence recurrence_;
    SpringModel::Under still_;
};

} // namespace touchdown
