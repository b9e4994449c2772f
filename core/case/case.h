// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that a run needs, as plain values in SI. Key names, units, ranges and help text of the
// members are described once, in core/case/parameters.h.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/numerics/convection.h"
#include "core/numerics/spectrum.h"
#include "core/physics/contact/adhesion.h"
#include "core/physics/contact/contact_bodies.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/physics/disk/disk_surface.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/film/air.h"
#include "core/physics/film/air_spring.h"
#include "core/physics/film/slip.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// Contact: a pad alone, moved towards the disk and away from it again.
enum class ModelKind : std::uint8_t { Springs, Film, Contact };
enum class PadShape : std::uint8_t { Flat, Sphere, Slider };
enum class AirSource : std::uint8_t { Given, Atmosphere, EstablishedStandard };
enum class FilmSolver : std::uint8_t { Newton, LineMultigrid };
enum class GridKind : std::uint8_t { Uniform, Graded, Adapted };
enum class FilmCoupling : std::uint8_t { Monolithic, Staggered };
enum class FilmMotion : std::uint8_t { Full, Linear };
enum class StepControl : std::uint8_t { Adaptive, Fixed };
enum class InitialState : std::uint8_t { Given, Static };

// Sets that grow. Only files that name one of their members include core/case/contact_kind.h, integrator_kind.h, so
// that a new law of contact or a new integrator does not compile the whole program.
enum class ContactKind : std::uint8_t;
extern const ContactKind noContact, usualContact; // none, Ono and Yamane's
enum class IntegratorKind : std::uint8_t;
extern const IntegratorKind usualIntegrator; // Dormand-Prince

/// What a sample case says about itself.
struct About {
    std::string paper;   // what the paper saw
    std::string watch;   // what to watch
    std::string assumed; // what is a stand-in, because the paper's tables are lost
    bool operator==(const About&) const = default;
};

struct SliderCase {
    double mass = 1.6e-6;          // M [kg]
    double pitchInertia = 2.2e-13; // J [kg m^2]
    double rollInertia = 1.45e-13; // [kg m^2]
    double length = 1.25e-3;       // L [m], along x
    double width = 1.00e-3;        // W [m], along y
    double thickness = 0.3e-3;     // b [m]
    bool operator==(const SliderCase&) const = default;
};

/// The lumped air bearing of Ono & Yamane: two springs, two dashpots.
struct SpringsCase {
    double frontStiffness = 1.93e5;  // k_f0 [N/m]
    double rearStiffness = 1.48e6;   // k_r0 [N/m]
    double frontDistance = 0.550e-3; // d_f [m], mass centre to front pressure centre
    double rearDistance = 0.545e-3;  // d_r [m], mass centre to rear pressure centre
    double padDistance = 0.575e-3;   // d_h [m], mass centre to contact pad, positive towards the trailing edge
    double frontDampingRatio = 0.01; // xi_f [-]
    double rearDampingRatio = 0.01;  // xi_r [-]
    double cutoff = 0.3e-9;          // d_1 [m]
    double flyingHeight = 7e-9;      // FH of the static state, at the contact pad [m]
    double pitch = 90.6e-6;          // theta_0 of the static state [rad]
    PotentialBelowCutoff potential = PotentialBelowCutoff::Held;
    bool operator==(const SpringsCase&) const = default;
};

