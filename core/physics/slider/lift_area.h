// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where an air bearing surface can carry a slider at all, told from its shape alone.
//
// Air lifts a slider under the rails that stand far out of its base. What presses it down, the suspension and the
// suction behind the rails, balances their lift only about a point between them: a slider whose rails do not surround
// the place where the suspension presses tips over. This is a rule for a design that is being drawn, not a proof: it
// asks for no pressure.
#pragma once

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// Whether `load` lies within the convex hull of the rails that are less deep than the base; between their ends where
/// the roll is held. Always where the base itself may carry, as on a plain plate: where no rail stands out of it by
/// more than 0.5 um.
bool railsSurround(const AirBearingSurface& surface, SurfacePoint load, bool rollHeld = false);

} // namespace touchdown
