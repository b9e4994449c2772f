// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the fields of two static states of sliders of the same size differ, on the cells of the first.
#pragma once

#include <vector>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// First minus second, x fastest. The pressure is that above ambient; of the second state it is taken bilinearly at the
/// cell centres. Gap and recess of the second state are those of its shape and attitude on the cells of the first, so
/// that no step of a surface is smeared.
struct FieldDifference {
    std::vector<double> pressure; // [Pa]
    std::vector<double> gap;      // [m]
    std::vector<double> recess;   // [m]
};
/// Both states have fields. Takes as long as the gaps of one grid (some ten milliseconds at 193 x 193).
FieldDifference fieldDifference(const Case& first, const SteadyResult& firstState, const Case& second,
                                const SteadyResult& secondState);

} // namespace touchdown
