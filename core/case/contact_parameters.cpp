// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters of the contact characteristic of Ono & Yamane.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

/// The take-off shapes and what each does to the energy.
std::string shapeHelp()
{
    std::string works; // "constant: W = f_m (d_e - d_s) - ...; linear: ..."
    for (std::size_t i = 0; i < takeOffShapeNames.size(); ++i)
        works += (i > 0 ? "; " : "") + std::string(takeOffShapeNames[i]) + ": W = " + std::string(cycleWorkFormulas[i]);
    return "Forces between d_s and d_e on the take-off branch: constant = F_m stays -f_m, F_cr falls along k_c; linear "
           "= "
           "F_m falls to zero at d_e, F_cr along k_c; both-linear = both fall linearly to zero at d_e. A touch-down "
           "and "
           "take-off takes the energy W out of the slider: " +
           works +
           ". Where d_e < d_s + f_c0/k_c the first two are too simple, and the program integrates the forces. W < 0: "
           "each touch-down and take-off gives energy to the slider, as no real contact does, and it can bounce for "
           "ever.";
}

} // namespace

std::vector<Parameter> contactParameters()
{
    const std::string help = shapeHelp();
    return {
        number("ono_yamane.meniscus_force", "maximum meniscus force", "f_m", millinewtons, notNegative(1e6),
               at(&Case::onoYamane, &OnoYamane::meniscusForce), withOnoYamane,
               "Largest adhesion force of the menisci between pad and disk.", "assumed: Table II of the paper is lost"),
        number("ono_yamane.contact_stiffness", "contact stiffness", "k_c", newtonsPerMetre, notNegative(1e12),
               at(&Case::onoYamane, &OnoYamane::contactStiffness), withOnoYamane,
               "Bulk contact stiffness below the touch-down height.", "paper, section 4: 5.0e6 N/m"),
        number("ono_yamane.initial_contact_force", "initial contact force", "f_c0", millinewtons, notNegative(1e6),
               at(&Case::onoYamane, &OnoYamane::initialContactForce), withOnoYamane,
               "Real contact force at the touch-down height.", "paper, section 4: 5.0 mN"),
        number("ono_yamane.touch_down", "touch-down height", "d_s", nanometres, within(1),
               at(&Case::onoYamane, &OnoYamane::touchDown), withOnoYamane,
               "Separation at which contact begins on the way down.", "paper, section 4: 3.0 nm"),
        number("ono_yamane.take_off", "take-off height", "d_e", nanometres, within(1),
               at(&Case::onoYamane, &OnoYamane::takeOff), withOnoYamane,
               "Separation at which the menisci break on the way up; at least the touch-down height.",
               "assumed: Tables I and II of the paper are lost"),
        number("ono_yamane.friction", "friction coefficient", "mu", noUnit, notNegative(100),
               at(&Case::onoYamane, &OnoYamane::friction), withOnoYamane,
               "Coulomb friction coefficient on the real contact force.", "assumed: Table II of the paper is lost"),
        // Without contact too: flying heights are measured at the pad.
        number("ono_yamane.pad_distance", "pad distance", "d_h", millimetres, within(1),
               at(&Case::springs, &SpringsCase::padDistance), withSprings,
               "Distance from the mass centre back to the contact pad, where the flying height is measured.",
               "assumed: Table II of the paper is lost; the paper's d_h is a signed coordinate"),
        choice("ono_yamane.take_off_shape", "take-off shape", {takeOffShapeNames.begin(), takeOffShapeNames.end()},
               at(&Case::onoYamane, &OnoYamane::takeOffShape), withOnoYamane, help.c_str(),
               "assumed: a reading of the paper's Fig. 3, for which it gives no equation"),
    };
}

} // namespace touchdown
