// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_jump.h"

#include <array>
#include <cassert>
#include <cmath>

namespace touchdown {

ContactJump locateJump(const TracedContact& contact, double from, double forceAtFrom, double to, double resolution,
                       double smallest)
{
    assert(resolution > 0.0);
    contact.remember();
    ContactJump jump{false, from, to, forceAtFrom, contact.force(to), 0.0, 0.0};
    const auto change = [&] { return std::abs(jump.forceAfter - jump.forceBefore); };
    constexpr int halvings = 3;
    std::array<double, halvings> earlier{}; // changes over the intervals twice, four times and eight times as long
    int steps = 0;
    while (std::abs(jump.after - jump.before) > resolution || steps < halvings) {
        const double middle = jump.before + 0.5 * (jump.after - jump.before);
        if (middle == jump.before || middle == jump.after) break; // as near as numbers can tell
        earlier = {change(), earlier[0], earlier[1]};
        contact.recall();
        const double force = contact.force(middle);
        const double first = std::abs(force - jump.forceBefore);
        const bool jumpsFirst = contact.jumped && first > smallest && contact.jumped();
        if (!jumpsFirst && std::abs(jump.forceAfter - force) > first) {
            jump.before = middle;
            jump.forceBefore = force;
            contact.remember();
        } else {
            jump.after = middle;
            jump.forceAfter = force;
        }
        ++steps;
    }
    // The force after it was found on a longer way: once more in one step from the state before it.
    contact.recall();
    jump.forceAfter = contact.force(jump.after);
    contact.recall();
    jump.found = change() > smallest && change() > 0.5 * earlier[halvings - 1];
    return jump;
}

ContactJump locateFirstJump(const TracedContact& contact, double from, double forceAtFrom, double to, double resolution,
                            double smallest)
{
    if (contact.mark) contact.mark();
    const ContactJump jump = locateJump(contact, from, forceAtFrom, to, resolution, smallest);
    if (!contact.mark) return jump;
    constexpr int pieces = 16;
    constexpr double sudden = 1.5;
    contact.back();
    double at = from, force = forceAtFrom, lastChange = 0.0;
    for (int k = 1; k <= pieces; ++k) {
        const double next = k == pieces ? jump.before : from + (jump.before - from) * k / pieces;
        contact.remember();
        double after = contact.force(next);
        const double change = std::abs(after - force);
        const bool jumps = contact.jumped && contact.jumped();
        if (change > smallest && next != at && (jumps || (k > 1 && change > sudden * lastChange))) {
            contact.recall();
            const ContactJump earlier = locateJump(contact, at, force, next, resolution, smallest);
            if (earlier.found) return earlier;
            after = contact.force(next);
        }
        lastChange = change;
        at = next;
        force = after;
    }
    contact.remember();
    return {jump.found, jump.before, jump.after, force, jump.forceAfter, 0.0, 0.0};
}

} // namespace touchdown
