// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures of an approach and retraction curve: pull-off force, jumps, work of the loop, statistics of the surface.
#pragma once

#include <optional>
#include <vector>

#include "core/physics/contact/contact_jump.h"
#include "core/simulation/contact/contact_model.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

class ContactFigures {
public:
    explicit ContactFigures(const Case& c) : case_(c) {}

    void add(const ContactForces& forces, bool away);
    void addJump(const ContactJump& jump);
    /// With the loop of the full multi-asperity model where it was fitted.
    std::vector<RunFigure> figures(const std::optional<SurfaceStatistics>& surface,
                                   const std::optional<CharacteristicFit>& fit = {}) const;

private:
    /// Adds the work of a way to this state.
    void follow(double separation, double force);

    const Case& case_;
    std::optional<ContactForces> closest_;
    double largestContact_ = 0.0;                           // [N]
    std::optional<double> strongestPull_, strongestPullAt_; // net force on the way out [N], [m]
    std::vector<ContactJump> jumps_;
    std::optional<double> lastSeparation_; // [m]
    double lastForce_ = 0.0;               // net [N]
    double lastEnergy_ = 0.0;              // [J]
    double workOfStep_ = 0.0;              // done on the contact since the last state, by the trapezoidal rule [J]
    bool jumpInStep_ = false;
    double lostInJumps_ = 0.0; // [J]
};

} // namespace touchdown
