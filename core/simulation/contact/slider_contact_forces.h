// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a contact does on a flying slider at one attitude.
#pragma once

#include <string>

#include "core/numerics/small_matrix.h"

namespace touchdown {

struct SliderContactForces {
    double contact = 0.0;      // >= 0, away from the disk [N]
    double adhesion = 0.0;     // <= 0 [N]
    double friction = 0.0;     // in the disk's direction [N]
    double pitchTorque = 0.0;  // of the three about the mass centre, nose up [N m]
    double rollTorque = 0.0;   // inner edge up [N m]
    double area = 0.0;         // real area of contact [m^2]; zero where the law knows none
    double peakPressure = 0.0; // of contact [Pa]
    double storedEnergy = 0.0; // elastic [J]
    int iterations = 0;        // of the solution
    std::string problem;       // a sentence, when it did not converge; "" when it did
    Vector3 load() const { return {contact + adhesion, pitchTorque, rollTorque}; }
};

} // namespace touchdown
