// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/studies/hysteresis/hysteresis_report.h"

namespace touchdown {

namespace {

/// Has a valid end.
bool ended(const HeldStep& step) { return step.done && step.end.kind != EndKind::Failed; }

class Findings {
public:
    Findings(const HeldSteps& task, const HysteresisResult& result)
        : task_(task), result_(result), text_(parameterText(task.parameter))
    {}

    std::vector<std::string> all()
    {
        if (result_.traced) addAnswer();
        if (task_.fresh) {
            addEndStates();
        } else {
            addTransitions();
            addLoop();
        }
        if (result_.traced) {
            addCoexistence();
            addAgreement();
        }
        addUnsettled();
        addFailures();
        return std::move(findings_);
    }

private:
    void say(const std::string& sentence) { findings_.push_back(sentence + "."); }

    /// Self-excited or forced: what the equilibria say.
    void addAnswer()
    {
        const auto where = [&](auto&& isSo) { return rangesAlong(result_.lines, isSo); };
        const auto is = [&](Stability stability) {
            return where([=](const StudiedEquilibrium& at) { return at.stability == stability; });
        };
        const auto flutter = where(
            [&](const StudiedEquilibrium& at) { return at.stability == Stability::Flutter && !result_.doubtful(at); });
        const auto doubtful = where([&](const StudiedEquilibrium& at) { return result_.doubtful(at); });
        const auto incomplete = where([](const StudiedEquilibrium& at) { return at.incomplete(); });
        const auto divergence = is(Stability::Divergence), neutral = is(Stability::Neutral);
        if (!flutter.empty()) addFlutter(flutter);
        if (!doubtful.empty())
            say("Not known on this grid: " + of(doubtful) + " an equilibrium seems unstable by an oscillation above " +
                fewDigits(result_.resolved, "kHz") +
                ", where the damping has the wrong sign on this grid; use a finer grid");
        if (!incomplete.empty())
            say("Not known: " + of(incomplete) +
                " an oscillation about an equilibrium could not be followed, or is overdamped");
        const bool missing = addMissing();
        if (flutter.empty() && !missing && neutral.empty() && doubtful.empty() && incomplete.empty())
            addForced(divergence);
        else if (!neutral.empty())
            say(of(neutral, true) +
                " an equilibrium is neutral: its oscillations neither grow nor decay, without damping");
        if (const auto bounces = bouncing(); !bounces.empty())
            say("Bounces to the end: " + counted(bounces.size(), "run") + " of " + std::to_string(validEnds()) + " (" +
                text(rangesAmong(task_.values, bounces), text_) + ")");
    }

    void addCoexistence()
    {
        const std::vector<ValueRange> several = coexistence(result_.lines);
        if (!several.empty())
            say(belongsToStart(task_.parameter.key)
                    ? "More than one equilibrium is stable: the start decides which one the slider reaches"
                    : "More than one equilibrium is stable " + of(several) +
                          ": the way there decides which one the slider reaches");
    }

    /// The held states against the equilibria, two ways to the same.
    void addAgreement()
    {
        constexpr double finest = 1e-12; // of a distance in a sentence [m]
        std::size_t atRest = 0, compared = 0;
        double farthest = 0.0;
        for (const HeldStep& step : result_.steps) {
            if (!step.done || (step.end.kind != EndKind::Flying && step.end.kind != EndKind::Contact) || !step.atRest())
                continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const EquilibriumAt& at : equilibriaAt(result_.lines, step.value))
                if (!at.outside && at.flying == (step.end.kind == EndKind::Flying) &&
                    (at.stability == Stability::Stable || at.stability == Stability::Neutral))
                    nearest = std::min(nearest, std::abs(at.spacing - step.end.spacing));
            ++atRest;
            if (!std::isfinite(nearest)) continue;
            ++compared;
            farthest = std::max(farthest, nearest);
        }
        if (compared == 0) return;
        const std::string within =
            "came to rest within " + fewDigits(std::max(farthest, finest), "nm") + " of an equilibrium";
        say(compared == atRest ? counted(compared, "run") + " " + within
                               : std::to_string(compared) + " of " + counted(atRest, "run") + " at rest " + within +
                                     " that is stable and in the same state; for the others none is known");
    }

    std::string of(const std::vector<ValueRange>& ranges, bool begins = false) const
    {
        const std::string where = text(ranges, text_);
        return begins ? capitalized(where) : where;
    }
    std::string inRange() const
    {
        return "from " + text_.of(task_.values.front()) + " to " + text_.of(task_.values.back());
    }

    std::vector<double> bouncing() const
    {
        std::vector<double> values;
        for (const HeldStep& step : result_.steps)
            if (step.done && bounces(step.end)) values.push_back(step.value);
        return values;
    }
    std::ptrdiff_t validEnds() const { return std::ranges::count_if(result_.steps, ended); }

