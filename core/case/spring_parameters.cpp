// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lumped air bearing of Ono & Yamane.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

std::vector<Parameter> springParameters()
{
    return {
        number("springs.front_stiffness", "front stiffness", "k_f0", newtonsPerMetre, notNegative(1e12),
               at(&Case::springs, &SpringsCase::frontStiffness), withSprings,
               "Stiffness of the front air bearing spring at its static spacing.", lostTable),
        number("springs.rear_stiffness", "rear stiffness", "k_r0", newtonsPerMetre, notNegative(1e12),
               at(&Case::springs, &SpringsCase::rearStiffness), withSprings,
               "Stiffness of the rear air bearing spring at its static spacing.", lostTable),
        number("springs.front_distance", "front distance", "d_f", millimetres, notNegative(1),
               at(&Case::springs, &SpringsCase::frontDistance), withSprings,
               "Distance from the mass centre forward to the front pressure centre.", lostTable),
        number("springs.rear_distance", "rear distance", "d_r", millimetres, notNegative(1),
               at(&Case::springs, &SpringsCase::rearDistance), withSprings,
               "Distance from the mass centre back to the rear pressure centre.", lostTable),
        number("springs.front_damping_ratio", "front damping ratio", "xi_f", noUnit, notNegative(10),
               at(&Case::springs, &SpringsCase::frontDampingRatio), withSprings,
               "Damping ratio of the front dashpot, c_f = 2 xi_f sqrt(M k_f0).", "paper, text on Fig. 14"),
        number("springs.rear_damping_ratio", "rear damping ratio", "xi_r", noUnit, notNegative(10),
               at(&Case::springs, &SpringsCase::rearDampingRatio), withSprings,
               "Damping ratio of the rear dashpot, c_r = 2 xi_r sqrt(M k_r0).", "paper, text on Fig. 14"),
        number("springs.cutoff", "cutoff spacing", "d_1", nanometres, positive(1),
               at(&Case::springs, &SpringsCase::cutoff), withSprings,
               "Spacing below which an air bearing spring exerts no force; its dashpot still acts.",
               "paper, equation (1): 0.3 nm, the no-fly zone, or d_s"),
        number("springs.flying_height", "static flying height", "FH", nanometres, within(1),
               at(&Case::springs, &SpringsCase::flyingHeight), withSprings,
               "Flying height of the static state, at the contact pad, without contact.",
               "paper, text on Fig. 10: a 7 nm slider"),
        number("springs.pitch", "static pitch", "theta_0", microradians, within(1),
               at(&Case::springs, &SpringsCase::pitch), withSprings,
               "Pitch angle of the static state, leading edge up.", lostTable),
        choice("springs.potential", "potential below the cutoff", {"held", "as-printed"},
               at(&Case::springs, &SpringsCase::potential), withSprings,
               "Energy of a spring below d_1: held = its value at d_1, as-printed = equation (5) continues and can "
               "become negative.",
               "paper, equation (5)"),
    };
}

} // namespace touchdown
