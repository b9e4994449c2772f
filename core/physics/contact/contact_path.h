// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a quasi-static contact jumps. A contact with adhesion (or menisci) follows its separation d smoothly until the
// state it is in ceases to exist, and then falls into another one: it snaps in on the way down and pulls off on the way
// up. The force is discontinuous there: its change over a step does not shrink as the step is halved, which tells a
// jump from a steep but smooth piece.
#pragma once

#include <functional>

namespace touchdown {

/// A contact whose force depends on the separation and on how it came there. It has one memory slot.
struct ContactPath {
    std::function<double(double)>
        force;                      // [N], repulsive positive: moves from where the contact is to the separation d [m]
    std::function<void()> remember; // keeps the present state, in place of what was kept before
    std::function<void()> recall;   // returns to it; it may be recalled any number of times
};

struct ContactJump {
    bool found = false;
    double before = 0.0, after = 0.0;           // the separations next to it, before it and after it on the way [m]
    double forceBefore = 0.0, forceAfter = 0.0; // [N]
};

/// Locates a jump between `from`, where the contact is now with the force `forceAtFrom` [N], and `to`, either way. By
/// bisection: of two halves always the one over which the force changes more, until it is no longer than `resolution`
/// [m], and three times at least. It is a jump when the force still changes by more than `smallest` [N], and by more
/// than half of what it changed over the interval eight times as long; a smooth force changes by an eighth, next to a
/// fold by a third. In the end the contact is in the state `before`, which is remembered: force(after) steps over the
/// jump.
ContactJump locateJump(const ContactPath& path, double from, double forceAtFrom, double to, double resolution,
                       double smallest);

} // namespace touchdown
