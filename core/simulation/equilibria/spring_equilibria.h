// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of the spring model while one of its values changes. In each mode (region of the contact law, springs that
// carry or are lost) the laws are smooth, and the equilibria
//
//   z''(z, theta; p) = 0,   theta''(z, theta; p) = 0
//
// are branches: they are followed by pseudo-arclength (core/numerics/continuation.h), each within the intervals of its
// mode. A branch ends where it meets the end of an interval: the force jumps there, or continues with a kink or with
// the same law. Stability follows from the four eigenvalues of the mode's linear motion. Friction mu F_cr makes the
// stiffness unsymmetric, so that two modes may meet and flutter.
//
// Branches are sought at a number of values of p, on a grid of spacings in every mode. They are missed where they lie
// between two of these values and fold back, or where two equilibria of a mode are closer than the grid. The model is
// not valid where pad or a spring's place is deeper than ten static spacings below the disk's mean plane, as without
// any spring; nothing is sought there.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "core/simulation/equilibria/equilibrium.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// Eigenvalues of the motion about q in a mode, by falling real part [1/s].
std::vector<std::complex<double>> eigenvaluesAt(const SpringModel& model, const Eigen::Vector2d& q,
                                                SpringModel::Mode mode);
Stability stabilityOf(const std::vector<std::complex<double>>& eigenvalues);

struct FoundEquilibrium {
    SpringModel::Mode mode;
    Eigen::Vector2d q; // z [m], theta [rad]
};
/// How deep below the disk's mean plane equilibria are sought, in the model's scale of length [-].
inline constexpr double deepest = 10.0;
/// Those of one model in all of its modes.
std::vector<FoundEquilibrium> springEquilibria(const SpringModel& model);

/// Between two values, sought at `looks` >= 2 of them; `goOn` is asked all along.
EquilibriumBranches traceSpringEquilibria(const CaseAt& caseAt, double from, double to, int looks,
                                          const std::function<bool(double share)>& goOn = {});

} // namespace touchdown
