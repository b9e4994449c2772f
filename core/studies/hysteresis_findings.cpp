// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/simulation/units.h"
#include "core/studies/few_digits.h"
#include "core/studies/hysteresis_result.h"
#include "core/studies/value_ranges.h"

namespace touchdown {

namespace {

bool ended(const HeldStep& step) { return step.done && step.end.kind != EndKind::Failed; }

std::string counted(std::ptrdiff_t count, const char* one, const char* several)
{
    return std::to_string(count) + " " + (count == 1 ? one : several);
}

/// Self-excited or forced: what the equilibria say.
class EquilibriumFindings {
public:
    EquilibriumFindings(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings)
        : task_(task), result_(result), text_(parameterText(task.parameter)), findings_(findings)
    {
    }

    void addAnswer()
    {
        const auto where = [&](auto&& isSo) { return rangesAlong(result_.lines, isSo); };
        const auto is = [&](Stability stability) {
            return where([=](const StudiedEquilibrium& at) { return at.stability == stability; });
        };
        const auto flutter = where([&](const StudiedEquilibrium& at) {
            return at.stability == Stability::Flutter && !result_.doubtful(at);
        });
        const auto doubtful = where([&](const StudiedEquilibrium& at) { return result_.doubtful(at); });
        const auto incomplete = where([](const StudiedEquilibrium& at) { return at.incomplete(); });
        const auto divergence = is(Stability::Divergence), neutral = is(Stability::Neutral);
        if (!flutter.empty()) addFlutter(flutter);
        if (!doubtful.empty())
            say("Not known on this grid: " + of(doubtful) + " an equilibrium seems unstable by an oscillation above " +
                fewDigits(result_.resolved, "kHz") + ", where the grid gives damping a wrong sign; a finer grid tells");
        if (!incomplete.empty())
            say("Not known: " + of(incomplete) +
                " an oscillation about an equilibrium could not be followed, or is damped so much that it is none");
        const bool missing = addMissing();
        if (flutter.empty() && !missing && neutral.empty() && doubtful.empty() && incomplete.empty()) addForced(divergence);
        else if (!neutral.empty())
            say(of(neutral, true) + " an equilibrium is neutral: its oscillations neither grow nor fade, since nothing damps them");
        if (const auto bounces = bouncing(); !bounces.empty())
            say("In and out of contact to the end: " + counted(std::ptrdiff_t(bounces.size()), "run", "runs") + " of " +
                std::to_string(validEnds()) + " (" + text(rangesAmong(task_.values, bounces), text_) + ")");
    }

    void addCoexistence()
    {
        const std::vector<ValueRange> several = coexistence(result_.lines);
        if (!several.empty())
            say(belongsToStart(task_.parameter.key)
                    ? "More than one equilibrium is stable: which one the slider comes to rest in depends on the start"
                    : "More than one equilibrium is stable " + of(several) + ": which one the slider comes to rest in depends on the way there");
    }

    /// The held states against the equilibria, two ways to the same.
    void addAgreement()
    {
        constexpr double told = 1e-12; // [m]
        std::ptrdiff_t compared = 0;
        double farthest = 0.0;
        for (const HeldStep& step : result_.steps) {
            if (!step.done || (step.end.kind != EndKind::Flying && step.end.kind != EndKind::Contact) || !step.atRest()) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const EquilibriumAt& at : equilibriaAt(result_.lines, step.value))
                nearest = std::min(nearest, std::abs(at.spacing - step.end.spacing));
            if (!std::isfinite(nearest)) continue;
            ++compared;
            farthest = std::max(farthest, nearest);
        }
        if (compared > 0)
            say("What came to rest, " + counted(compared, "run", "runs") + ", did so within " +
                fewDigits(std::max(farthest, told), "nm") + " of an equilibrium");
    }

private:
    void say(const std::string& sentence) { findings_.push_back(sentence + "."); }
    std::string of(const std::vector<ValueRange>& ranges, bool begins = false) const
    {
        std::string where = text(ranges, text_);
        if (begins) where[0] = where[0] == 'a' ? 'A' : where[0] == 'i' ? 'I' : 'F';
        return where;
    }
    std::string inRange() const { return "from " + text_.of(task_.values.front()) + " to " + text_.of(task_.values.back()); }

