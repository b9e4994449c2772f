// SPDX-License-Identifier: GPL-3.0-or-later
//
// The suspension: about the static state of the springs, or with the load that the film carries.
#include "core/case/parameter_builders.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr const char* typical = "a typical suspension of a small slider";
constexpr const char* centred = "ours: over the slider's centre";

bool withTorques(const Case& c) { return withFilm(c) && !c.suspension.holdsAttitude; }
bool withStaticAttitude(const Case& c) { return withFilm(c) && c.suspension.holdsAttitude; }
bool withRollTorque(const Case& c) { return withRoll(c) && withTorques(c); }
bool withStaticRoll(const Case& c) { return withRoll(c) && withStaticAttitude(c); }

} // namespace

std::vector<Parameter> suspensionParameters()
{
    return {
        number("suspension.stiffness", "suspension stiffness", "k", newtonsPerMetre, notNegative(1e12),
               at(&Case::suspension, &SuspensionCase::stiffness), withBearing, "Vertical stiffness of the suspension.",
               lostTable),
        number("suspension.pitch_stiffness", "suspension pitch stiffness", "k_theta", {"N m/rad", "N m/rad"},
               notNegative(1e3), at(&Case::suspension, &SuspensionCase::pitchStiffness), withBearing,
               "Angular stiffness of the suspension in pitch.", lostTable),
        number("suspension.roll_stiffness", "suspension roll stiffness", "k_phi", {"N m/rad", "N m/rad"},
               notNegative(1e3), at(&Case::suspension, &SuspensionCase::rollStiffness), withRoll,
               "Angular stiffness of the suspension in roll.", typical),
        number("suspension.damping_ratio", "suspension damping ratio", "xi", noUnit, notNegative(10),
               at(&Case::suspension, &SuspensionCase::dampingRatio), withSprings,
               "Damping ratio of the suspension, c = 2 xi sqrt(M k).", lostTable),
        number("suspension.pitch_damping_ratio", "suspension pitch damping ratio", "xi_theta", noUnit, notNegative(10),
               at(&Case::suspension, &SuspensionCase::pitchDampingRatio), withSprings,
               "Damping ratio of the suspension in pitch, c_theta = 2 xi_theta sqrt(J k_theta).", lostTable),
        number("suspension.damping", "suspension damping", "c_z", {"N s/m", "N s/m"}, notNegative(1e12),
               at(&Case::suspension, &SuspensionCase::damping), withFilm, "Vertical damping of the suspension.",
               typical),
        number("suspension.pitch_damping", "suspension pitch damping", "c_theta", {"N m s/rad", "N m s/rad"},
               notNegative(1e3), at(&Case::suspension, &SuspensionCase::pitchDamping), withFilm,
               "Angular damping of the suspension in pitch.", typical),
        number("suspension.roll_damping", "suspension roll damping", "c_phi", {"N m s/rad", "N m s/rad"},
               notNegative(1e3), at(&Case::suspension, &SuspensionCase::rollDamping), withRoll,
               "Angular damping of the suspension in roll.", typical),
        number("suspension.preload", "preload", "f_0", {"N", "gf"}, notNegative(1000),
               at(&Case::suspension, &SuspensionCase::preload), withFilm,
               "Force with which the suspension presses the slider onto the disk.",
               "paper, section 2: a pico slider with 1.5 gf"),
        number("suspension.offset_x", "preload offset along the slider", "", millimetres, within(0.1),
               at(&Case::suspension, &SuspensionCase::offsetX), withFilm,
               "Point where the preload acts: its distance from the slider's centre towards the trailing edge.",
               centred),
        number("suspension.offset_y", "preload offset across the slider", "", millimetres, within(0.1),
               at(&Case::suspension, &SuspensionCase::offsetY), withFilm,
               "Point where the preload acts: its distance from the slider's centre towards the outer edge.", centred),
        number("suspension.pitch_torque", "static pitch torque", "", micronewtonMetres, within(1),
               at(&Case::suspension, &SuspensionCase::pitchTorque), withTorques,
               "Static torque of the suspension on the slider, leading edge up.", "ours: none"),
        number("suspension.roll_torque", "static roll torque", "", micronewtonMetres, within(1),
               at(&Case::suspension, &SuspensionCase::rollTorque), withRollTorque,
               "Static torque of the suspension on the slider, inner edge up.", "ours: none"),
        boolean("suspension.holds_attitude", "suspension holds an attitude",
                at(&Case::suspension, &SuspensionCase::holdsAttitude), withFilm,
                "false = the static torques are given; true = they follow from the angular stiffnesses and the static "
                "attitude of the unloaded suspension.",
                "ours: the torques are given"),
        number("suspension.static_pitch", "static pitch", "", milliradians, within(1),
               at(&Case::suspension, &SuspensionCase::staticPitch), withStaticAttitude,
               "Pitch of the unloaded suspension, leading edge up.", "ours: none"),
        number("suspension.static_roll", "static roll", "", milliradians, within(1),
               at(&Case::suspension, &SuspensionCase::staticRoll), withStaticRoll,
               "Roll of the unloaded suspension, inner edge up.", "ours: none"),
    };
}

} // namespace touchdown
