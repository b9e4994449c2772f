// SPDX-License-Identifier: GPL-3.0-or-later
//
// The patches of a case's slider or pad that can touch the disk, each with its own grid of cells.
#pragma once

#include <functional>

#include "core/case/case.h"
#include "core/physics/contact/contact_patch.h"
#include "core/physics/disk/disk_topography.h"

namespace touchdown {

/// Cells of one side of a contact patch.
inline constexpr int fewestPatchCells = 2;
inline constexpr int mostPatchCells = 2048;

/// The patches of the pad of model "contact", or why there are none.
SliderPatches patchesOf(const Case& c, const DiskTopography& surface);

/// The patches of model "film", or why there are none: all points within elastic.patch_reach of the lowest point at
/// elastic.patch_pitch and zero roll. The search stops without patches when `goOn` returns false.
SliderPatches filmPatches(const Case& c, const std::function<bool()>& goOn = {});

} // namespace touchdown
