// SPDX-License-Identifier: GPL-3.0-or-later
//
// A static state whose numbers are made up and all different, for what tells and stores them.
#pragma once

#include "core/case/parameters.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown::test {

inline Case sampleFilmCase()
{
    Case c = defaultsOf(ModelKind::Film);
    c.title = "A plane";
    c.surface.pointsOfInterest = {{1.2e-3, 0.5e-3}, {0.1e-3, 0.2e-3}};
    return c;
}

/// Of a grid of 3 x 2 cells; cell (i, j) has pressure 1e5 + i + 10 j Pa.
inline SteadyResult sampleSteady()
{
    SteadyResult r;
    r.status = SteadyStatus::Converged;
    r.iterations = 7;
    r.solves = 21;
    r.wallSeconds = 0.25;
    r.residual = 1e-9;
    r.loadError = 2e-8;
    r.attitude = {12e-9, 150e-6, -3e-6};
    r.minimumSpacing = 9.5e-9;
    r.minimumAt = {1.24e-3, 0.9e-3};
    FilmForces& f = r.forces;
    f.net = 14.7e-3;
    f.positive = 20e-3;
    f.negative = -5.3e-3;
    f.centreOfPositive = {0.9e-3, 0.51e-3};
    f.centreOfNegative = {0.6e-3, 0.52e-3};
    f.pitchTorque = 1e-7;
    f.rollTorque = 2e-8;
    f.shearX = 3e-4;
    f.shearY = -4e-5;
    f.maximumPressure = 9e5;
    f.minimumPressure = 4e4;
    f.maximumAt = {1.2e-3, 0.5e-3};
    f.minimumAt = {0.6e-3, 0.4e-3};
    f.massFlow = 1.5e-9;
    r.shearPitchTorque = -5e-8;
    r.shearRollTorque = 6e-9;
    r.stiffness = Matrix3{{1e5, 2.0, 3.0}, {4.0, 5e-3, 6e-4}, {7.0, 8e-4, 9e-3}};
    r.sensitivities = {{"abs.crown", "m", 0.1, 2e3, 3.0, 0.4}};
    r.discretisationError = {1e-11, 1e-8, 2e-8, 1e-5};
    r.unresolvedRidges = 7;
    r.contact = {.state = "held by menisci",
                 .contact = 1e-3,
                 .adhesion = -2e-3,
                 .friction = 3e-4,
                 .pitchTorque = 4e-8,
                 .rollTorque = 5e-9,
                 .area = 6e-12,
                 .peakPressure = 7e8,
                 .region = ContactRegion::Bridged,
                 .branch = ContactBranch::TakeOff};
    r.contactStiffness = Matrix3{{2e5, 1.0, 4.0}, {3.0, 6e-3, 5e-4}, {8.0, 7e-4, 2e-3}};
    r.suspensionRest = {13e-9, 151e-6, -2e-6};
    r.contactStates = {{{14e-9, 149e-6, 1e-6}, 10e-9, {.state = "flying", .diverges = true}}};
    r.interestSpacing = {11e-9, 180e-9};
    r.grid = {{0.0, 0.5e-3, 1.0e-3, 1.25e-3}, {0.0, 0.4e-3, 1.0e-3}};
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i) {
            r.pressure.push_back(1e5 + i + 10 * j);
            r.gap.push_back(1e-8 * (1 + i + 10 * j));
            r.recess.push_back(1e-9 * (1 + i + 10 * j));
        }
    return r;
}

} // namespace touchdown::test
