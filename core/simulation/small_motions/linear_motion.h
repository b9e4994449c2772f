// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion of a slider on its film for small displacements from the static state: the sum of its modes, excited by
// the initial displacement and velocities, and of its response to the waves of the disk's surface.
//
//   q(t) = q_0 + Re sum_k 2 a_k e^(s_k t) + Re sum_j q_j e^(i omega_j t),   omega_j = k_j . U
//
// With D(s) = s^2 M + s C + K + Z(s), F(s) w the film's force from a surface w e^(s t) under a slider at rest, and
// psi_k^T D(s_k) = 0:
//
//   q_j = D(i omega_j)^-1 F(i omega_j) w_j
//   a_k = phi_k psi_k^T ( M v - D(0) dq/s_k + F(s_k) sum_j (w_j/(s_k - i omega_j) + w_j*/(s_k + i omega_j))/2 )
//         / (psi_k^T D'(s_k) phi_k)
//
// These are the residues of the Laplace transform. As in a run, the slider starts displaced by dq, with velocity v
// and over a film that is steady there, and the waves start under it at that moment. q_0, modes and responses are
// those of the film on the grid of run(). Contact, adhesion, surfaces other than moving waves, and the film's own
// decaying modes are left out.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

struct MotionTerm {
    std::complex<double> rate; // [1/s]
    ComplexVector3 amplitude;  // of q: height of the mass centre [m], pitch, roll [rad]
};

struct LinearMotion {
    SteadyStatus status = SteadyStatus::Failed;
    std::string message;           // why there is none
    SteadyResult steady;           // without stiffness and sensitivities
    std::vector<MotionTerm> modes; // with the amplitudes of the start
    std::vector<MotionTerm> waves; // responses to them
    double halfLength = 0.0;       // of the slider [m]

    Attitude at(double time) const;
    /// Whether a mode grows.
    bool unstable() const;
};

/// The whole motion, or only the responses to waves, which remain when the modes have decayed: a tenth of the work.
enum class MotionParts : std::uint8_t { All, Waves };

/// A valid case of model "film". The callback is asked as by steady().
LinearMotion linearMotion(const Case& c, const SteadyCallback& callback = {}, MotionParts parts = MotionParts::All);

} // namespace touchdown
