// SPDX-License-Identifier: GPL-3.0-or-later
//
// A disk whose surface reaches the slider of a film. Without a law of contact the film has no answer there, since air
// needs an open gap. The law of Ono and Yamane acts on the mean plane of the disk and does not see its surface.
#pragma once

#include <string>
#include <vector>

#include "core/physics/slider/disk_clearance.h"

namespace touchdown {

struct Case;

/// "the disk's surface reaches the slider at 12 ns: at x = 1.2 mm, y = 0.5 mm it is 15 nm above its mean plane and the
/// slider 14 nm; no law of contact acts there (contact = "none")". `place`: where the gap is least, not positive.
std::string diskReachesSlider(const Case& c, const DiskClearance::Place& place, double time);
/// "the disk's surface, 9.3 nm above its mean plane at x = ..., y = ..., is 0.2 nm below the slider".
std::string nearestDisk(const DiskClearance::Place& place);

/// What a static state with this minimum spacing [m], which is one above the mean plane, does not say of a disk that is
/// higher, where no law of contact acts; "" if there is nothing. Roughness counts as four times its RMS height.
std::string noteOnHighDisk(const Case& c, double minimumSpacing);

/// What a run of a valid case with the model "film" would find out about its disk at the start, without a solution.
struct DiskAtStart {
    std::string problem; // why it cannot start; "" if it may
    std::vector<std::string> warnings;
};
/// May generate the disk's roughness and read its file. Of a start from the static state the gap is not known: only the
/// cells under waves and bumps are checked.
DiskAtStart diskAtStart(const Case& c);

} // namespace touchdown
