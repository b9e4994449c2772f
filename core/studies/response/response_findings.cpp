// SPDX-License-Identifier: GPL-3.0-or-later
//
// The findings of a study of forced motion in sentences: jumps with two states between, the largest amplitude, contact,
// periods, and where the motion did not settle.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/response/response_report.h"

namespace touchdown {

namespace {

constexpr double touchesAll = 0.999;  // of the time [-]
constexpr double littleChange = 0.05; // of an amplitude [-]

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
        addLargest();
        addPeriods();
        addContact();
        return std::move(findings_);
    }

private:
    std::string amount(double value) const { return fewDigits(value, task_.quantity.displayUnit, 3); }

    std::string jumpText(const ResponseJump& jump) const
    {
        const std::string way = jump.down ? "down: " : "up: ", at = " at " + frequencyText().of(jump.frequency());
        const double larger = std::max(jump.left, jump.reached);
        if (std::abs(jump.reached - jump.left) > littleChange * larger)
            return way + (jump.reached < jump.left ? "falls from " : "rises from ") + amount(jump.left) + " to " +
                   amount(jump.reached) + at;
        if (jump.periodAfter == 0) return way + "no longer settles" + at;
        if (jump.periodAfter != jump.periodBefore)
            return way + "the period changes from " + std::to_string(jump.periodBefore) + " to " +
                   std::to_string(jump.periodAfter) + " periods of the forcing" + at;
        return way + "the motion changes with little change of its amplitude of " + amount(jump.left) + at;
    }

    void addJumps()
    {
        const auto ranges = twoStates(result_);
        for (const auto& [first, last] : ranges) {
            const double from = task_.frequencies[first], to = task_.frequencies[last];
            std::vector<std::string> parts;
            double lower = from, upper = to; // of the two states
            for (const bool down : {false, true}) {
                const auto ends = [&](const ResponseJump& jump) {
                    return jump.down == down &&
                           (down ? std::max(jump.before, jump.after) <= from : std::min(jump.before, jump.after) >= to);
                };
                // Jumps are in the order of their ranges: the nearest one belongs to this range.
                const ResponseJump* nearest = nullptr;
                for (const ResponseJump& jump : result_.jumps)
                    if (ends(jump) && (nearest == nullptr || std::abs(jump.frequency() - (down ? from : to)) <
                                                                 std::abs(nearest->frequency() - (down ? from : to))))
                        nearest = &jump;
                if (nearest != nullptr) parts.push_back(jumpText(*nearest));
                if (nearest != nullptr) (down ? lower : upper) = nearest->frequency();
            }
            if (first == 0) parts.push_back("down: no jump above " + frequencyText().of(from));
            findings_.push_back(capitalized(joined(parts, "; ")) + ": two states between " + frequencyText().of(lower) +
                                " and " + frequencyText().of(upper) + ".");
        }
        const auto isSettled = [](const ResponsePoint& point) { return point.motion.settled(); };
        if (ranges.empty() && std::ranges::all_of(result_.points, isSettled))
            findings_.push_back("Up and down agree at all " + std::to_string(task_.frequencies.size()) +
                                " frequencies: no jump, one state at each.");
    }

    void addLargest()
    {
        const ForcedMotion* largest = nullptr;
        for (const ResponsePoint& point : result_.points)
            if (point.motion.settled() && (largest == nullptr || point.motion.amplitude() > largest->amplitude()))
                largest = &point.motion;
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
