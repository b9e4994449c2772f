// SPDX-License-Identifier: GPL-3.0-or-later
//
// Jumps of a quasi-static contact. A contact with adhesion (or menisci) follows its separation d smoothly until its
// state ceases to exist and another one replaces it: it snaps in on the way down and pulls off on the way up. There the
// force is discontinuous: its change over a step does not shrink when the step is halved, unlike that of a steep but
// smooth piece.
#pragma once

#include <functional>

namespace touchdown {

/// A contact whose force depends on the separation and on how it came there. It has one memory slot, or two.
struct TracedContact {
    std::function<double(double)> force; // moves the contact to the separation d [m]; returns the force, > 0 repels [N]
    std::function<void()> remember;      // stores the present state in place of the one stored before
    std::function<void()> recall;        // returns to the stored state, any number of times
    std::function<bool()> jumped{};      // whether the last move may have jumped; may be empty: by the force alone
    std::function<void()> mark{}, back{}; // remember and recall of the second slot; may be empty
};

struct ContactJump {
    bool found = false;
    double before = 0.0, after = 0.0;             // the separations next to it, before it and after it on the way [m]
    double forceBefore = 0.0, forceAfter = 0.0;   // [N]
    double energyBefore = 0.0, energyAfter = 0.0; // of the contact, by who knows them [J]
};

/// Locates a jump between `from`, where the contact is now with the force `forceAtFrom` [N], and `to`, either way.
/// Bisection keeps the first half where that may have jumped, so that the first of two jumps is found, else the half
/// over which the force changes more; at least three times, until it is no longer than `resolution` [m]. The result is
/// a jump where the force still changes by more than `smallest` [N] and by more than half of its change over the
/// interval eight times as long (a smooth force: an eighth; next to a fold: a third). In the end the contact is in the
/// state `before`, which is remembered; force(after) steps over the jump.
ContactJump locateJump(const TracedContact& contact, double from, double forceAtFrom, double to, double resolution,
                       double smallest);

/// The same for the first of several jumps; the bisection alone finds the largest. The way to the jump that it finds is
/// walked again in sixteen steps. A step is searched if the contact may have jumped in it, or if the force changes by
/// more than 1.5 times the change over the step before. Needs the second slot.
ContactJump locateFirstJump(const TracedContact& contact, double from, double forceAtFrom, double to, double resolution,
                            double smallest);

} // namespace touchdown
