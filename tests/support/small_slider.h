// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider of our own for tests of the flying attitude: 1 mm x 0.8 mm, two side rails and a rear pad on a shallow step.
#pragma once

#include "core/case/case.h"

namespace touchdown::test {

inline Rail rectangle(double x0, double y0, double x1, double y1, double recess)
{
    return {.kind = RailKind::Step,
            .points = {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}},
            .recess = {recess, 0, 0}};
}

inline Case smallSlider(int nodes = 65)
{
    Case c;
    c.model = ModelKind::Film;
    c.contact = noContact;
    c.degreesOfFreedom = 3;
    c.slider = {.mass = 0.9e-6,
                .pitchInertia = 8e-14,
                .rollInertia = 5e-14,
                .length = 1.0e-3,
                .width = 0.8e-3,
                .thickness = 0.23e-3};
    c.surface.baseRecess = 1.5e-6;
    c.surface.crown = 10e-9;
    c.surface.camber = 3e-9;
    c.surface.rails = {rectangle(0.02e-3, 0.05e-3, 0.25e-3, 0.75e-3, 150e-9), // leading step
                       rectangle(0.10e-3, 0.05e-3, 0.60e-3, 0.17e-3, 0.0),    // inner side rail
                       rectangle(0.10e-3, 0.63e-3, 0.60e-3, 0.75e-3, 0.0),    // outer side rail
                       rectangle(0.80e-3, 0.30e-3, 0.97e-3, 0.50e-3, 120e-9), // rear step
                       rectangle(0.88e-3, 0.33e-3, 0.97e-3, 0.47e-3, 0.0)};   // rear pad
    c.suspension.preload = 1.0e-3 * 9.80665;
    c.suspension.stiffness = 15.0;
    c.suspension.pitchStiffness = c.suspension.rollStiffness = 2e-5;
    c.suspension.offsetX = 0.02e-3;
    c.disk = {.speed = 754.0, .radius = 25e-3, .skew = 0.05, .field = VelocityField::Rotating};
    c.film.nodes = {nodes, nodes};
    c.film.tolerance = 1e-10;
    c.steady.loadTolerance = 1e-9;
    c.initial.nominalTrailingEdgeHeight = 20e-9;
    c.initial.pitch = 120e-6;
    return c;
}

} // namespace touchdown::test
