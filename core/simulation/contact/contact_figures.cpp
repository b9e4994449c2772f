// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_figures.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_law.h"

namespace touchdown {

void ContactFigures::add(const ContactForces& forces, bool away)
{
    largestContact_ = std::max(largestContact_, forces.contact);
    if (!closest_ || forces.separation < closest_->separation) closest_ = forces;
    if (away) addPull(forces.separation, forces.net());
}

void ContactFigures::addJump(const ContactJump& jump)
{
    jumps_.push_back(jump);
    // The released energy minus the work done between the two separations.
    lostInJumps_ +=
        jump.energyBefore - jump.energyAfter - 0.5 * (jump.forceBefore + jump.forceAfter) * (jump.after - jump.before);
    if (jump.after > jump.before) addPull(jump.before, jump.forceBefore);
}

void ContactFigures::addPull(double separation, double force)
{
    if (force >= strongestPull_.value_or(0.0)) return;
    strongestPull_ = force;
    strongestPullAt_ = separation;
}

std::vector<RunFigure> ContactFigures::figures(const std::optional<SurfaceStatistics>& surface,
                                               const std::optional<CharacteristicFit>& fit) const
{
    std::vector<RunFigure> list;
    const auto add = [&](const char* name, const char* unit, const char* displayUnit, const char* longName,
                         double value) {
        if (std::isfinite(value)) list.push_back({{name, unit, displayUnit, longName}, value});
    };
    add("largest_contact_force", "N", "mN", "Largest contact force", largestContact_);
    if (strongestPull_) {
        add("pull_off_force", "N", "mN", "Pull-off force: the strongest net pull on the way out", -*strongestPull_);
        add("pull_off_separation", "m", "nm", "Separation of the strongest net pull on the way out", *strongestPullAt_);
    }
    for (const bool away : {false, true})
        for (const ContactJump& jump : jumps_) {
            if ((jump.after > jump.before) != away) continue;
            if (away)
                add("release_separation", "m", "nm", "Separation of the first jump on the way out", jump.before);
            else
                add("snap_in_separation", "m", "nm", "Separation of the first jump on the way in", jump.before);
            break;
        }
    // An elastic contact that adheres loses energy in its jumps alone. Where the disk moves, that moves the surface,
    // too.
    const auto jumped = [&](bool away) {
        return std::ranges::any_of(jumps_, [&](const ContactJump& jump) { return (jump.after > jump.before) == away; });
    };
    const bool rests =
        case_.diskSurface.kind == DiskSurfaceKind::Flat || case_.diskSurface.motion == SurfaceMotion::Still;
    if (fit) {
        add("loop_work", "J", "pJ", "Work that the way in and out takes", fit->cycleWork);
        add("lost_in_jumps", "J", "pJ", "The part of it that is lost in jumps", fit->lostInJumps);
    } else if (rests && jumped(false) && jumped(true)) {
        add("loop_work", "J", "pJ", "Work that the way in and out takes: lost in its jumps", lostInJumps_);
    }
    if (closest_ && (contactLaw(case_).recordsArea))
        add("closest_contact_area", "m^2", "um^2", "Real area of contact at the closest approach", closest_->area);
    if (surface) {
        add("surface_rms", "m", "nm", "RMS height of the disk's surface, computed back", surface->rms);
        add("surface_skewness", "", "", "Skewness of its heights", surface->skewness);
        add("surface_kurtosis", "", "", "Kurtosis of its heights", surface->kurtosis);
        add("surface_correlation", "m", "um", "Correlation length of the disk's surface", surface->correlationLength);
    }
    return list;
}

} // namespace touchdown
