// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of the spring model while one of its values changes. In each mode (region of the contact law, springs that
// carry or are lost) the laws are smooth, and the equilibria
//
//   z''(z, theta; p) = 0,   theta''(z, theta; p) = 0
//
// are branches: they are followed by pseudo-arclength (core/numerics/continuation.h), each within the intervals of its
// mode. Where a branch meets the end of an interval, its piece ends: the force jumps there, or goes on with a kink, or
// with the same law. Stability follows from the four eigenvalues of the mode's linear motion. Friction mu F_cr turns
// the slider by as much as the pad is pressed, and the pad is not pressed by how far it is turned back: the stiffness
// is not symmetric, so that two modes may meet and flutter.
//
// Pieces are sought at a number of values of p, on a grid of spacings in every mode, and are missed where they lie
// between two of these values and fold back, or where two equilibria of a mode are closer than the grid. Where pad or a
// spring's place lies deeper than ten static spacings below the disk's mean plane, as without any spring, the model
// means nothing, and nothing is sought.
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// Where small motions about an equilibrium go.
enum class Stability : std::uint8_t {
    Stable,    // they fade
    Neutral,   // none grows and not all fade: without damping
    Flutter,   // an oscillation grows
    Divergence // one grows without oscillating
};
std::string_view name(Stability stability);

using Eigenvalues4 = std::array<std::complex<double>, 4>;

struct SpringEquilibrium {
    double parameter = 0.0;      // p [its unit]
    Eigen::Vector2d q{0.0, 0.0}; // z [m], theta [rad]
    double flyingHeight = 0.0;   // d [m]
    Eigenvalues4 eigenvalues{};  // by falling real part [1/s]
    Stability stability = Stability::Stable;
    double growth() const { return eigenvalues.front().real(); } // largest real part [1/s]
};

/// Of the motion about q in a mode, by falling real part [1/s].
Eigenvalues4 eigenvaluesAt(const SpringModel& model, const Eigen::Vector2d& q, SpringModel::Mode mode);
Stability stabilityOf(const Eigenvalues4& eigenvalues);

struct FoundEquilibrium {
    SpringModel::Mode mode;
    Eigen::Vector2d q; // z [m], theta [rad]
};
/// How deep below the disk's mean plane equilibria are sought, in the model's scale of length [-].
inline constexpr double deepest = 10.0;
/// Those of one model in all of its modes.
std::vector<FoundEquilibrium> springEquilibria(const SpringModel& model);

/// A branch within one mode.
struct EquilibriumPiece {
    SpringModel::Mode mode;
    std::vector<SpringEquilibrium> points; // in their order along it
};

enum class EquilibriumMark : std::uint8_t {
    Fold,   // two equilibria meet
    Hopf,   // an oscillation begins to grow
    Switch, // the law switches and its force jumps: no equilibrium beyond
    Kink    // the law switches and its force goes on: the branch goes on in another mode
};
std::string_view name(EquilibriumMark mark);

struct MarkedEquilibrium {
    EquilibriumMark kind = EquilibriumMark::Fold;
    SpringEquilibrium at;
    std::string name; // "touch-down", "rear spring lost": of a switch; else that of the kind
};

struct SpringEquilibria {
    bool stopped = false;
    std::vector<EquilibriumPiece> pieces;
    std::vector<MarkedEquilibrium> marks;
    int endsLost = 0; // ends of pieces that were not explained: the case is not valid beyond, or a step failed
};

/// The case at a value of p; empty where it is not valid.
using CaseAt = std::function<std::optional<Case>(double)>;

/// Between two values, sought at `looks` >= 2 of them; `goOn` is asked all along.
SpringEquilibria traceSpringEquilibria(const CaseAt& caseAt, double from, double to, int looks,
                                       const std::function<bool(double share)>& goOn = {});

} // namespace touchdown
