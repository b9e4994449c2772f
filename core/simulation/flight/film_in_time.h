// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film under a slider in the steps of a run, by the motion of the slider: solved on its cells (film_on_cells.h), or
// linear about a static state (linear_film.h).
#pragma once

#include <array>
#include <functional>

#include "core/physics/film/film_energy.h"
#include "core/physics/film/film_step.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

class StateStream;

class FilmInTime {
public:
    virtual ~FilmInTime() = default;

    /// Begins at a motion. The disk is set.
    virtual void start(const SliderMotion& motion, double time) = 0;
    /// The disk's surface at a time; `touched`: as the contact that was last asked deforms it.
    virtual void setDisk(double time, bool touched) = 0;
    /// Solves `dt` after the accepted state, where the slider had the motion `from`, at the slider's coordinates q.
    /// `rate`: angular frequency to which the step is fitted; zero: none [rad/s].
    virtual FilmStepResult step(double dt, const SliderMotion& from, const Vector3& q, double rate) = 0;
    /// Load and torques about the mass centre, of the last step.
    virtual Vector3 force() = 0;

    /// S = -dF/dq of the last step, which guides an iteration; zero where it is not known [N/m ...].
    virtual const Matrix3& stiffness() const = 0;
    /// Its error [-].
    virtual double stiffnessError() const = 0;
    virtual bool isResponseKnown() const = 0;
    virtual bool isResponseOld() const = 0;
    /// Returns the number of preconditioned iterations. If `goOn` returns false nothing is known.
    virtual int renewResponse(bool touched, const std::function<bool()>& goOn) = 0;
    /// Steps converge more slowly.
    virtual void outdateResponse() = 0;
    /// Moves the solution of the last step to a nearby q, by `change`; returns the possible error, as
    /// FilmStepResult::error [-].
    virtual double follow(const Vector3& q, const Vector3& change) = 0;
    /// Allowed error of the last step, as FilmStepResult::error [-].
    virtual double allowed() const = 0;
    /// Load of the last step's error of discretisation in time: force, pitch and roll torque [N], [N m].
    virtual std::array<double, 3> timeErrorLoad() const = 0;
    /// Makes the last step the accepted state; false, and nothing done, if it did not converge.
    /// `to`: the slider's motion there.
    [[nodiscard]] virtual bool accept(const SliderMotion& to) = 0;

    /// Whether the last step was exact at the rate that it was given.
    virtual bool isFitted() const = 0;
    /// How often a cell has closed since the start.
    virtual long long closings() const { return 0; }
    /// Of ambient pressure on the whole slider [N].
    virtual double ambientForce() const = 0;

    // The energy balance of a run (film_energy_balance.h).
    /// Torques of the shear, contained in force(); their power is not part of the flows [N m].
    virtual Vector3 shearTorques() const = 0;
    virtual FilmEnergyState energy() = 0;
    /// Work of the disk's surface since the last call [J].
    virtual double surfaceWork() = 0;

    /// All that the next step depends on, written or read.
    virtual void pass(StateStream& stream) = 0;
};

} // namespace touchdown
