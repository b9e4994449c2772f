// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/followed_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace touchdown {

namespace {

constexpr double shortestStep = 1e-6;        // of the frequency [-]
constexpr double longestStep = 1e-2;         // of the frequency [-]
constexpr double longestOfBeat = 1.0 / 24.0; // of the beat of the waves under both air springs [-]
constexpr double firstShare = 1.0 / 16.0;    // of the longest step [-]
constexpr double longer = 2.0;               // the next step after one that is accepted [-]
constexpr double shorter = 0.5;              // and after one that is not [-]
constexpr double farEnough = 0.1;            // of a step, for the line through two motions [-]
constexpr double closelyFound = 0.05;        // distance from the prediction, in sizes of the motion [-]
constexpr double roughAbove = 1e-4;          // of the frequency: longer steps are rough [-]
constexpr int mostNewtonSteps = 5;           // from a prediction
constexpr double newtonReach = 0.2;          // of its way from the prediction, in the same [-]

double longestAt(const ResponseTask& task, double frequency)
{
    const double byFrequency = longestStep * frequency;
    return task.beat > 0.0 ? std::min(byFrequency, longestOfBeat * task.beat) : byFrequency;
}

} // namespace

FollowedMotion::FollowedMotion(const ResponseTask& task, const ForcedMotion& begin)
    : task_(task), step_(firstShare * longestAt(task, begin.frequency))
{
    at_.frequency = begin.frequency;
    at_.motion = {begin.end, begin.period, begin.multiplier.value_or(0.0), begin.size};
}

bool FollowedMotion::to(double target)
{
    while (at_.frequency != target) {
        const double left = target - at_.frequency, h = std::min(std::abs(left), step_);
        const double next = h < std::abs(left) ? at_.frequency + std::copysign(h, left) : target;
        const std::unique_ptr<ForcedSlider> slider = task_.sliderAt(next);
        ForcedState guess = at_.motion.at;
        if (before_)
            guess.y +=
                (guess.y - before_->motion.at.y) * ((next - at_.frequency) / (at_.frequency - before_->frequency));
        guess = slider->continued(guess);
        const auto near = [&](const ForcedState& start, bool rough) {
            return repeatingNear(*slider, start, at_.motion.period, at_.motion.size,
                                 {.reach = newtonReach, .mostSteps = mostNewtonSteps, .rough = rough},
                                 task_.settle.goOn);
        };
        const bool rough = h > roughAbove * next;
        std::optional<RepeatingMotion> found = near(guess, rough);
        if (found && rough && next == target) found = near(found->at, false);
        if (found && apart(found->at, guess, found->size) <= closelyFound) {
            if (!before_ || h > farEnough * step_) before_ = at_;
            at_ = {next, *found};
            step_ = std::min(longer * std::max(h, step_), longestAt(task_, next));
            continue;
        }
        beyond_ = next;
        step_ = shorter * h;
        if (h <= shortestStep * at_.frequency || (task_.settle.goOn && !task_.settle.goOn())) return false;
    }
    return true;
}

ForcedMotion FollowedMotion::motion() const
{
    ForcedMotion motion = measured(*task_.sliderAt(at_.frequency), at_.motion);
    motion.frequency = at_.frequency; // without the round-off of its period
    return motion;
}

} // namespace touchdown