    std::vector<double> bouncing() const
    {
        std::vector<double> values;
        for (const HeldStep& step : result_.steps)
            if (step.done && step.end.kind == EndKind::Intermittent) values.push_back(step.value);
        return values;
    }
    std::ptrdiff_t validEnds() const { return std::ranges::count_if(result_.steps, ended); }

    /// Values without an equilibrium: sought in vain while the slider bounces, or while it does not, or not sought to the end. True where
    /// there are any.
    bool addMissing()
    {
        const std::vector<double> bounces = bouncing();
        std::vector<double> excited, quiet, unsought;
        for (const double value : task_.values) {
            const auto within = [](const EquilibriumAt& at) { return !at.outside; };
            if (std::ranges::any_of(equilibriaAt(result_.lines, value), within)) continue;
            const bool bounced = std::ranges::find(bounces, value) != bounces.end();
            (result_.unsought ? unsought : bounced ? excited : quiet).push_back(value);
        }
        const auto where = [&](const std::vector<double>& values, bool begins = false) {
            return of(rangesAmong(task_.values, values), begins);
        };
        if (!excited.empty())
            say("Self-excited: " + where(excited) +
                " the slider ends in and out of contact, and no equilibrium was found for it to come to rest in");
        if (!quiet.empty())
            say(where(quiet, true) + " no equilibrium was found, and no run ends in and out of contact; one may have been missed");
        if (!unsought.empty()) say("Not known: " + where(unsought) + " the search for equilibria did not come to its end");
        return !excited.empty() || !quiet.empty() || !unsought.empty();
    }

    void addForced(const std::vector<ValueRange>& divergence)
    {
        std::string sentence = "Forced, as far as small motions tell: ";
        sentence += divergence.empty() ? "all equilibria " + inRange() + " are stable, and there is no Hopf point"
                                       : "no equilibrium " + inRange() + " loses its stability by an oscillation, and those that are unstable (" +
                                             of(divergence) + ") are left without oscillating";
        sentence += ". Bouncing that lasts must be forced from outside, or be a cycle far from any equilibrium";
        double slowest = -std::numeric_limits<double>::infinity();
        for (const EquilibriumLine& line : result_.lines)
            for (const StudiedEquilibrium& at : line.points)
                if (!line.outside) slowest = std::max(slowest, at.growth().value_or(slowest));
        if (divergence.empty() && slowest < 0.0)
            sentence += ". The slowest disturbance fades by a factor of e within " + fewDigitsOfTime(-1.0 / slowest);
        say(sentence);
        if (bouncing().empty() && validEnds() > 0)
            say(validEnds() == 1 ? "No such cycle was seen: the run does not end in and out of contact"
                                 : "No such cycle was seen: none of the " + std::to_string(validEnds()) + " runs ends in and out of contact");
    }

    void addFlutter(const std::vector<ValueRange>& flutter)
    {
        std::string sentence = "Self-excited: an equilibrium is unstable by an oscillation that grows, " + of(flutter), points;
        int count = 0;
        for (const StudiedMark& mark : result_.marks) {
            // What diverges there was unstable before, and is after.
            if (mark.kind != EquilibriumMark::Hopf || mark.outside || mark.at.stability == Stability::Divergence) continue;
            double frequency = 0.0, least = std::numeric_limits<double>::infinity();
            for (const std::complex<double>& value : mark.at.eigenvalues) {
                if (value.imag() == 0.0 || std::abs(value.real()) > least) continue;
                least = std::abs(value.real());
                frequency = std::abs(value.imag()) / (2.0 * std::numbers::pi);
            }
            ++count;
            points += (points.empty() ? "" : ", ") + text_.of(mark.at.value) + " (" + fewDigits(mark.at.spacing, "nm", 3) + " spacing, " +
                      fewDigits(frequency, "kHz", 3) + ")";
        }
        if (count > 0) sentence += std::string(count == 1 ? "; Hopf point at " : "; Hopf points at ") + points;
        say(sentence);
    }

