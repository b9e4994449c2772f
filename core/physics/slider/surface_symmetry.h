// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface is made symmetric about the slider's centre line.
#pragma once

#include "core/physics/slider/surface_edit.h"

namespace touchdown {

/// Each of these rails that has no mirror image within `reach` [m] gets one on a slider of this width [m]:
///
///   a rail on one side of the centre line    a copy on the other side, next to it in the order of overlap
///   a step that crosses the centre line      becomes the larger half, by area, and the mirror image of that half
///
/// A ramp that crosses the centre line, and a rail that crosses it more than twice, stay as they are.
AirBearingSurface madeSymmetric(AirBearingSurface surface, const PartSelection& rails, double width, double reach);

} // namespace touchdown
