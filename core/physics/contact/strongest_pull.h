// SPDX-License-Identifier: GPL-3.0-or-later
//
// The strongest pull of a contact between two separations, found to a tolerance whatever the samples around it are:
// golden-section search (Kiefer 1953) for the least force on a way without jumps.
#pragma once

#include "core/physics/contact/contact_jump.h"

namespace touchdown {

struct PullPoint {
    double separation, force; // [m], > 0 repels [N]
};

/// Between two separations with at most one least force between them. The contact is in the remembered state, on the
/// way or at an end of it: each try starts there. In the end it is in another state; recall() leads back.
PullPoint strongestPull(const TracedContact& contact, double from, double to, double resolution);

} // namespace touchdown
