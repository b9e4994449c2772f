// SPDX-License-Identifier: GPL-3.0-or-later
//
// The way of the pad of the model "contact": from approach.start to approach.closest and back at constant speed within
// run.duration.
#pragma once

#include <vector>

#include "core/case/case.h"

namespace touchdown {

/// The separation at a time of the run [m], and the time within the way in or out at which it is passed [s].
double padSeparation(const Case& c, double time);
double approachTime(const Case& c, double separation);
double retractionTime(const Case& c, double separation);

/// A time of the run at which a state is found.
struct PadStation {
    double time = 0.0; // [s]
    bool sample = false;
    bool snapshot = false;
};
/// The samples, and the closest approach where it is none of them.
std::vector<PadStation> padStations(const Case& c);

} // namespace touchdown