    const HeldSteps& task_;
    const HysteresisResult& result_;
    ParameterText text_;
    std::vector<std::string>& findings_;
};

/// Touch-down, take-off and the loop: what the runs show.
class RunFindings {
public:
    RunFindings(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings)
        : task_(task), result_(result), text_(parameterText(task.parameter)), findings_(findings)
    {
    }

    void addTransitions()
    {
        const std::vector<Transition> transitions = transitionsOf(result_.steps);
        for (const Transition& each : transitions)
            say(std::string(each.down ? "Touch-down" : "Take-off") + " at " + text_.of(each.middle()) + " +- " +
                fewDigits(0.5 * std::abs(each.after - each.before), text_.displayUnit) + ", " +
                (each.after > each.before ? "rising" : "falling") + equilibriumEnd(each));
        const auto first = std::ranges::find_if(result_.steps, ended);
        if (first == result_.steps.end()) return;
        const auto last = std::ranges::find_if(result_.steps.rbegin(), result_.steps.rend(), ended);
        const bool flies = last->end.kind == EndKind::Flying;
        const std::string ways = "from " + text_.of(task_.values.front()) + " to " + text_.of(task_.values.back()) + " and back";
        if (transitions.empty()) say(seenThroughout(flies) + " at every value " + ways + throughout(flies));
        else if (transitions.size() == 1)
            say(std::string("From there on the slider ") + (flies ? "flies" : "stays in contact") + ": on the way back, to " +
                text_.of(task_.values.front()) + ", " + (flies ? "it does not touch down again" : "it does not take off again"));
    }

    void addEndStates()
    {
        std::vector<double> flying, contact;
        for (const HeldStep& step : result_.steps)
            if (ended(step)) (step.end.kind == EndKind::Flying ? flying : contact).push_back(step.value);
        const auto all = std::ssize(flying) + std::ssize(contact);
        if (all == 0) return;
        const std::string begins = "Begun anew at each value the slider ends ";
        const auto where = [&](const std::vector<double>& values) { return " (" + text(rangesAmong(task_.values, values), text_) + ")"; };
        if (flying.empty() || contact.empty())
            say(begins + (flying.empty() ? "touching the disk" : "flying") + " in " +
                (all == 1 ? "its one run" : "all " + std::to_string(all) + " runs"));
        else
            say(begins + "flying in " + std::to_string(flying.size()) + " of " + std::to_string(all) + " runs" + where(flying) +
                ", touching the disk in " + std::to_string(contact.size()) + where(contact));
    }

    void addLoop()
    {
        const LoopOf loop = loopOf(result_.steps);
        if (loop.known == 0) return;
        if (loop.values.empty()) {
            say("No hysteresis: there and back the slider ends in the same states" + std::string(loop.whole ? "" : ", where both are known"));
            return;
        }
        const bool plain = text_.displayUnit.empty() || text_.displayUnit == "1";
        const std::string unit = plain ? " nm" : text_.displayUnit == "nm" ? " nm^2" : " nm " + text_.displayUnit;
        const double factor = plain ? 1.0 : unitFactor(text_.displayUnit);
        const bool lag = loop.moving == loop.values.size();
        std::string sentence = std::string(lag ? "Hysteresis or a lag " : "Hysteresis ") + text(rangesAmong(task_.values, loop.values), text_) +
                               ": there and back the slider ends in different states";
        if (loop.moving > 0)
            sentence += ", but " +
                        (lag ? std::string("at none of these values have both come to rest")
                             : "at " + std::to_string(loop.moving) + " of these " + std::to_string(loop.values.size()) +
                                   " values not both have come to rest") +
                        ": a longer hold tells hysteresis from a lag";
        say(sentence + ". The mean spacing runs round an area of " + fewDigits(loop.area / (1e-9 * factor), "", 3) + unit +
            (loop.whole ? "" : ", without the values at which a run failed"));
    }

    void addUnsettled()
    {
        const auto count = std::ranges::count_if(result_.steps, stillMoves);
        if (count > 0)
            say(counted(count, "run still moves", "runs still move") + " by more than 0.1 nm at the end of " + fewDigitsOfTime(task_.hold, 3) +
                "; a longer hold tells more");
    }

