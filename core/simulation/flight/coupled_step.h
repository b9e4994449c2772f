// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step of film, contact and slider together, all implicit. The film is integrated by a backward difference that is
// exact for oscillations at the fastest rate of the slider on film and contact (film_step.h), so that a run has the
// damping of its film; where the rate is not known or steps change by more than a quarter, by BDF2OPT. The slider is
// integrated by Newmark's method (1959) with gamma 1/2, which has no damping of its own:
//
//   q = q1 + dt u1 + dt^2 ((1/2 - beta) a1 + beta a),  u = u1 + dt (a1 + a)/2
//
//   beta 1/12    (Fox & Goodwin 1949): fourth order, stable up to omega dt = sqrt 6. u is not exactly the velocity:
//                v = u - dt^2 a'/12. The difference matters where dt changes. Used by monolithic, where omega dt is
//                far below that limit and the stiffness is known.
//   beta 1/4     the trapezoidal rule: second order, stable. u = v.
//
//   G(p, q) = film(p, q) + contact(q) + suspension(q, v) - M a = 0,   R(p, q) + d(V p)/dt = 0
//
//   monolithic   one Newton iteration on pressure and attitude, with X = J^-1 dR/dq, which is kept as long as the
//                film's J is good:
//                (M/(beta dt^2) + C/(2 beta dt) + K + K_contact - dG/dq + dG/dp X) dq = G,  dp = -X dq
//   staggered    the film is solved at the attitude, then the forces move the slider,
//                (M/(beta dt^2) + C/(2 beta dt) + K) dq = G, until neither changes: the established program's method.
//                It converges where the stiffness k of film and contact satisfies beta k dt^2 < M, and reports where
//                it does not.
#pragma once

#include <array>
#include <functional>

#include "core/case/case.h"
#include "core/simulation/contact/slider_contact.h"
#include "core/simulation/flight/film_in_time.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

class GasFilm;
class StateStream;

struct CoupledStepOptions {
    FilmCoupling coupling = FilmCoupling::Monolithic;
    FilmStepOptions film;
    double tolerance = 1e-13;     // of the slider's position, at its corners [m]
    int maximumIterations = 40;   // attitudes tried
    std::function<bool()> goOn{}; // asked before each solution within a step; false ends the step
};

/// Of a run: what its error of a step allows.
CoupledStepOptions steppingOf(const Case& c, const GasFilm& film);

enum class CoupledFailure : std::uint8_t { None, Film, Contact, Iteration, NotFinite, Stopped };

struct CoupledStepResult {
    CoupledFailure failure = CoupledFailure::None;
    int iterations = 0; // attitudes at which the film was solved
    int filmIterations = 0;
    int linearisations = 0;    // of the film
    int solves = 0;            // preconditioned iterations
    double positionLeft = 0.0; // estimated distance of the corners from the step's solution [m]
    double forceBalance = 0.0; // |G| against the load, or ambient pressure times area where there is none: force, and
                               // torques over the slider's length [-]
    double filmError = 0.0;    // FilmStepResult::error [-]
    double timeError = 0.0;    // of the discretisation in time, as a displacement of the corners [m]
    bool converged() const { return failure == CoupledFailure::None; }
};

/// Cost of all tried steps.
struct CoupledCost {
    double filmSeconds = 0.0, responseSeconds = 0.0, forceSeconds = 0.0, contactSeconds = 0.0,
           diskSeconds = 0.0;         // wall clock [s]
    long long filmSolves = 0;         // attitudes at which the film was solved
    long long linearisations = 0;     // of the film
    long long contactSolves = 0;      // attitudes at which the contact was evaluated
    long long contactSkipped = 0;     // attitudes at which nothing was in reach
    double contactSolveSeconds = 0.0; // of the evaluations [s]
    long long jacobiansKept = 0;      // attitudes at which the film needed no linearisation
};

/// Film, body and contact must last; the contact may be null. Allocates at construction alone.
class CoupledStepper {
public:
    CoupledStepper(FilmInTime& film, const SliderBody& body, SliderContact* contact, const CoupledStepOptions& options);

