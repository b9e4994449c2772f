// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run of the film does not know of the damping of its motion: because of its cells, or because of its steps.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct Case;
struct Peak;

/// The accepted steps of a run that were not exact for oscillations (numerics/backward_difference.h).
struct UnfittedSteps {
    long long count = 0;
    double time = 0.0; // all together [s]
};

/// Sentences about the fastest of the larger peaks, up to `resolved` [Hz] the cells know its damping; `duration` of the
/// run [s].
std::vector<std::string> doubtsOnDamping(const Case& c, const std::vector<Peak>& peaks, double resolved,
                                         const UnfittedSteps& unfitted, double duration);

} // namespace touchdown
