// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchdown {

struct Case;

/// The time that a run in time of a case takes, relative to other runs: right-hand sides times the size of the model.
/// Steps of controlled length are estimated from their tolerance.
double expectedCost(const Case& c);

} // namespace touchdown
