// SPDX-License-Identifier: GPL-3.0-or-later
//
// The findings of a study of forced motion in sentences: jumps with two states between, the largest amplitude, contact,
// periods, and where the motion did not settle.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/response/response_report.h"
#include "core/studies/response/response_sweep.h"

namespace touchdown {

namespace {

constexpr double touchesAll = 0.999;  // of the time [-]
constexpr double littleChange = 0.05; // of an amplitude [-]
constexpr std::size_t mostNamedJumps = 3;

using IsSo = std::function<bool(const ForcedMotion&)>;

/// "up from 3 kHz to 5 kHz, down at 4 kHz"; "" where no motion is so.
std::string whereOnWays(const ResponseResult& result, const IsSo& isSo)
{
    std::string both;
    std::vector<std::string> ways;
    for (const bool down : {false, true}) {
        std::vector<double> all, chosen;
        for (const ResponsePoint& point : result.points) {
            if (point.down != down || !point.done) continue;
            all.push_back(point.motion.frequency);
            if (isSo(point.motion)) chosen.push_back(point.motion.frequency);
        }
        ways.push_back(text(rangesAmong(all, chosen), frequencyText()));
    }
    if (ways[0] == ways[1]) return ways[0];
    for (std::size_t k = 0; k < ways.size(); ++k)
        if (!ways[k].empty()) both += (both.empty() ? "" : "; ") + std::string(k == 0 ? "up " : "down ") + ways[k];
    return both;
}

class ResponseFindings {
public:
    ResponseFindings(const ResponseTask& task, const ResponseResult& result) : task_(task), result_(result) {}

    std::vector<std::string> all()
    {
        addJumps();
        addOthers();
        addLargest();
        addPeriods();
        addContact();
        return std::move(findings_);
    }

private:
    std::string amount(double value) const { return fewDigits(value, task_.quantity.displayUnit, 3); }
    /// The largest amplitude is one of settled motions; a motion about to jump may be larger.
    std::string amount(const ForcedMotion& motion) const
    {
        return amount(motion.amplitude()) + (motion.settled() ? "" : " (not settled)");
    }

    std::string jumpText(const ResponseJump& jump) const
    {
        const std::string way = jump.down ? "down: " : "up: ", at = " at " + frequencyText().of(jump.frequency());
        const double before = jump.before.amplitude(), after = jump.after.amplitude();
        if (std::abs(after - before) > littleChange * std::max(before, after))
            return way + (after < before ? "falls from " : "rises from ") + amount(jump.before) + " to " +
                   amount(jump.after) + at;
        if (jump.after.period != jump.before.period)
            return way + "the motion repeats after " + counted(std::size_t(jump.before.period), "period") + " before " +
                   frequencyText().of(jump.frequency()) + " and after " + std::to_string(jump.after.period) +
                   " beyond it";
        return way + "the motion changes with little change of its amplitude of " + amount(before) + at;
    }

    void addJumps()
    {
        const auto ranges = twoStates(result_);
        std::vector<const ResponseJump*> named;
        for (const auto& [first, last] : ranges) {
            std::vector<std::string> parts;
            double lower = task_.frequencies[first], upper = task_.frequencies[last]; // of the two states
            const auto name = [&](const ResponseJump* jump, double& end) {
                if (jump == nullptr) return;
                named.push_back(jump);
                parts.push_back(jumpText(*jump));
                end = jump->frequency();
            };
            if (last + 1 < task_.frequencies.size()) name(jumpBetween(task_, result_, last, last + 1, false), upper);
            if (first > 0) name(jumpBetween(task_, result_, first, first - 1, true), lower);
            const auto end = [&](double frequency) {
                return frequencyText().of(frequency) + (frequency == task_.frequencies.front()  ? ", the lowest one,"
                                                        : frequency == task_.frequencies.back() ? ", the highest one"
                                                                                                : "");
            };
            const std::string states = "two states between " + end(lower) + " and " + end(upper) + ".";
            findings_.push_back(capitalized(parts.empty() ? states : joined(parts, "; ") + ": " + states));
        }
        std::vector<std::string> further;
        for (const ResponseJump& jump : result_.jumps)
            if (jump.other == 0 && std::ranges::find(named, &jump) == named.end()) further.push_back(jumpText(jump));
        if (further.size() > mostNamedJumps) {
            const std::string more = counted(further.size() - mostNamedJumps, "further jump");
            further.resize(mostNamedJumps);
            further.push_back(more + " in the table");
        }
        if (!further.empty()) findings_.push_back(capitalized(joined(further, "; ")) + ".");
        const auto isSettled = [](const ResponsePoint& point) { return point.motion.settled(); };
        if (ranges.empty() && further.empty() && std::ranges::all_of(result_.points, isSettled))
            findings_.push_back("Up and down agree at all " + std::to_string(task_.frequencies.size()) +
                                " frequencies, without a jump.");
    }

