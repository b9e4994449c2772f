// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the film does to the slider. Forces are positive away from the disk, towards the trailing and the outer edge;
// torques are about the slider's centre, positive nose up and inner edge up.
#pragma once

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

struct FilmForces {
    double net = 0.0;                                    // of the pressure above ambient [N]
    double positive = 0.0, negative = 0.0;               // its parts above and below ambient; negative <= 0 [N]
    SurfacePoint centreOfPositive, centreOfNegative;     // [m]
    double pitchTorque = 0.0, rollTorque = 0.0;          // of the pressure [N m]
    double shearX = 0.0, shearY = 0.0;                   // Couette mu U/(h + 2 a lambda), Poiseuille -(h/2) dp/dx [N]
    double maximumPressure = 0.0, minimumPressure = 0.0; // absolute [Pa]
    SurfacePoint maximumAt, minimumAt;                   // [m]
    double massFlow = 0.0;                               // pressure times volume that enters by the outline [Pa m^3/s]
};

} // namespace touchdown
