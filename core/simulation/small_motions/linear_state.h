// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state of a case with its film as a linear system. It takes seconds, so that the last few are kept for the
// runs of cases that have the same state: offsets and velocities of a start from it, durations, disks and limits may
// differ.
#pragma once

#include <functional>
#include <memory>

#include "core/case/case.h"
#include "core/simulation/small_motions/film_fit.h"
#include "core/simulation/static_state/steady_result.h"

namespace touchdown {

/// A film about a static state.
struct LinearFilmModel {
    Vector3 place = Vector3::Zero(); // q of the state [m], [rad]
    Vector3 rest = Vector3::Zero();  // q about which the slider moves: `place`, if the state is that of its own case
    Vector3 force = Vector3::Zero(); // F_0 about the mass centre, with the torques of the shear [N], [N m]
    FilmFit fit;
    double spacing = 0.0;           // minimum spacing of the state [m]
    Vector3 arms = Vector3::Zero(); // of a corner: 1, half the length, half the width [-], [m]
    double waviness = 0.0;          // root mean square height of the disk's waves [m]
    double ambientForce = 0.0;      // of ambient pressure on the whole slider [N]
    /// The answer to the waves of a moving disk: the sum of Re(f e^(i omega t)), and a transient of the film's poles,
    /// since it was steady over the mean plane of the disk until the start: the sum of a_k e^(p_k t), with conjugates.
    struct Wave {
        double omega = 0.0;                            // [1/s]
        ComplexVector3 force = ComplexVector3::Zero(); // f, about the mass centre [N], [N m]
        void pass(auto& stream) { stream(omega, force); }
    };
    std::vector<Wave> waves;
    std::vector<ComplexVector3> transient; // a_k; empty without waves
    double transientError = 0.0; // of it at frequencies not fitted, against the largest force of the waves [-]

    /// The waves get this many times their amplitude.
    void scaleWaves(double ratio);
    void pass(auto& stream)
    {
        stream(place, rest, force, fit, spacing, arms, waviness, ambientForce, waves, transient, transientError);
    }
};

struct LinearState {
    Case solved;
    SteadyResult rest;
    LinearFilmModel film;
};

/// One that is kept for this case, maybe with another disk surface; null: none.
std::shared_ptr<const LinearState> knownLinearState(const Case& c);

/// Whether one is kept for this case with its disk: a run of it needs no other.
bool hasLinearState(const Case& c);

/// One that is kept for this case; else one of a case with the same film apart from contact and load (sameFilmApart),
/// with its waves of this case's amplitude: an exact film about another attitude. Null: none.
std::shared_ptr<const LinearState> nearestLinearState(const Case& c);

/// Whether it is the state of this case: what a run would find. Dampers do not act at rest.
bool isStateOf(const LinearState& state, const Case& c);

/// Whether its film knows the disk of this case.
bool answersDisk(const LinearState& state, const Case& c);

/// The film of a case about its static state, converged, which is kept from now on. `known`: the same film over another
/// disk surface; null: none. Null where `goOn`, asked within long solutions, returns false. Throws std::runtime_error,
/// a sentence, where a linear system was not solved.
std::shared_ptr<const LinearState> makeLinearState(const Case& c, SteadyResult rest, const LinearFilmModel* known,
                                                   const std::function<bool()>& goOn);

} // namespace touchdown
