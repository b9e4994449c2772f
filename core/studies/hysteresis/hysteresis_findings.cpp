// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/units.h"
#include "core/studies/hysteresis/hysteresis_answer.h"
#include "core/studies/hysteresis/value_ranges.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

/// Touch-down, take-off and the loop: what the runs show.
class RunFindings {
public:
    RunFindings(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings)
        : task_(task), result_(result), text_(parameterText(task.parameter)), findings_(findings)
    {}

    void addTransitions()
    {
        const std::vector<Transition> transitions = transitionsOf(result_.steps);
        for (const Transition& each : transitions)
            say(std::string(each.down ? "Touch-down" : "Take-off") + " at " + text_.of(each.middle()) + " +- " +
                fewDigits(0.5 * std::abs(each.after - each.before), text_.displayUnit) +
                (&each == &transitions.front() ? " of " + text_.inSentence() : "") + ", " +
                (each.after > each.before ? "rising" : "falling") + equilibriumEnd(each));
        const auto first = std::ranges::find_if(result_.steps, ended);
        if (first == result_.steps.end()) return;
        const auto last = std::ranges::find_if(result_.steps.rbegin(), result_.steps.rend(), ended);
        const bool flies = last->end.kind == EndKind::Flying;
        const bool whole = std::ranges::all_of(result_.steps, ended);
        const std::string ways =
            "from " + text_.of(task_.values.front()) + " to " + text_.of(task_.values.back()) + " and back";
        if (std::ranges::all_of(result_.steps,
                                [&](const HeldStep& step) { return !ended(step) || touches(step.end) != flies; }))
            say(seenThroughout(flies) + (whole ? " at every value " : " at every value with a valid end ") + ways +
                throughout(flies));
        else if (transitions.size() == 1 && flies != transitions.front().down)
            say(std::string("From there the slider ") +
                (flies                                ? "flies"
                 : last->end.kind == EndKind::Contact ? "stays in contact"
                                                      : "keeps touching the disk") +
                ": on the way back, to " + text_.of(task_.values.front()) + ", " +
                (flies                                ? "it does not touch down again"
                 : last->end.kind == EndKind::Contact ? "it does not take off again"
                                                      : "it does not fly again"));
        else if (transitions.size() <= 1)
            say((transitions.empty() ? "The slider does not end in the same state " + ways + "; the state changed only "
                                     : "The state also changed ") +
                (whole ? "while the last value was held a second time"
                       : "next to runs without a valid end, or while the last value was held again") +
                ", so its value is not known");
    }

    void addEndStates()
    {
        std::vector<double> flying, contact;
        for (const HeldStep& step : result_.steps)
            if (ended(step)) (step.end.kind == EndKind::Flying ? flying : contact).push_back(step.value);
        const auto all = std::ssize(flying) + std::ssize(contact);
        if (all == 0) return;
        const std::string begins = "Started anew at each value, the slider ends ";
        const auto where = [&](const std::vector<double>& values) {
            return " (" + text(rangesAmong(task_.values, values), text_) + ")";
        };
        if (flying.empty() || contact.empty())
            say(begins + (flying.empty() ? "in contact at some or all samples," : "flying") + " in " +
                (all == 1 ? "its one run" : "all " + std::to_string(all) + " runs"));
        else
            say(begins + "flying in " + std::to_string(flying.size()) + " of " + std::to_string(all) + " runs" +
                where(flying) + ", touching the disk in " + std::to_string(contact.size()) + where(contact));
    }

    void addLoop()
    {
        const LoopOf loop = loopOf(result_.steps);
        if (loop.known == 0) return;
        if (loop.values.empty()) {
            say("No hysteresis: the slider ends in the same states on the way there and back" +
                std::string(loop.whole ? "" : ", where both are known"));
            return;
        }
        const bool plain = text_.displayUnit.empty() || text_.displayUnit == "1";
        const std::string unit = plain ? " nm" : text_.displayUnit == "nm" ? " nm^2" : " nm " + text_.displayUnit;
        const double factor = plain ? 1.0 : unitFactor(text_.displayUnit);
        const bool lag = loop.moving == loop.values.size();
        std::string sentence = std::string(lag ? "Hysteresis or a lag " : "Hysteresis ") +
                               text(rangesAmong(task_.values, loop.values), text_) +
                               ": the slider ends in different states on the way there and back";
        if (loop.moving > 0)
            sentence += "; " +
                        (lag ? std::string("at none of these values both runs are at rest")
                             : "at " + std::to_string(loop.moving) + " of these " + std::to_string(loop.values.size()) +
                                   " values a run is not at rest") +
                        ", and only a longer hold shows whether it is a lag";
        say(sentence + ". The loop of the mean spacing has an area of " +
            fewDigits(loop.area / (1e-9 * factor), "", 3) + unit +
            (loop.whole ? "" : ", without the values at which a run failed"));
    }

    void addUnsettled()
    {
        const auto count = std::ranges::count_if(result_.steps, stillMoves);
        if (count > 0)
            say(counted(count, "run has", "runs have") + " not come to rest (change above 0.1 nm since the middle of " +
                fewDigitsOfTime(task_.hold, 3) + "); use a longer hold");
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
            (task_.fresh ? "" : "; the next run starts anew") + ". Reason of the first: " + problem);
    }

private:
    void say(const std::string& sentence) { findings_.push_back(sentence + "."); }

    /// Of runs that all end flying, or all touching.
    std::string seenThroughout(bool flying) const
    {
        const auto all = [&](EndKind kind) {
            return std::ranges::none_of(result_.steps,
                                        [&](const HeldStep& step) { return ended(step) && step.end.kind != kind; });
        };
        if (flying) return "The slider flies";
        return all(EndKind::Intermittent) ? "The slider goes in and out of contact"
               : all(EndKind::Contact)    ? "The slider is in contact"
                                          : "The slider is in contact at some or all samples";
    }
    static std::string throughout(bool flying)
    {
        return flying ? ": no touch-down" : ", already from the start at the first value; no take-off";
    }

    /// Where the branch that was left ends: within the step, or beyond it where the step itself set the slider
    /// swinging.
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
                beyond = left + " ends only at " + text_.of(mark.at.value) + reasonToLeaveEarly(each, mark.at.value);
        }
        return beyond;
    }

    /// A branch may have lost its stability before it ends. Where it has not, and the disk is flat, nothing but the
    /// step can have set the slider swinging; else no reason is known.
    std::string reasonToLeaveEarly(const Transition& each, double end) const
    {
        bool any = false, allStable = true;
        for (const EquilibriumLine& line : result_.lines)
            for (const StudiedEquilibrium& at : line.points) {
                const bool between = (at.value - each.before) * (end - at.value) >= 0.0;
                if (line.outside || line.flies() != each.down || !between) continue;
                if (at.stability == Stability::Flutter && !result_.doubtful(at)) return ": it is unstable before";
                any = true;
                allStable = allStable && at.stability == Stability::Stable && !at.incomplete();
            }
        const bool flat = task_.start.diskSurface.kind == DiskSurfaceKind::Flat;
        return any && allStable && flat ? ": the step itself made the slider oscillate; smaller steps come closer" : "";
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
    RunFindings runs(task, result, findings);
    if (result.traced) addAnswer(task, result, findings);
    if (task.fresh)
        runs.addEndStates();
    else {
        runs.addTransitions();
        runs.addLoop();
    }
    if (result.traced) addEquilibriaReached(task, result, findings);
    runs.addUnsettled();
    runs.addFailures();
    return findings;
}

} // namespace touchdown
