// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "core/studies/response/followed_motion.h"

namespace touchdown {

namespace {

constexpr double littleBeyond = 3e-4; // an end, of its frequency [-]
constexpr int mostEnds = 8;           // between two frequencies
constexpr std::uint64_t seedOfStarts = 1;
constexpr double furthestStart = 30.0; // in amplitudes of the wave [-]
constexpr double beyondContact = 2.0;  // in distances of the contact [-]

/// A settled motion that is followed from one frequency of the sweep to the next, over its ends.
class FollowedWay {
public:
    FollowedWay(const ResponseTask& task, const ForcedMotion& begin, bool down, int other)
        : task_(task), motion_(begin), down_(down), other_(other)
    {
        way_.emplace(task, begin);
    }

    /// The motion at the next frequency [Hz].
    const ForcedMotion& to(double frequency, std::vector<ResponseJump>& jumps, bool overJumps = true)
    {
        for (int ends = 0; ends < mostEnds; ++ends) {
            if (way_->to(frequency)) return motion_ = way_->motion();
            const ForcedMotion before = way_->motion();
            const double end = way_->beyond();
            const double left = frequency - end,
                         little = end + std::copysign(std::min(littleBeyond * end, std::abs(left)), left);
            ForcedMotion after = settled(before.end, little);
            const bool atOnce = after.settled() || little == frequency;
            if (!atOnce && !stopped()) after = settled(before.end, frequency);
            if (stopped()) return motion_ = std::move(after);
            jumped_ = true;
            if (after.settled()) {
                FollowedMotion back(task_, after);
                const bool reaches = back.to(before.frequency);
                const ForcedMotion there = back.motion();
                jumped_ = !reaches || !continuous(before, there);
                // Else there are frequencies between at which it does not settle.
                if (jumped_ && (reaches || atOnce)) jumps.push_back({down_, other_, before, there, end});
            }
            motion_ = std::move(after);
            if (!motion_.settled() || (jumped_ && !overJumps)) return motion_;
            way_.emplace(task_, motion_);
        }
        motion_ = settled(motion_.end, frequency);
        if (motion_.settled()) way_.emplace(task_, motion_);
        return motion_;
    }
    bool jumped() const { return jumped_; } // or has not settled after an end

private:
    bool stopped() const { return task_.settle.goOn && !task_.settle.goOn(); }
    ForcedMotion settled(const ForcedState& start, double frequency) const
    {
        ForcedMotion motion = settledMotion(*task_.sliderAt(frequency), start, task_.settle);
        motion.frequency = frequency; // without the round-off of its period
        return motion;
    }
    /// The period may double or halve.
    static bool continuous(const ForcedMotion& before, const ForcedMotion& after)
    {
        ForcedMotion same = after;
        if (after.period == 2 * before.period || 2 * after.period == before.period) same.period = before.period;
        return sameMotion(before, same);
    }

