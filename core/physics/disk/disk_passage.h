// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast the disk's surface changes under a point that stands still above it.
#pragma once

#include "core/physics/disk/disk_surface.h"
#include "core/physics/disk/disk_velocity.h"

namespace touchdown {

class DiskTopography;

/// Into so many parts a wave and the base of a bump are divided; a cell of a map into two.
inline constexpr double passageParts = 16.0;

/// The time in which a sixteenth of the shortest wave, a sixteenth of the base of the smallest bump, or half a cell of
/// the generated map passes [s]; infinite where nothing does.
double finestPassage(const DiskSurface& surface, const Velocity& velocity);
/// Of a measured map, too.
double finestPassage(const DiskSurface& surface, const DiskTopography& topography, const Velocity& velocity);

} // namespace touchdown