    /// What was looked for, and what was found.
    void addOthers()
    {
        if (result_.starts == 0) {
            findings_.push_back("Other motions were not looked for.");
            return;
        }
        std::array<int, 3> kinds{}; // by StartKind
        for (int start = 0; start < result_.starts; ++start) ++kinds[std::size_t(kindOfStart(task_, start))];
        std::string starts = counted(std::size_t(result_.starts), "other start") + " (" + std::to_string(kinds[0]) +
                             " at rest, " + (kinds[1] > 0 ? std::to_string(kinds[1]) + " where contact begins, " : "") +
                             std::to_string(kinds[2]) + " drawn), spread over the frequencies";
        if (result_.unsettled > 0) starts += ", of which " + std::to_string(result_.unsettled) + " did not settle";
        const std::size_t found = result_.others.size();
        findings_.push_back(found == 0 ? "No other motion was found from " + starts + "."
                                       : (found == mostOthers ? "At least " : "") + counted(found, "other motion") +
                                             (found == 1 ? " was" : " were") + " found from " + starts + ".");
        for (std::size_t k = 0; k < found; ++k) findings_.push_back(otherText(k));
    }

    std::string otherText(std::size_t k) const
    {
        const OtherMotion& other = result_.others[k];
        double lower = other.motions.front().frequency, upper = other.motions.back().frequency;
        for (const ResponseJump& jump : result_.jumps)
            if (jump.other == int(k) + 1) (jump.down ? lower : upper) = jump.frequency();
        const auto [least, most] = std::ranges::minmax(other.motions, {}, &ForcedMotion::amplitude);
        const auto [rarest, longest] = std::ranges::minmax(other.motions, {}, &ForcedMotion::contactShare);
        const auto fromTo = [](const std::string& from, const std::string& to) {
            return from == to ? from : from + " to " + to;
        };
        std::string contact = "without contact";
        if (longest.contactShare > 0.0)
            contact = "in contact " +
                      fromTo(fewDigits(rarest.contactShare, "%"), fewDigits(longest.contactShare, "%")) +
                      " of the time";
        return "Other motion " + std::to_string(k + 1) + ", reached from " +
               counted(std::size_t(other.starts), "start") + ", " + text({{lower, upper}}, frequencyText()) +
               ": repeats after " + counted(std::size_t(other.motions.front().period), "period") +
               " of the forcing, amplitude " + fromTo(amount(least.amplitude()), amount(most.amplitude())) + ", " +
               contact + ".";
    }

    void addLargest()
    {
        const ForcedMotion* largest = nullptr;
        const auto consider = [&](const ForcedMotion& motion) {
            if (motion.settled() && (largest == nullptr || motion.amplitude() > largest->amplitude()))
                largest = &motion;
        };
        for (const ResponsePoint& point : result_.points) consider(point.motion);
        for (const OtherMotion& other : result_.others)
            for (const ForcedMotion& motion : other.motions) consider(motion);
        for (const ResponseJump& jump : result_.jumps) {
            consider(jump.before);
            consider(jump.after);
        }
        if (largest == nullptr) return;
        std::string sentence = "Largest amplitude of the " + readableName(task_.quantity) + ": " +
                               amount(largest->amplitude()) + " at " + frequencyText().of(largest->frequency) +
                               ", phase " + fewDigits(phaseTurnOf(result_).of(largest->harmonic), "deg", 3);
        double linear = 0.0, at = 0.0;
        for (std::size_t i = 0; i < result_.linear.size(); ++i)
            if (result_.linear[i] && std::abs(*result_.linear[i]) > linear) {
                linear = std::abs(*result_.linear[i]);
                at = task_.frequencies[i];
            }
        if (linear > 0.0) sentence += "; of small motions: " + amount(linear) + " at " + frequencyText().of(at);
        findings_.push_back(sentence + ".");
    }

    void addPeriods()
    {
        for (int n = 2; n <= task_.settle.longestPeriod; ++n)
            add("The motion repeats after " + std::to_string(n) + " periods of the forcing ", "",
                [n](const ForcedMotion& motion) { return motion.period == n; });
        add("Not settled ",
            ": within " + std::to_string(task_.settle.mostPeriods) +
                " periods of the forcing the motion does not repeat after up to " +
                std::to_string(task_.settle.longestPeriod) +
                " of them. Amplitude and phase are those of its last periods",
            [](const ForcedMotion& motion) { return motion.valid() && !motion.settled(); });
    }

    void addContact()
    {
        add("In and out of contact ", "", [](const ForcedMotion& motion) {
            return motion.valid() && motion.contactShare > 0.0 && motion.contactShare < touchesAll;
        });
        add("Stays in contact ", "",
            [](const ForcedMotion& motion) { return motion.valid() && motion.contactShare >= touchesAll; });
    }

    void add(const std::string& before, const std::string& after, const IsSo& isSo)
    {
        const std::string where = whereOnWays(result_, isSo);
        if (!where.empty()) findings_.push_back(before + where + after + ".");
    }

    const ResponseTask& task_;
    const ResponseResult& result_;
    std::vector<std::string> findings_;
};

} // namespace

std::vector<std::string> responseFindings(const ResponseTask& task, const ResponseResult& result)
{
    return ResponseFindings(task, result).all();
}

} // namespace touchdown
