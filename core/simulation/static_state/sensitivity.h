// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sensitivities of a static attitude to every continuous parameter, from its adjoint: three adjoint films serve all
// parameters, each of which costs two evaluations of film and contact on the same grid.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/physics/slider/surface_edit.h"
#include "core/simulation/static_state/flying_attitude.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

class FilmBalance;
struct FilmGaps;

/// Of a static state with its contact; case and balance must last, the balance solved there. In contact the place where
/// the suspension exerts its load is kept: its change counts as little as the springs do beside film and contact.
class AttitudeSensitivity {
public:
    AttitudeSensitivity(const Case& c, FilmBalance& balance, const ContactAtRest& contact);

    /// To a change of the case by an amount, from central differences of plus and minus `step`; without a name, per
    /// unit of the amount. `ofSurface`: it changes the recess.
    Sensitivity to(const std::function<void(Case&, double)>& change, double step, bool ofSurface) const;

private:
    Vector3 misses(const Case& moved, MinimumSpacing spacing, std::shared_ptr<const FilmGaps> gaps,
                   std::vector<double>& residual) const;

    const Case& case_;
    FilmBalance& balance_;
    ContactAtRest contact_;
    FlyingAttitude::Adjoint adjoint_;
    SurfacePoint nearest_;
};

/// In contact, to the main parameters of the contact, too; of many asperities with the menisci that have formed.
std::vector<Sensitivity> sensitivities(const Case& c, FilmBalance& balance, const ContactAtRest& contact);

/// What a part of the shape does to the state.
struct PartInfluence {
    SurfacePart part; // a rail: per metre of recess; an edge: per metre of its shift away from the rail
    Sensitivity per;  // of height [m/m], pitch and roll [rad/m] and minimum spacing [m/m]
};
using InfluenceCallback = std::function<bool(const PartInfluence*)>;
/// Of these rails and edges, on the grid of a converged state, whose lines move with the edges (steady_near.h); as far
/// as it gets until `callback` returns false, which is called with each part that is found and, with nullptr,
/// meanwhile. Rails, and edges between edges parallel to x or y: from the adjoint. A slanted edge changes the film by
/// jumps from cell to cell: from two states with the edge moved by 4 um, or a tenth of a narrow rail, to either side;
/// nothing where such a state is not found.
std::vector<PartInfluence> shapeInfluence(const Case& c, const SteadyResult& state, const PartSelection& parts,
                                          const InfluenceCallback& callback = {});

} // namespace touchdown