    const ResponseTask& task_;
    ForcedMotion motion_;
    std::optional<FollowedMotion> way_;
    bool down_;
    int other_;
    bool jumped_ = false;
};

/// Whether a motion at the frequency of this place is on one of the ways or is one of the other motions; which one.
bool isOnAWay(const ResponseResult& result, std::size_t place, const ForcedMotion& motion)
{
    return sameMotion(motion, pointAt(result, place, false).motion) ||
           sameMotion(motion, pointAt(result, place, true).motion);
}
OtherMotion* otherAt(ResponseResult& result, std::size_t place, const ForcedMotion& motion)
{
    for (OtherMotion& other : result.others)
        if (const ForcedMotion* there = other.at(place); there != nullptr && sameMotion(motion, *there)) return &other;
    return nullptr;
}

/// The state at the beginning of a period from which a start begins.
ForcedState stateOfStart(const ResponseTask& task, const ForcedSlider& slider, int start)
{
    const StartKind kind = kindOfStart(task, start);
    if (kind == StartKind::AtRest) return slider.lowered(0.0);
    const double toContact = task.toContact.value_or(0.0); // [m]
    if (kind == StartKind::AtContact) return slider.lowered(toContact);
    std::mt19937_64 engine(seedOfStarts + std::uint64_t(start));
    // Both by hand: the distributions of the standard library differ between its implementations.
    const auto share = [&] { return (double(engine() >> 11) + 0.5) * 0x1p-53; };
    Eigen::VectorXd direction(2 * slider.positions());
    do {
        for (double& each : direction) each = 2.0 * share() - 1.0;
    } while (direction.norm() > 1.0 || direction.norm() < 0.1);
    double furthest = furthestStart * task.amplitude;
    if (task.toContact) furthest = std::max(furthest, beyondContact * toContact);
    return slider.moved(direction.normalized(), task.amplitude * std::pow(furthest / task.amplitude, share()));
}

} // namespace

std::vector<ResponseJump> sweepBothWays(const ResponseTask& task, const PointDone& done)
{
    const auto goesOn = [&] { return !task.settle.goOn || task.settle.goOn(); };
    const std::size_t count = task.frequencies.size();
    std::vector<ResponseJump> jumps;
    std::optional<ForcedMotion> last;
    std::optional<FollowedWay> way; // of the last motion, where it has settled
    for (std::size_t i = 0; i < 2 * count && goesOn(); ++i) {
        ResponsePoint point;
        point.down = i >= count;
        const std::size_t place = point.down ? 2 * count - 1 - i : i;
        const double frequency = task.frequencies[place];
        const std::unique_ptr<ForcedSlider> slider = task.sliderAt(frequency);
        point.anew = i > 0 && !last;
        if (i == count && last && last->settled()) {
            point.motion = *last;
            way.emplace(task, *last, true, 0);
        } else if (way) {
            point.motion = way->to(frequency, jumps);
            if (!point.motion.settled()) way.reset();
        } else {
            point.motion = settledMotion(*slider, last ? last->end : slider->start(), task.settle);
            point.motion.frequency = frequency; // without the round-off of its period
            if (point.motion.settled()) way.emplace(task, point.motion, point.down, 0);
        }
        if (!goesOn()) break;
        last = point.motion.valid() ? std::optional(point.motion) : std::nullopt;
        if (!last) way.reset();
        point.done = true;
        done(i, point, point.down ? std::nullopt : slider->linear());
    }
    return jumps;
}

StartKind kindOfStart(const ResponseTask& task, int start)
{
    if (start % 4 == 0) return StartKind::AtRest;
    return start % 4 == 2 && task.toContact ? StartKind::AtContact : StartKind::Drawn;
}

std::size_t placeOfStart(const ResponseTask& task, int start)
{
    return std::size_t(start) * task.frequencies.size() / std::size_t(task.starts);
}

ForcedMotion motionOfStart(const ResponseTask& task, int start)
{
    const double frequency = task.frequencies[placeOfStart(task, start)];
    const std::unique_ptr<ForcedSlider> slider = task.sliderAt(frequency);
    ForcedMotion motion = settledMotion(*slider, stateOfStart(task, *slider, start), task.settle);
    motion.frequency = frequency;
    return motion;
}

void addOthers(const ResponseTask& task, const std::vector<ForcedMotion>& ofStarts, ResponseResult& result)
{
    const std::size_t count = task.frequencies.size();
    for (std::size_t start = 0; start < ofStarts.size(); ++start) {
        const ForcedMotion& motion = ofStarts[start];
        const std::size_t place = placeOfStart(task, int(start));
        ++result.starts;
        result.unsettled += motion.settled() ? 0 : 1;
        if (!motion.settled() || isOnAWay(result, place, motion)) continue;
        if (OtherMotion* known = otherAt(result, place, motion)) {
            ++known->starts;
            continue;
        }
        if (result.others.size() == mostOthers) continue;
        OtherMotion other{place, {motion}, 1};
        for (const bool down : {false, true}) {
            FollowedWay way(task, motion, down, int(result.others.size()) + 1);
            for (std::size_t next = place; down ? next > 0 : next + 1 < count;) {
                next = down ? next - 1 : next + 1;
                const ForcedMotion there = way.to(task.frequencies[next], result.jumps, false);
                if (way.jumped() || !there.settled() || isOnAWay(result, next, there) ||
                    otherAt(result, next, there) != nullptr)
                    break;
                other.motions.insert(down ? other.motions.begin() : other.motions.end(), there);
                if (down) --other.first;
            }
        }
        result.others.push_back(std::move(other));
    }
}

} // namespace touchdown