    /// Values without an equilibrium: sought in vain while the slider bounces, or while it does not, or not sought to
    /// the end. True where there are any.
    bool addMissing()
    {
        const std::vector<double> bounces = bouncing();
        std::vector<double> excited, quiet, unsought;
        for (const double value : task_.values) {
            const bool bounced = std::ranges::find(bounces, value) != bounces.end();
            // What bounces comes to rest at none that diverges.
            const auto holds = [&](const EquilibriumAt& at) {
                return !at.outside && !(bounced && at.stability == Stability::Divergence);
            };
            if (std::ranges::any_of(equilibriaAt(result_.lines, value), holds)) continue;
            (result_.unsought ? unsought : bounced ? excited : quiet).push_back(value);
        }
        const auto where = [&](const std::vector<double>& values, bool begins = false) {
            return of(rangesAmong(task_.values, values), begins);
        };
        if (!excited.empty())
            say("Self-excited: " + where(excited) +
                " the slider bounces to the end, and no equilibrium was found that it could reach");
        if (!quiet.empty())
            say(where(quiet, true) +
                " no equilibrium was found, and no run bounces to the end; one may have been missed");
        if (!unsought.empty()) say("Not known: " + where(unsought) + " the search for equilibria was not complete");
        return !excited.empty() || !quiet.empty() || !unsought.empty();
    }

    void addForced(const std::vector<ValueRange>& divergence)
    {
        std::string sentence = "Forced, as far as small motions show: ";
        sentence += divergence.empty() ? "all equilibria " + inRange() + " are stable, and there is no Hopf point"
                                       : "no equilibrium " + inRange() +
                                             " becomes unstable by an oscillation; those that are unstable (" +
                                             of(divergence) + ") diverge without oscillating";
        sentence += ". Lasting bouncing must be forced from outside, or be a cycle far from any equilibrium";
        double slowest = -std::numeric_limits<double>::infinity();
        for (const EquilibriumLine& line : result_.lines)
            for (const StudiedEquilibrium& at : line.points)
                if (!line.outside) slowest = std::max(slowest, at.growth().value_or(slowest));
        if (divergence.empty() && slowest < 0.0)
            sentence += ". The slowest disturbance decays by a factor of e within " + fewDigitsOfTime(-1.0 / slowest);
        say(sentence);
        if (bouncing().empty() && validEnds() > 0)
            say(validEnds() == 1 ? "No such cycle occurred: the run does not bounce to the end"
                                 : "No such cycle occurred: none of the " + std::to_string(validEnds()) +
                                       " runs bounces to the end");
    }

    void addFlutter(const std::vector<ValueRange>& flutter)
    {
        std::string sentence = "Self-excited: an equilibrium is unstable by an oscillation that grows, " + of(flutter),
                    points;
        int count = 0;
        for (const StudiedMark& mark : result_.marks) {
            // What diverges there was unstable before, and is after.
            if (mark.kind != EquilibriumMark::Hopf || mark.outside || mark.at.stability == Stability::Divergence)
                continue;
            double frequency = 0.0, least = std::numeric_limits<double>::infinity();
            for (const std::complex<double>& value : mark.at.eigenvalues) {
                if (value.imag() == 0.0 || std::abs(value.real()) > least) continue;
                least = std::abs(value.real());
                frequency = std::abs(value.imag()) / (2.0 * std::numbers::pi);
            }
            ++count;
            points += (points.empty() ? "" : ", ") + text_.of(mark.at.value) + " (" +
                      fewDigits(mark.at.spacing, "nm", 3) + " spacing, " + fewDigits(frequency, "kHz", 3) + ")";
        }
        if (count > 0) sentence += std::string(count == 1 ? "; Hopf point at " : "; Hopf points at ") + points;
        say(sentence);
    }

    /// Touch-down and take-off: what the runs show.
    void addTransitions()
    {
        const std::vector<Transition> transitions = transitionsOf(result_.steps);
        for (const Transition& each : transitions)
            say(std::string(each.down ? "Touch-down" : "Take-off") + " at " + text_.of(each.middle()) + " +- " +
                fewDigits(0.5 * std::abs(each.after - each.before), text_.displayUnit) +
                (&each == &transitions.front() ? " of " + uncapitalized(text_.label) : "") + ", " +
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
        if (const auto bounced = std::ranges::find_if(
                loop.ends, [](const auto& ends) { return bounces(ends.first) != bounces(ends.second); });
            bounced != loop.ends.end())
            sentence += ". At " + text_.of(loop.values[std::size_t(bounced - loop.ends.begin())]) + " the slider " +
                        endText(bounced->first) + " on the way there and " + endText(bounced->second) +
                        " on the way back";
        say(sentence + ". The loop of the mean spacing has an area of " +
            fewDigits(loop.area / (1e-9 * factor), "", 3) + unit +
            (loop.whole ? "" : ", without the values at which a run failed"));
    }

    void addUnsettled()
    {
        const auto count = std::ranges::count_if(result_.steps, stillMoves);
        if (count > 0)
            say(counted(static_cast<std::size_t>(count), "run") + (count == 1 ? " has" : " have") +
                " not come to rest (change above 0.1 nm since the middle of " + fewDigitsOfTime(task_.hold, 3) +
                "); use a longer hold");
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
        using enum ContactRegion;
        const std::string ending = each.down ? switchName(Apart, Pressed) : switchName(Bridged, Apart);
        std::string beyond;
        for (const StudiedMark& mark : result_.marks) {
            if (mark.kind == EquilibriumMark::Kink || mark.kind == EquilibriumMark::Hopf || mark.outside) continue;
            if (mark.kind == EquilibriumMark::Switch && mark.name != ending) continue;
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
                if (line.outside || line.flying != each.down || !between) continue;
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
    std::vector<std::string> findings_;
};

} // namespace

std::vector<std::string> hysteresisFindings(const HeldSteps& task, const HysteresisResult& result)
{
    return Findings(task, result).all();
}

} // namespace touchdown
