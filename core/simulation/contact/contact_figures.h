// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures of an approach and retraction curve: pull-off force, jumps, statistics of the surface.
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
    std::vector<RunFigure> figures(const std::optional<SurfaceStatistics>& surface) const;

private:
    const Case& case_;
    std::optional<ContactForces> closest_;
    double largestContact_ = 0.0;                           // [N]
    std::optional<double> strongestPull_, strongestPullAt_; // net force on the way out [N], [m]
    std::vector<ContactJump> jumps_;
};

} // namespace touchdown
