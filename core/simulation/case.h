// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that a run needs, as plain values in SI. Key names, units, ranges and help text of the
// members are described once, in core/simulation/fields.h.
#pragma once

#include <cstdint>
#include <string>

#include "core/numerics/spectrum.h"
#include "core/physics/air_spring.h"
#include "core/physics/ono_yamane.h"

namespace touchdown {

enum class ModelKind : std::uint8_t { Springs };
enum class ContactKind : std::uint8_t { None, OnoYamane };
enum class IntegratorKind : std::uint8_t { Rk4, Rk4Events, Newmark, Dopri5, Cvode };

/// What a sample case says about itself.
struct About {
    std::string paper;   // what the paper saw
    std::string watch;   // what to watch
    std::string assumed; // what is a stand-in, because the paper's tables are lost
};

struct SliderCase {
    double mass = 1.6e-6;           // M [kg]
    double pitchInertia = 2.2e-13;  // J [kg m^2]
    double thickness = 0.3e-3;      // b [m]
};

/// The lumped air bearing of Ono & Yamane: two springs, two dashpots.
struct SpringsCase {
    double frontStiffness = 5.0e5;      // k_f0 [N/m]
    double rearStiffness = 1.35e6;      // k_r0 [N/m]
    double frontDistance = 0.500e-3;    // d_f [m], mass centre to front pressure centre
    double rearDistance = 0.575e-3;     // d_r [m], mass centre to rear pressure centre
    double frontDampingRatio = 0.01;    // xi_f [-]
    double rearDampingRatio = 0.01;     // xi_r [-]
    double cutoff = 0.3e-9;             // d_1 [m]
    double flyingHeight = 7e-9;         // FH of the static state, at the contact pad [m]
    double pitch = 90e-6;               // theta_0 of the static state [rad]
    PotentialBelowCutoff potential = PotentialBelowCutoff::Held;
};

struct SuspensionCase {
    double stiffness = 6.0;             // k [N/m]
    double pitchStiffness = 1.5e-4;     // k_theta [N m/rad]
    double dampingRatio = 0.01;         // xi [-]
    double pitchDampingRatio = 0.01;    // xi_theta [-]
};

struct InitialCase {
    double flyingHeight = 250e-9; // [m]
    double pitch = 0.0;           // [rad]
    double verticalVelocity = 0.0; // of the mass centre [m/s]
    double pitchVelocity = 0.0;    // [rad/s]
    ContactBranch branch = ContactBranch::TouchDown; // used between d_s and d_e
};

struct RunCase {
    double duration = 2e-3;        // [s]
    IntegratorKind integrator = IntegratorKind::Dopri5;
    double step = 10e-9;           // fixed-step methods [s]
    double tolerance = 1e-8;       // adaptive methods, local error against the static state's scale [-]
    double newmarkBeta = 0.25;     // [-]
    double newmarkGamma = 0.5;     // [-]
    double sampleInterval = 0.1e-6; // [s]
    bool stepCheck = true;         // fixed-step methods: compare with half the step
};

/// How power spectra are estimated (Welch 1967).
struct SpectrumCase {
    SpectrumWindow window = SpectrumWindow::Hann;
    SpectrumScaling scaling = SpectrumScaling::Density;
    double segment = 0.2e-3; // length of one segment [s]
    double overlap = 0.5;    // shared by neighbouring segments [-]
    double start = 0.0;      // what comes before is left out [s]
};

struct Case {
    std::string title = "Untitled";
    About about;
    ModelKind model = ModelKind::Springs;
    ContactKind contact = ContactKind::OnoYamane;
    int degreesOfFreedom = 2;
    SliderCase slider;
    SpringsCase springs;
    SuspensionCase suspension;
    OnoYamane onoYamane;
    InitialCase initial;
    RunCase run;
    SpectrumCase spectrum;
};

} // namespace touchdown