struct SuspensionCase {
    double stiffness = 6.0;            // k [N/m]
    double pitchStiffness = 1.5e-4;    // k_theta [N m/rad]
    double rollStiffness = 1.745e-5;   // k_phi [N m/rad]
    double dampingRatio = 0.01;        // springs: xi [-]
    double pitchDampingRatio = 0.01;   // springs: xi_theta [-]
    double damping = 1e-10;            // film: c_z [N s/m]
    double pitchDamping = 1e-17;       // film: c_theta [N m s/rad]
    double rollDamping = 1e-17;        // film: c_phi [N m s/rad]
    double preload = 1.5e-3 * 9.80665; // film: f0 [N], presses the slider onto the disk
    double offsetX = 0.0;              // film: of the load from the slider's centre, towards the trailing edge [m]
    double offsetY = 0.0;              // film: towards the outer edge [m]
    double pitchTorque = 0.0;          // film: static, nose up [N m]
    double rollTorque = 0.0;           // film: static, inner edge up [N m]
    bool holdsAttitude = false;        // film: torques come from the stiffness and the static attitude below
    double staticPitch = 0.0;          // film: of the unloaded suspension [rad]
    double staticRoll = 0.0;           // film [rad]
    bool operator==(const SuspensionCase&) const = default;
};

struct AirCase {
    AirSource source = AirSource::Given;
    Air given;                   // p0 [Pa], mu [Pa s], lambda0 [m]
    double altitude = 0.0;       // [m]
    double temperature = 298.15; // [K]
    Slip slip;
    bool operator==(const AirCase&) const = default;
};

/// The film's discretisation and its solution.
struct FilmCase {
    std::array<int, 2> nodes{193, 193}; // grid lines along x and y, 16 k + 1
    double accuracy = 0.0;              // share at which finer grids need not be tried; 0: take `nodes` [-]
    GridKind grid = GridKind::Adapted;
    ConvectionScheme scheme = ConvectionScheme::CompleteFlux;
    FilmSolver solver = FilmSolver::Newton;
    double tolerance = 1e-7; // residual: net mass flow of the cells, summed, against the flow through the film [-]
    int maximumIterations = 60;
    FilmCoupling coupling = FilmCoupling::Monolithic; // of film and slider in a step of time
    FilmMotion motion = FilmMotion::Full;             // of a run: solved in each step, or linear about a static state
    double linearLimit = 0.1;                         // error of the linear film at which a run ends, of the motion [-]
    bool operator==(const FilmCase&) const = default;
};

/// What `steady` computes and with which conventions.
struct SteadyCase {
    bool fixedAttitude = false;  // solve the film at the initial attitude only
    bool stiffness = true;       // stiffness matrix
    bool sensitivities = false;  // of the attitude to the parameters
    bool allEquilibria = false;  // look for more than one
    double loadTolerance = 1e-6; // |dF| + |dTx|/L + |dTy|/L against the preload [-]
    double shearArm = 0.5; // arm of the air's shear about the pivot, in slider thicknesses [-]; established program: 1
    double torqueSign = 1.0;       // sign of the shear's pitch torque [-]; 1: it presses the nose down
    std::vector<double> radii;     // series; empty: disk.radius [m]
    std::vector<double> skews;     // one per radius; empty: disk.skew [rad]
    std::vector<double> speeds;    // empty: disk.speed [rad/s]
    std::vector<double> altitudes; // empty: the air as it is [m]
    bool operator==(const SteadyCase&) const = default;
};

/// Elastic contact of the deformable equivalent disk with the smooth pad.
struct ElasticCase {
    ElasticPair pair;
    double hardness = 0.0;   // cap of the contact pressure [Pa]; 0: none
    double friction = 0.3;   // mu [-]
    double cell = 0.25e-6;   // of the contact patch [m]
    double tolerance = 1e-8; // of force balance and complementarity [-]
    int maximumIterations = 50000;
    bool periodic = false;      // the patch repeats in both directions
    double patchPitch = 100e-6; // film: at which the parts of the surface are sought that can touch [rad]
    double patchReach = 5e-9;   // film: how high above the lowest point they may lie there [m]
    bool operator==(const ElasticCase&) const = default;
};

/// The pad of model "contact".
struct PadCase {
    PadShape shape = PadShape::Flat;
    double length = 20e-6; // flat, sphere: of the patch [m], along x
    double width = 20e-6;  // [m], along y
    double radius = 1e-3;  // sphere [m]
    bool operator==(const PadCase&) const = default;
};

