// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equilibria of a slider while one parameter p of its case changes: points along branches, each branch under one law of
// contact, and the marks at which a branch changes or ends. The same for the spring model and for a film.
#pragma once

#include <complex>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numerics/small_matrix.h"
#include "core/physics/contact/ono_yamane.h"

namespace touchdown {

struct Case;

/// The direction of small motions about an equilibrium.
enum class Stability : std::uint8_t {
    Stable,    // they decay
    Neutral,   // none grows and not all decay: without damping
    Flutter,   // an oscillation grows
    Divergence // one grows without oscillating
};
std::string_view name(Stability stability);

struct Equilibrium {
    double parameter = 0.0;                          // p [its unit]
    Vector3 q = Vector3::Zero();                     // height of the mass centre [m], pitch, roll [rad]
    double spacing = 0.0;                            // minimum spacing; of springs that of the pad [m]
    bool touching = false;                           // on the take-off branch: pressed, or held by menisci
    double netContactForce = 0.0;                    // of a film [N]
    std::vector<std::complex<double>> eigenvalues{}; // of a film those of oscillations; by falling real part [1/s]
    Stability stability = Stability::Stable;         // as far as the motions were followed
    int lost = 0; // oscillations of a film that could not be followed, or are damped so much that they are none
};

/// Under one law.
struct EquilibriumBranch {
    ContactRegion contact = ContactRegion::Apart; // the lowest region with the law
    bool frontSpring = true, rearSpring = true;   // of springs: which ones carry
    std::vector<Equilibrium> points{};            // in their order along it
};

enum class EquilibriumMark : std::uint8_t {
    Fold,   // two equilibria meet
    Hopf,   // an oscillation begins to grow
    Switch, // the law switches and its force jumps: no equilibrium beyond
    Kink    // the law switches and its force is continuous: the branch continues under another law
};
std::string_view name(EquilibriumMark mark);

struct MarkedEquilibrium {
    EquilibriumMark kind = EquilibriumMark::Fold;
    Equilibrium at;
    std::string name; // "touch-down", "rear spring lost": of a switch or a kink; else that of the kind
};

struct EquilibriumBranches {
    bool stopped = false;
    std::vector<EquilibriumBranch> branches;
    std::vector<MarkedEquilibrium> marks;
    int endsLost = 0; // ends of branches that were not explained: the case is not valid beyond, or a step failed
    // For a film alone:
    std::vector<std::string> problems; // of values at which nothing was sought, in sentences
    int givenUp = 0;                   // values at which the search in contact did not come to its end from every start
    double resolved = 0.0;             // least frequency up to which the grid resolves an oscillation's damping [Hz]
};

/// The case at a value of p; empty where it is not valid.
using CaseAt = std::function<std::optional<Case>(double)>;

} // namespace touchdown
