// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters of the contact characteristic of Ono & Yamane.
#include "core/case/field_builders.h"

namespace touchdown {

using namespace field_builders;

std::vector<Field> contactFields()
{
    return {
        number({.key = "ono_yamane.meniscus_force",
                .label = "maximum meniscus force",
                .symbol = "f_m",
                .unit = "N",
                .displayUnit = "mN",
                .minimum = 0,
                .maximum = 1e6,
                .help = "Largest adhesion force of the menisci between pad and disk.",
                .source = "assumed: Table II of the paper is lost"},
               at(&Case::onoYamane, &OnoYamane::meniscusForce), withOnoYamane),
        number({.key = "ono_yamane.contact_stiffness",
                .label = "contact stiffness",
                .symbol = "k_c",
                .unit = "N/m",
                .displayUnit = "N/m",
                .minimum = 0,
                .maximum = 1e12,
                .help = "Bulk contact stiffness below the touch-down height.",
                .source = "paper, section 4: 5.0e6 N/m"},
               at(&Case::onoYamane, &OnoYamane::contactStiffness), withOnoYamane),
        number({.key = "ono_yamane.initial_contact_force",
                .label = "initial contact force",
                .symbol = "f_c0",
                .unit = "N",
                .displayUnit = "mN",
                .minimum = 0,
                .maximum = 1e6,
                .help = "Real contact force at the touch-down height.",
                .source = "paper, section 4: 5.0 mN"},
               at(&Case::onoYamane, &OnoYamane::initialContactForce), withOnoYamane),
        number({.key = "ono_yamane.touch_down",
                .label = "touch-down height",
                .symbol = "d_s",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1,
                .maximum = 1,
                .help = "Separation at which contact begins on the way down.",
                .source = "paper, section 4: 3.0 nm"},
               at(&Case::onoYamane, &OnoYamane::touchDown), withOnoYamane),
        number({.key = "ono_yamane.take_off",
                .label = "take-off height",
                .symbol = "d_e",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = -1,
                .maximum = 1,
                .help = "Separation at which the menisci break on the way up; at least the touch-down height.",
                .source = "assumed: Tables I and II of the paper are lost"},
               at(&Case::onoYamane, &OnoYamane::takeOff), withOnoYamane),
        number({.key = "ono_yamane.friction",
                .label = "friction coefficient",
                .symbol = "mu",
                .minimum = 0,
                .maximum = 100,
                .help = "Coulomb friction coefficient on the real contact force.",
                .source = "assumed: Table II of the paper is lost"},
               at(&Case::onoYamane, &OnoYamane::friction), withOnoYamane),
        // Without contact too: flying heights are measured at the pad.
        number({.key = "ono_yamane.pad_distance",
                .label = "pad distance",
                .symbol = "d_h",
                .unit = "m",
                .displayUnit = "mm",
                .minimum = -1,
                .maximum = 1,
                .help = "Distance from the mass centre back to the contact pad, where the flying height is measured.",
                .source = "assumed: Table II of the paper is lost; the paper's d_h is a signed coordinate"},
               at(&Case::onoYamane, &OnoYamane::padDistance), withSprings),
        choice(
            {.key = "ono_yamane.take_off_shape",
             .label = "take-off shape",
             .choices = {"constant", "linear"},
             .help = "Adhesion between d_s and d_e on the take-off branch: constant at f_m, or linear to zero at d_e.",
             .source = "assumed: a reading of the paper's Fig. 3, for which it gives no equation"},
            at(&Case::onoYamane, &OnoYamane::takeOffShape), withOnoYamane),
    };
}

} // namespace touchdown
