// SPDX-License-Identifier: GPL-3.0-or-later
//
// Film, contact and slider in time, as CSV: what a simulated millisecond costs, which part takes it, and by how much a
// run differs from the same one with a tenth of its step error. A slider that bounces forgets its start, and such a
// difference then grows to the size of the motion whatever the step: errors tell of runs, or of their first part, that
// do not bounce.
//
// Times are those of one thread after the static state was found. Shares are of the wall clock: on a machine that
// others load too, compare processor times and counts alone.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

/// Names of sample cases or files, and settings key=value for all of them; without any name our free sliders after a
/// kick, and a contact under each kind of film case there is. Returns an exit code.
int benchmarkCoupled(const std::vector<std::string>& casesAndSettings);

} // namespace touchdown
