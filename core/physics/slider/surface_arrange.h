// SPDX-License-Identifier: GPL-3.0-or-later
//
// How rails are placed beside each other: mirrored copies, alignment, equal gaps, rows of copies. Functions from a
// surface to a changed one, as those of core/physics/slider/surface_edit.h. Parts that are not rails of the surface
// are passed over.
#pragma once

#include <cstdint>

#include "core/physics/slider/surface_edit.h"

namespace touchdown {

/// With copies of these rails, mirrored about the centre line of a slider of this width [m]; the last ones in the list.
AirBearingSurface withMirroredCopies(AirBearingSurface surface, const PartSelection& parts, double width);

/// The least x, the middle or the largest x of rails; Bottom to Top along y.
enum class Alignment : std::uint8_t { Left, MiddleX, Right, Bottom, MiddleY, Top };
/// These rails are moved to that edge, or that middle, of the rectangle around all of them.
AirBearingSurface aligned(AirBearingSurface surface, const PartSelection& parts, Alignment to);

/// Of three or more rails the first and the last along x (else y) stay; the others, in the order of their middles, get
/// equal gaps between their rectangles. Where there is too little room the rectangles overlap by equal lengths.
AirBearingSurface distributed(AirBearingSurface surface, const PartSelection& parts, bool alongX);

/// With `count` copies of these rails, the k-th moved by k times `step`; the last ones in the list.
AirBearingSurface withArray(AirBearingSurface surface, const PartSelection& parts, int count, SurfaceShift step);

} // namespace touchdown
