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
    /// A state on the way out, between those that are added [m], net [N].
    void addPull(double separation, double force);
    void pass(StateStream& stream)
    {
        stream(closest_, largestContact_, strongestPull_, strongestPullAt_, jumps_, lostInJumps_);
    }
    double strongestPull() const { return -strongestPull_.value_or(0.0); } // so far [N], >= 0
    /// With the loop of the full multi-asperity model where it was fitted.
    std::vector<RunFigure> figures(const std::optional<SurfaceStatistics>& surface,
                                   const std::optional<CharacteristicFit>& fit = {}) const;

private:
    const Case& case_;
    std::optional<ContactForces> closest_;
    double largestContact_ = 0.0;                           // [N]
    std::optional<double> strongestPull_, strongestPullAt_; // net force on the way out [N], [m]
    std::vector<ContactJump> jumps_;
    double lostInJumps_ = 0.0; // [J]
};

} // namespace touchdown
