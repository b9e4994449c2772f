// SPDX-License-Identifier: GPL-3.0-or-later
//
// The springs over one wave of the disk, period by period of the forcing.
//
// The wave has the angular frequency w = 2 pi f and the period T = 1/f. Time is counted from where the disk under the
// contact pad passes its mean plane upwards, so that the disk has there the height a sin(w t). The state at t = 0, T,
// 2 T, ... is the stroboscopic section: a motion repeats after n periods where P^n(y) = y, P the motion over one T.
//
//   Q = 2/(n T) int q(t) exp(-i w t) dt,   q(t) = Re Q exp(i w t) + ...
//
// is the first harmonic of a recorded quantity q. Its amplitude is |Q|. Its phase is arg(i Q), against the disk under
// the pad: 0 in phase, negative where the quantity lags. The integral is taken over each step with five Gauss points of
// its dense output; steps end on the switches of the laws, so that its error is the one of the integrator.
//
//   Phi' = A(t) Phi along a step,   S = I + (f+ - f-) g^T/(g . v - w') at a switch
//
// give dP^n/dy, whose eigenvalues are the multipliers (Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth
// Mechanical Systems, 2004, chapter 7); g is the normal of the switch, v the velocities and w' the rate of the disk.
#pragma once

#include <algorithm>
#include <complex>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/simulation/springs/disk_under_springs.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// At the beginning of a period of the forcing.
struct ForcedState {
    SpringModel::State y = SpringModel::State::Zero(); // z [m], theta [rad], z' [m/s], theta' [rad/s]
    SpringModel::Mode mode;
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
    Eigen::Vector2d swing = Eigen::Vector2d::Zero(); // half of the range of z [m] and of theta [rad] at ends of steps
    Eigen::Matrix4d derivative = Eigen::Matrix4d::Identity();
    std::complex<double> harmonic;                                 // Q [unit of the quantity]
    double least = std::numeric_limits<double>::infinity();        // of the quantity [its unit]
    double most = -std::numeric_limits<double>::infinity();        // [its unit]
    double leastSpacing = std::numeric_limits<double>::infinity(); // of pad and pressure centres [m]
    int touchDowns = 0;                                            // from without contact
    double contactShare = 0.0;                                     // of the time with real contact, 0..1
    bool frontLost = true;                                         // that spring carried at no time
    bool rearLost = true;
};

class ForcedSprings {
public:
    /// A valid case of model "springs" over one moving wave; `quantity` is the name of one of its quantities.
    ForcedSprings(const Case& c, const std::string& quantity);

    double frequency() const { return 1.0 / period_; }      // f [Hz]
    double waveAmplitude() const { return waveAmplitude_; } // [m]
    /// Of the height in one step, also of rough steps: not below the round-off of the height [m].
    double stepError(bool rough = false) const
    {
        return std::max(toleranceOf(rough) * model_.scale()[0], roundOffOfHeight(model_));
    }
    /// Of a height near the static state [m].
    static double roundOffOfHeight(const SpringModel& model);
    const SpringModel& model() const { return model_; }
    /// From the start of the case.
    ForcedState start() const;
    /// This state with the laws of its spacings; the branch of the contact's hysteresis is kept.
    ForcedState continued(const ForcedState& before) const;
    ForcedPeriods run(const ForcedState& start, const ForcedRequest& request) const;

    /// Q of small motions about the static state, for the whole wave [unit of the quantity]; nothing where the pad is
    /// in contact there and no equilibrium is found from it, or where it is unstable.
    std::optional<std::complex<double>> linear() const;

private:
    static constexpr double roughTimes = 1e3; // error of a rough step [-]

    double toleranceOf(bool rough) const { return (rough ? roughTimes : 1.0) * tolerance_; }
    SpringModel::Under underAt(double time) const { return disk_.at(begin_ + time); }

    DiskUnderSprings disk_;
    SpringModel model_;
    std::size_t quantity_, minimumSpacing_; // places in the list of quantities
    std::size_t quantities_;                // their number
    double waveAmplitude_;                  // a [m]
    double period_;                         // T [s]
    double begin_;                          // at which time of the case t is 0 [s]
    double tolerance_;                      // local error of a step, in units of SpringModel::scale [-]
    bool hasFront_, hasRear_;               // air springs with a stiffness
};

/// The case over one wave of this amplitude [m] and frequency [Hz] alone, which moves. Its length follows from the
/// speed of the disk; where `wavelength` [m] is not 0, that is the length and the speed follows.
Case caseOverWave(Case c, double amplitude, double frequency, double wavelength);
/// The speed with which the disk moves from the leading to the trailing edge [m/s].
double speedAlong(const Case& c);

} // namespace touchdown