/// How the pad of model "contact" moves: at constant speed from `start` to `closest` and back within run.duration.
struct ApproachCase {
    double start = 5e-9;    // separation of the pad's lowest point and the disk's mean plane [m]
    double closest = -1e-9; // [m], less than start; may be negative
    bool operator==(const ApproachCase&) const = default;
};

struct InitialCase {
    double flyingHeight = 250e-9;                    // [m]
    double pitch = 0.0;                              // [rad]
    double verticalVelocity = 0.0;                   // of the mass centre [m/s]
    double pitchVelocity = 0.0;                      // [rad/s]
    ContactBranch branch = ContactBranch::TouchDown; // used between d_s and d_e
    double nominalTrailingEdgeHeight = 20e-9; // film: of the trailing edge's centre, recess 0 [m]; may be negative
    double roll = 0.0;                        // film [rad]
    InitialState state =
        InitialState::Given;   // film: static: the static attitude moved by the offsets; the velocities count in both
    double heightOffset = 0.0; // film, static: of the mass centre [m]
    double pitchOffset = 0.0;  // [rad]
    double rollOffset = 0.0;   // [rad]
    double rollVelocity = 0.0; // film [rad/s]
    bool operator==(const InitialCase&) const = default;
};

struct RunCase {
    double duration = 2e-3; // [s]
    IntegratorKind integrator = usualIntegrator;
    double step = 10e-9;                       // fixed-step methods [s]
    StepControl steps = StepControl::Adaptive; // film; fixed: `step`
    double stepError = 5e-12;       // film, adaptive: by which one step's discretisation may displace the slider [m]
    double tolerance = 1e-8;        // adaptive methods, local error against the static state's scale [-]
    double newmarkBeta = 0.25;      // [-]
    double newmarkGamma = 0.5;      // [-]
    double sampleInterval = 0.1e-6; // [s]
    bool stepCheck = true;          // fixed-step methods: compare with half the step
    int fieldSnapshots = 50;        // of the fields, evenly over the run; 0: none
    int threads = 0;                // of a film's loops, within what a study leaves to each; 0: by itself. Results do
                                    // not depend on it
    bool operator==(const RunCase&) const = default;
};

/// How power spectra are estimated (Welch 1967).
struct SpectrumCase {
    SpectrumWindow window = SpectrumWindow::Hann;
    SpectrumScaling scaling = SpectrumScaling::Density;
    double segment = 0.2e-3; // length of one segment [s]
    double overlap = 0.5;    // shared by neighbouring segments [-]
    double start = 0.0;      // what comes before is left out [s]
    bool operator==(const SpectrumCase&) const = default;
};

struct Case {
    std::string title = "Untitled";
    About about;
    ModelKind model = ModelKind::Springs;
    ContactKind contact = usualContact;
    int degreesOfFreedom = 2;
    SliderCase slider;
    SpringsCase springs;
    SuspensionCase suspension;
    OnoYamane onoYamane;
    ElasticCase elastic;
    Adhesion adhesion;
    Asperities asperity;
    Meniscus meniscus;
    PadCase pad;
    ApproachCase approach;
    AirBearingSurface surface; // [abs]
    AirCase air;
    DiskMotion disk;
    DiskSurface diskSurface; // [disk.surface]
    FilmCase film;
    SteadyCase steady;
    InitialCase initial;
    RunCase run;
    SpectrumCase spectrum;
    std::filesystem::path folder; // of the case file, in which the files lie that it names; empty: the working one

    // Compiled once: a case is large, and is copied in many places.
    Case();
    Case(const Case&);
    Case(Case&&) noexcept;
    Case& operator=(const Case&);
    Case& operator=(Case&&) noexcept;
    ~Case();

    /// The same values and the same folder, hence the same run. No accepted case holds a NaN, which equals nothing.
    bool operator==(const Case&) const;
};

} // namespace touchdown
