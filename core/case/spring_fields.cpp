// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lumped air bearing of Ono & Yamane.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr const char* lostTable =
    "assumed: Table II of the paper is lost; this default meets the steady states that its text states";

} // namespace

std::vector<Field> springFields()
{
    return {
        number({.key = "springs.front_stiffness",
                .label = "front stiffness",
                .symbol = "k_f0",
                .unit = "N/m",
                .displayUnit = "N/m",
                .minimum = 0,
                .maximum = 1e12,
                .help = "Stiffness of the front air bearing spring at its static spacing.",
                .source = lostTable},
               at(&Case::springs, &SpringsCase::frontStiffness), withSprings),
        number({.key = "springs.rear_stiffness",
                .label = "rear stiffness",
                .symbol = "k_r0",
                .unit = "N/m",
                .displayUnit = "N/m",
                .minimum = 0,
                .maximum = 1e12,
                .help = "Stiffness of the rear air bearing spring at its static spacing.",
                .source = lostTable},
               at(&Case::springs, &SpringsCase::rearStiffness), withSprings),
        number({.key = "springs.front_distance",
                .label = "front distance",
                .symbol = "d_f",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 1,
                .help = "Distance from the mass centre forward to the front pressure centre.",
                .source = lostTable},
               at(&Case::springs, &SpringsCase::frontDistance), withSprings),
        number({.key = "springs.rear_distance",
                .label = "rear distance",
                .symbol = "d_r",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = 0,
                .maximum = 1,
                .help = "Distance from the mass centre back to the rear pressure centre.",
                .source = lostTable},
               at(&Case::springs, &SpringsCase::rearDistance), withSprings),
        number({.key = "springs.front_damping_ratio",
                .label = "front damping ratio",
                .symbol = "xi_f",
                .minimum = 0,
                .maximum = 10,
                .help = "Damping ratio of the front dashpot, c_f = 2 xi_f sqrt(M k_f0).",
                .source = "paper, text on Fig. 14"},
               at(&Case::springs, &SpringsCase::frontDampingRatio), withSprings),
        number({.key = "springs.rear_damping_ratio",
                .label = "rear damping ratio",
                .symbol = "xi_r",
                .minimum = 0,
                .maximum = 10,
                .help = "Damping ratio of the rear dashpot, c_r = 2 xi_r sqrt(M k_r0).",
                .source = "paper, text on Fig. 14"},
               at(&Case::springs, &SpringsCase::rearDampingRatio), withSprings),
        number({.key = "springs.cutoff",
                .label = "cutoff spacing",
                .symbol = "d_1",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Spacing below which an air bearing spring carries nothing.",
                .source = "paper, equation (1): 0.3 nm, the no-fly zone, or d_s"},
               at(&Case::springs, &SpringsCase::cutoff), withSprings),
        number({.key = "springs.flying_height",
                .label = "static flying height",
                .symbol = "FH",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1,
                .maximum = 1,
                .help = "Flying height of the static state, at the contact pad, without contact.",
                .source = "paper, text on Fig. 10: a 7 nm slider"},
               at(&Case::springs, &SpringsCase::flyingHeight), withSprings),
        number({.key = "springs.pitch",
                .label = "static pitch",
                .symbol = "theta_0",
                .unit = "rad",
                .displayUnit = "urad",
                .minimum = -1,
                .maximum = 1,
                .help = "Pitch angle of the static state, leading edge up.",
                .source = lostTable},
               at(&Case::springs, &SpringsCase::pitch), withSprings),
        choice(
            {.key = "springs.potential",
             .label = "potential below the cutoff",
             .choices = {"held", "as-printed"},
             .help =
                 "Energy of a spring below d_1: held at its value at d_1, or as-printed = equation (5) goes on and can "
                 "become negative.",
             .source = "paper, equation (5)"},
            at(&Case::springs, &SpringsCase::potential), withSprings),
    };
}

} // namespace touchdown