    void addFailures()
    {
        std::vector<double> values;
        std::string problem;
        for (const HeldStep& step : result_.steps) {
            if (!step.done || step.problem.empty() || step.end.kind != EndKind::Failed) continue;
            values.push_back(step.value);
            if (problem.empty()) problem = step.problem;
        }
        if (values.empty()) return;
        say("Without a valid end: " + text(rangesAmong(task_.values, values), text_) +
            (task_.fresh ? "" : "; the run after each begins anew") + ". The first one tells why: " + problem);
    }

private:
    void say(const std::string& sentence) { findings_.push_back(sentence + "."); }

    /// Of runs that all end flying, or all touching.
    std::string seenThroughout(bool flying) const
    {
        const auto all = [&](EndKind kind) {
            return std::ranges::none_of(result_.steps, [&](const HeldStep& step) { return ended(step) && step.end.kind != kind; });
        };
        if (flying) return "The slider flies";
        return all(EndKind::Intermittent) ? "The slider goes in and out of contact"
                                          : all(EndKind::Contact) ? "The slider is in contact" : "The slider touches the disk, some of the time or all of it,";
    }
    static std::string throughout(bool flying)
    {
        return flying ? ": no touch-down was seen" : ", which it came to from its start at the first one; no take-off was seen";
    }

    /// Where the branch that was left ends: within the step, or beyond it where the step itself set the slider swinging.
    std::string equilibriumEnd(const Transition& each) const
    {
        const double slack = 1e-6 * std::abs(each.after - each.before); // rounding of the held values
        const double low = std::min(each.before, each.after) - slack, high = std::max(each.before, each.after) + slack;
        const std::string left = each.down ? "; the flying equilibrium" : "; the equilibrium in contact";
        std::string beyond;
        for (const StudiedMark& mark : result_.marks) {
            if (mark.kind == EquilibriumMark::Kink || mark.kind == EquilibriumMark::Hopf || mark.outside) continue;
            if (mark.kind == EquilibriumMark::Switch && mark.name != (each.down ? "touch-down" : "take-off")) continue;
            // A fold of another branch may lie in the same step: the one that was left folds nearer to the state left.
            if (mark.kind == EquilibriumMark::Fold &&
                std::abs(mark.at.spacing - each.left) >= std::abs(mark.at.spacing - each.reached))
                continue;
            if (mark.at.value >= low && mark.at.value <= high) return left + " ends at " + text_.of(mark.at.value);
            if (mark.kind == EquilibriumMark::Switch && (mark.at.value - each.after) * (each.after - each.before) > 0.0)
                beyond = left + " ends only at " + text_.of(mark.at.value) + ": " + reasonToLeaveEarly(each, mark.at.value);
        }
        return beyond;
    }

    /// A branch may have lost its stability before it ends.
    std::string reasonToLeaveEarly(const Transition& each, double end) const
    {
        for (const EquilibriumLine& line : result_.lines)
            for (const StudiedEquilibrium& at : line.points) {
                const bool between = (at.value - each.before) * (end - at.value) >= 0.0;
                if (line.outside || (line.state == "flying") != each.down || !between) continue;
                if (at.stability == Stability::Flutter && !result_.doubtful(at)) return "on the way there it is unstable";
            }
        return "the step set the slider swinging, and smaller steps come closer";
    }

    const HeldSteps& task_;
    const HysteresisResult& result_;
    ParameterText text_;
    std::vector<std::string>& findings_;
};

} // namespace

std::vector<std::string> hysteresisFindings(const HeldSteps& task, const HysteresisResult& result)
{
    std::vector<std::string> findings;
    EquilibriumFindings equilibria(task, result, findings);
    RunFindings runs(task, result, findings);
    if (result.traced) equilibria.addAnswer();
    if (task.fresh) runs.addEndStates();
    else {
        runs.addTransitions();
        runs.addLoop();
    }
    if (result.traced) {
        equilibria.addCoexistence();
        equilibria.addAgreement();
    }
    runs.addUnsettled();
    runs.addFailures();
    return findings;
}

} // namespace touchdown
