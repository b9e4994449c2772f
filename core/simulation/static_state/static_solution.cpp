// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/static_solution.h"

#include "core/case/contact_law.h"
#include "core/physics/slider/surface_edit.h"
#include "core/simulation/static_state/contact_rest.h"

namespace touchdown {

bool sameFilm(const Case& a, Case b)
{
    b.surface.distances = a.surface.distances;
    b.surface.symmetries = a.surface.symmetries;
    if (b.surface.walls != a.surface.walls && withoutUnusedWalls(a.surface) == withoutUnusedWalls(b.surface))
        b.surface = a.surface;
    b.title = a.title;
    b.about = a.about;
    b.folder = a.folder;
    b.run = a.run;
    b.film.motion = a.film.motion;
    b.film.linearLimit = a.film.linearLimit;
    b.spectrum = a.spectrum;
    return a == b;
}

bool sameFilmApart(const Case& a, const Case& b)
{
    if (contactLaw(a).recordsSurfaces || contactLaw(b).recordsSurfaces) return false; // it deforms the disk
    Case same = withContactOf(b, a);
    same.suspension = a.suspension;
    same.slider.mass = a.slider.mass;
    same.slider.pitchInertia = a.slider.pitchInertia;
    same.slider.rollInertia = a.slider.rollInertia;
    same.diskSurface = a.diskSurface;
    same.initial = a.initial;
    same.initial.roll = b.initial.roll; // with two degrees of freedom it is held there
    same.initial.branch = b.initial.branch;
    return sameFilm(a, same);
}

Case withRunOf(Case c, const Case& run)
{
    if (!seesStillDisk(c) && !seesStillDisk(run)) c.diskSurface = run.diskSurface;
    c.run = run.run;
    c.spectrum = run.spectrum;
    const InitialCase attitude = c.initial;
    c.initial = run.initial;
    c.initial.nominalTrailingEdgeHeight = attitude.nominalTrailingEdgeHeight;
    c.initial.pitch = attitude.pitch;
    c.initial.roll = attitude.roll;
    if (c.contact != noContact) c.initial.branch = attitude.branch; // it chooses among several states
    return c;
}

bool hasStaticState(const Case& c, const Case& solved, const Attitude& found)
{
    Case same = withRunOf(solved, c);
    const InitialCase& start = c.initial;
    if (start.nominalTrailingEdgeHeight == found.height && start.pitch == found.pitch && start.roll == found.roll) {
        const ContactBranch branch = same.initial.branch;
        same.initial = start;
        same.initial.branch = branch;
    }
    return sameFilm(c, same);
}

bool isRestOf(const Case& c, const Case& solved, const SteadyResult& state)
{
    if (state.pressure.empty() || state.status == SteadyStatus::Cancelled || solved.steady.fixedAttitude) return false;
    const Case sought = attitudeCase(c), found = attitudeCase(solved);
    return state.status == SteadyStatus::Converged ? hasStaticState(sought, found, state.attitude)
                                                   : sameFilm(sought, withRunOf(found, sought));
}

} // namespace touchdown
