// SPDX-License-Identifier: GPL-3.0-or-later
//
// The areas between the ways in and out of a plot of the force against the separation. Where the force on the way out
// is below that on the way in, the contact takes energy out of the slider; where it is above, the contact creates
// energy. The first area less the second is W, the work that a touch-down and take-off takes.
#pragma once

#include <vector>

#include "core/physics/contact/ono_yamane.h"
#include "ui/plot/plot_curve.h"

namespace touchdown {

/// Of the five parameters: on the way in there is no force above d_s. One area where the law only takes energy; a part
/// that creates energy is a second area with a colour and a name of its own.
std::vector<ShadedArea> cycleAreas(const OnoYamane& parameters);

/// Of a pad that was moved in and out once, as it was recorded: both pyramids over time [m], [N]. None while it has not
/// turned back, and where the ways in and out are the same within a ten thousandth of the largest force.
std::vector<ShadedArea> cycleAreas(const MinMaxPyramid& separation, const MinMaxPyramid& netForce);

} // namespace touchdown
