// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider over one wave of the disk, period by period of the forcing.
//
// The wave has the angular frequency w = 2 pi f and the period T = 1/f. Time is counted from where the disk under one
// point of the slider passes its mean plane upwards, so that the disk has there the height a sin(w t). The state at
// t = 0, T, 2 T, ... is the stroboscopic section: a motion repeats after n periods where P^n(y) = y, P the motion over
// one T.
//
//   Q = 2/(n T) int q(t) exp(-i w t) dt,   q(t) = Re Q exp(i w t) + ...
//
// is the first harmonic of a recorded quantity q. Its amplitude is |Q|. Its phase is arg(i Q), against the disk under
// the point: 0 in phase, negative where the quantity lags.
//
//   Phi' = A(t) Phi along a step,   S = I + (f+ - f-) g^T/(g . v - w') at a switch
//
// give dP^n/dy, whose eigenvalues are the multipliers (Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth
// Mechanical Systems, 2004, chapter 7); g is the normal of the switch, v the velocities and w' the rate of the disk.
#pragma once

#include <complex>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// At the beginning of a period of the forcing.
struct ForcedState {
    /// Positions, then as many velocities, then what the film remembers: springs have z [m], theta [rad], z' [m/s],
    /// theta' [rad/s].
    Eigen::VectorXd y;
    SpringModel::Mode mode; // of a film the region of its contact
};

/// What is taken along the periods.
struct ForcedRequest {
    int periods = 1;
    bool derivative = false;   // dP^n/dy
    bool measurements = false; // of the quantity and the contact
    bool rough = false;        // with a thousand times the error of a step, which is enough while a motion settles
};

struct ForcedPeriods {
    std::string problem; // why the motion ended before, in a sentence without a full stop; "" where it did not
    ForcedState end;
    Eigen::VectorXd swing; // half of the range of each position at ends of steps [m], [rad]
    Eigen::MatrixXd derivative;
    std::complex<double> harmonic;                                 // Q [unit of the quantity]
    double least = std::numeric_limits<double>::infinity();        // of the quantity [its unit]
    double most = -std::numeric_limits<double>::infinity();        // [its unit]
    double leastSpacing = std::numeric_limits<double>::infinity(); // of pad and pressure centres, of a film above the
                                                                   // mean plane [m]
    int touchDowns = 0;                                            // from without contact
    double contactShare = 0.0;                                     // of the time with real contact, 0..1
};

class ForcedSlider {
public:
    virtual ~ForcedSlider() = default;

    virtual double frequency() const = 0;     // f [Hz]
    virtual double waveAmplitude() const = 0; // [m]
    /// Of a position in one step, also of rough steps: not below its round-off [m].
    virtual double stepError(bool rough) const = 0;
    /// Units of a state of a motion with this swing: the sizes of its parts. At least those of leastSize.
    virtual Eigen::VectorXd units(const Eigen::VectorXd& swing) const = 0;
    static constexpr double leastSize = 0.1; // of a motion, in amplitudes of the wave [-]
    virtual Eigen::Index positions() const = 0;

    /// From the start of the case.
    virtual ForcedState start() const = 0;
    /// The static state, moved in a direction of unit length of positions and velocities, in their natural units, by a
    /// size [m].
    virtual ForcedState moved(const Eigen::VectorXd& direction, double size) const = 0;
    /// The static state at rest, lower by a distance [m].
    virtual ForcedState lowered(double distance) const = 0;
    /// This state with the laws of its spacings; the branch of the contact's hysteresis is kept.
    virtual ForcedState continued(const ForcedState& before) const = 0;
    virtual ForcedPeriods run(const ForcedState& start, const ForcedRequest& request) const = 0;

    /// Q of small motions about the static state, for the whole wave [unit of the quantity]; nothing where the pad is
    /// in contact there and no equilibrium is found from it, or where it is unstable.
    virtual std::optional<std::complex<double>> linear() const = 0;
};

} // namespace touchdown
