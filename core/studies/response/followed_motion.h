// SPDX-License-Identifier: GPL-3.0-or-later
//
// A settled motion followed over the frequency to its end.
//
// Newton's method on P^n(y) - y = 0 (forced_motion.h) starts from the line through the last two motions. A step is
// accepted where it finds a stable motion within a twentieth of the size of the motion. The next step is then up to
// twice as long; after a step that is not accepted it is half as long. So the steps become short where the branch
// bends, and they do not depend on the frequencies of a sweep. The motion ends where steps of a millionth of the
// frequency fail: at a fold, where a multiplier leaves the unit circle, or where the motion begins to touch the disk
// or a contact ends. Beyond that frequency it is not found; the last one at which it was found is the other bound.
#pragma once

#include <optional>

#include "core/studies/response/response_result.h"

namespace touchdown {

class FollowedMotion {
public:
    /// A settled motion; the task must last.
    FollowedMotion(const ResponseTask& task, const ForcedMotion& begin);

    /// Follows it to this frequency [Hz]; false where it ends before, or is stopped.
    bool to(double frequency);

    double frequency() const { return at_.frequency; } // the last one at which it was found [Hz]
    double beyond() const { return beyond_; }          // after `to` has failed: where it was not found [Hz]
    /// With its figures there.
    ForcedMotion motion() const;

private:
    struct Place {
        double frequency = 0.0; // [Hz]
        RepeatingMotion motion;
    };

    const ResponseTask& task_;
    Place at_;
    std::optional<Place> before_;
    double step_;         // [Hz]
    double beyond_ = 0.0; // [Hz]
};

} // namespace touchdown
