// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/simulation/run.h"

namespace touchdown {

/// What went wrong in a run, without where, when and what to do about it, so that runs which fail alike count as one:
/// "the rear air spring is lost for good". "" of a completed run.
std::string failureOf(const Summary& summary);

} // namespace touchdown
