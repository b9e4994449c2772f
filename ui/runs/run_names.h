// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of runs by what tells them from the others of the list: the name of the case where the cases have several
// titles, then what was changed, the rarest change first: "FH(0) 20 nm", "Fig. 12 (a), fₘ 10.7 mN". Numerics (step,
// grid, tolerance, length of a run) come last, and only where nothing else tells two runs apart. What all runs of one
// title share is not named. A run as it was opened has the value that the others changed, "FH(0) 250 nm", where they
// all changed the same, else the name of its case. A run alone has the name of its case and its changes.
#pragma once

#include <vector>

#include <QStringList>

namespace touchdown {

struct Case;

struct RunToName {
    int number = 0;
    const Case* value = nullptr;
    const Case* before = nullptr; // from which it was changed: as opened; may be `value` itself
};

constexpr qsizetype longestRunName = 76;
/// Two names differ within so many characters, and in a whole word there.
constexpr qsizetype earlyDifference = 24;

/// In the order of the runs. Two names that begin alike for too long begin with the number, "Run 5: ...". The name of a
/// case that was run before ends with it: "Fig. 10 (a), run 5".
QStringList runNames(const std::vector<RunToName>& runs);

} // namespace touchdown
