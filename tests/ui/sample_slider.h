// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider of our own for the tests of the window: two rails and a rear pad on a step, with walls, and a result whose
// fields are formulas.
#pragma once

#include <cmath>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

inline AirBearingSurface sampleSurface()
{
    const auto box = [](double x0, double x1, double y0, double y1, double recess, int wall) {
        return Rail{
            RailKind::Step, {{x0, y0, wall}, {x1, y0, wall}, {x1, y1, wall}, {x0, y1, wall}}, {recess, 0.0, 0.0}};
    };
    AirBearingSurface surface;
    surface.rails = {
        box(0.05e-3, 0.45e-3, 0.06e-3, 0.64e-3, 150e-9, 1), // a shelf across the front
        box(0.15e-3, 0.40e-3, 0.10e-3, 0.60e-3, 0.0, 2),    // the front pad on it
        box(0.55e-3, 0.84e-3, 0.22e-3, 0.48e-3, 150e-9, 1), // a shelf at the rear
        {RailKind::Step,
         {{0.74e-3, 0.28e-3, 2},
          {0.84e-3, 0.30e-3, 2},
          {0.84e-3, 0.40e-3, 2},
          {0.74e-3, 0.42e-3, 2},
          {0.70e-3, 0.35e-3, 2}},
         {}},
    };
    surface.walls = {{{-5e-6, 0.0, 20e-6}, {150e-9, 300e-9, 1.5e-6}}, {{-2e-6, 0.0, 10e-6}, {0.0, 20e-9, 150e-9}}};
    surface.baseRecess = 1.5e-6;
    surface.crown = 15e-9;
    surface.pointsOfInterest = {{0.84e-3, 0.35e-3}, {0.84e-3, 0.22e-3}, {0.84e-3, 0.48e-3}};
    return surface;
}

inline Case sampleFilmCase()
{
    Case c;
    c.title = "A slider of our own";
    c.model = ModelKind::Film;
    c.contact = noContact;
    c.slider.length = 0.85e-3;
    c.slider.width = 0.70e-3;
    c.surface = sampleSurface();
    c.disk.skew = 8.0 * 3.14159265358979323846 / 180.0;
    c.initial.nominalTrailingEdgeHeight = 12e-9;
    return c;
}

/// Cell borders that crowd towards the trailing edge: x = L (1 - (1 - s)^2), y even.
inline CellGrid sampleGrid(const Case& c, int nx, int ny)
{
    CellGrid grid;
    for (int i = 0; i <= nx; ++i) {
        const double s = static_cast<double>(i) / nx;
        grid.x.push_back(c.slider.length * (1.0 - (1.0 - s) * (1.0 - s)));
    }
    for (int j = 0; j <= ny; ++j) grid.y.push_back(c.slider.width * j / ny);
    return grid;
}

/// Attitude 10 nm, 100 urad, 0; gap and recess of the case; a pressure of two hills and a hollow.
inline SteadyResult sampleResult(const Case& c, int nx = 48, int ny = 40)
{
    SteadyResult result;
    result.status = SteadyStatus::Converged;
    result.iterations = 7;
    result.wallSeconds = 0.25;
    result.residual = 3e-9;
    result.loadError = 4e-8;
    result.attitude = {10e-9, 100e-6, -1.5e-6};
    result.grid = sampleGrid(c, nx, ny);
    result.minimumSpacing = 1.0;
    const double p0 = c.air.given.pressure;
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const double x = result.grid.centreX(i);
            const double y = result.grid.centreY(j);
            const double recess =
                x > 0.55e-3 && std::abs(y - 0.35e-3) < 0.13e-3 ? (x > 0.72e-3 ? 0.0 : 150e-9) : 1.5e-6;
            const double gap = result.attitude.height + result.attitude.pitch * (c.slider.length - x) + recess;
            const auto hill = [&](double x0, double width) {
                return std::exp(-(std::pow((x - x0) / width, 2) + std::pow((y - 0.35e-3) / 0.12e-3, 2)));
            };
            result.recess.push_back(recess);
            result.gap.push_back(gap);
            result.pressure.push_back(p0 + 9e5 * hill(0.80e-3, 0.05e-3) + 3e5 * hill(0.30e-3, 0.10e-3) -
                                      8e4 * hill(0.5e-3, 0.08e-3));
            if (gap < result.minimumSpacing) {
                result.minimumSpacing = gap;
                result.minimumAt = {x, y};
            }
        }
    }
    result.forces.net = 14.7e-3;
    result.forces.positive = 18.2e-3;
    result.forces.negative = -3.5e-3;
    result.forces.centreOfPositive = {0.55e-3, 0.35e-3};
    result.forces.centreOfNegative = {0.50e-3, 0.35e-3};
    result.forces.pitchTorque = -1.2e-6;
    result.forces.shearX = 2.1e-3;
    result.forces.maximumPressure = p0 + 9e5;
    result.forces.minimumPressure = p0 - 7.5e4;
    result.forces.maximumAt = {0.80e-3, 0.35e-3};
    result.forces.minimumAt = {0.50e-3, 0.35e-3};
    result.stiffness = Matrix3{{2.5e6, 1200.0, 3.0}, {-300.0, 0.5, 1e-3}, {2.0, 1e-3, 0.08}};
    result.discretisationError = {0.02e-9, 0.3e-6, 0.01e-6, 5e-5};
    result.interestSpacing = {10.0e-9, 12.5e-9, 12.4e-9};
    return result;
}

} // namespace touchdown
