// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a run at one of its steps, from which the same program on the same machine continues it to the same
// bits.
#pragma once

#include <string>

namespace touchdown {

/// What a state consists of, as a number that changes with it.
inline constexpr int checkpointLayout = 2;

struct RunCheckpoint {
    double time = 0.0;    // reached [s]; all samples up to it were sent before
    bool extends = false; // nothing before it depends on run.duration: a longer run continues from it, too
    std::string state;    // bytes, see core/work/state_stream.h
};

} // namespace touchdown