    /// Begins at the motion's q and v; its acceleration is that of the forces.
    void start(const SliderMotion& motion, double time);
    /// Tries a step of `dt` [s] from the last accepted state.
    CoupledStepResult step(double dt);
    /// Makes the last tried step the accepted state. It must have converged.
    void accept();
    /// The contact's law has changed at the accepted state: the acceleration follows the forces that now act.
    void restartAcceleration();

    /// All that the next step depends on but contact and disk, written or read.
    void pass(StateStream& stream);

    double time() const { return time_; }
    const SliderMotion& motion() const { return motion_; } // accepted
    const SliderMotion& tried() const { return tried_; }   // of the last step
    /// Force of the film with shear, and of the contact, in the last step.
    const Vector3& filmForce() const { return filmForce_; }
    const SliderContactForces& contactForces() const { return contactForces_; }
    bool contactInReach() const { return inReach_; }
    const CoupledCost& cost() const { return cost_; }
    /// The largest angular frequency by the stiffness of film and contact; zero: unknown, as in `staggered` [rad/s].
    double fastestRate() const;

private:
    CoupledStepResult tryStep(double dt, bool fourth);
    void askContact(const Attitude& attitude, double time);
    void setSurface(double time);
    void setFilmForce();
    /// By film and contact as last known, and the suspension at a motion.
    Vector3 forceOn(const SliderMotion& at) const;
    Vector3 accelerationBy(const Vector3& force) const;
    Vector3 stiffJerk(const Vector3& v) const;
    Vector3 solveBody(const Vector3& right, double perSquare, double perTime, bool stiff) const;
    double stiffShare(double perSquare) const;
    Vector3 forecastAcceleration(double dt) const;
    FilmStepResult stepFilm(double dt);
    /// Changes film and forces by their response; returns the possible error as FilmStepResult::error [-].
    double follow(const Vector3& change);
    void setRule(double dt, bool fourth);
    void setVelocity(double dt);
    void finishMotion(double dt, const Vector3& change);
    void setTimeError(double dt, CoupledStepResult& result);

    FilmInTime& film_;
    const SliderBody& body_;
    SliderContact* contact_;
    CoupledStepOptions options_;
    SliderMotion motion_, tried_; // accepted, tried
    // a' at the accepted state, its mean over the last step, and as it separates u from v; and of the tried state.
    Vector3 jerk_ = Vector3::Zero(), slope_ = Vector3::Zero(), shiftJerk_ = Vector3::Zero();
    Vector3 triedJerk_ = Vector3::Zero(), triedSlope_ = Vector3::Zero(), triedShiftJerk_ = Vector3::Zero();
    // Before the accepted state: accelerations, the steps from them to the next; zero where forces have jumped [s].
    std::array<Vector3, 3> earlier_{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    std::array<double, 3> lengths_{};
    double time_ = 0.0, dt_ = 0.0; // accepted; of the tried step [s]
    double lastDt_ = 0.0;          // of the last step; zero where forces have jumped [s]
    // The rule of the tried step: beta, and (u - v)/a' [s^2].
    bool fourth_ = false;
    double later_ = 0.25, shift_ = 0.0;
    Vector3 rate_ = Vector3::Zero(); // u1
    bool inReach_ = false;           // contact, at the last attitude
    Vector3 filmForce_ = Vector3::Zero();
    SliderContactForces contactForces_;
    Matrix3 contactStiffness_ = Matrix3::Zero();
    double acceptedRate_ = 0.0; // fastestRate() at the accepted state, to which film and forecast are fitted [rad/s]
    // The last stiffness of which fastestRate() was found.
    mutable Matrix3 rated_ = Matrix3::Zero();
    mutable double ratedRate_ = 0.0; // [rad/s]
    bool starting_ = true;           // no step has been accepted yet
    CoupledCost cost_;
    double contraction_ = 0.0; // of the iteration, as last measured [-]
};

} // namespace touchdown
