// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/simulation/units.h"
#include "core/studies/few_digits.h"
#include "core/studies/hysteresis_result.h"

namespace touchdown {

namespace {

class FindingsWriter {
public:
    FindingsWriter(const HeldSteps& task, const HysteresisResult& result)
        : task_(task), result_(result), text_(parameterText(task.parameter))
    {
    }

    std::vector<std::string> write()
    {
        if (result_.traced) addAnswer();
        if (task_.fresh) addEndStates();
        else addTransitions();
        if (!task_.fresh) addLoop();
        if (result_.traced) {
            addCoexistence();
            addAgreement();
        }
        addUnsettled();
        addFailures();
        return std::move(findings_);
    }

private:
    std::string inRange() const { return " from " + text_.of(task_.values.front()) + " to " + text_.of(task_.values.back()); }

    /// Values of a kind, as "1, 2 and 3" or by their ends.
    std::string valuesText(std::vector<double> values) const
    {
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
        if (values.size() == 1) return text_.of(values.front());
        return "values from " + text_.of(values.front()) + " to " + text_.of(values.back());
    }

    std::vector<double> bouncing() const
    {
        std::vector<double> values;
        for (const HeldStep& step : result_.steps)
            if (step.done && step.end.kind == EndKind::Intermittent) values.push_back(step.value);
        return values;
    }

    std::size_t validEnds() const
    {
        return static_cast<std::size_t>(std::ranges::count_if(result_.steps, [](const HeldStep& step) {
            return step.done && step.end.kind != EndKind::Failed;
        }));
    }

    /// Values without an equilibrium: sought in vain while the slider bounces, or while it does not, or not sought to the end. True where
    /// there are any.
    bool addMissing(const std::vector<double>& bounces)
    {
        std::vector<double> excited, quiet, unsought;
        for (const double value : task_.values) {
            const auto within = [](const EquilibriumAt& at) { return !at.outside; };
            if (std::ranges::any_of(equilibriaAt(result_.lines, value), within)) continue;
            // Starts share their equilibria, so that what is not known of one is not known of any.
            const bool missed = std::ranges::find(result_.unsought, value) != result_.unsought.end();
            const bool sought = !(task_.fresh ? !result_.unsought.empty() : missed);
            const bool bounced = std::ranges::find(bounces, value) != bounces.end();
            (!sought ? unsought : bounced ? excited : quiet).push_back(value);
        }
        if (!excited.empty())
            findings_.push_back("Self-excited: at " + valuesText(excited) +
                                " the slider ends in and out of contact, and no equilibrium was found for it to come to rest in.");
        if (!quiet.empty())
            findings_.push_back("At " + valuesText(quiet) +
                                " no equilibrium was found, and no held value ends in and out of contact; one may have been missed.");
        if (!unsought.empty())
            findings_.push_back("Not known: at " + valuesText(unsought) + " the search for equilibria did not come to its end.");
        return !excited.empty() || !quiet.empty() || !unsought.empty();
    }

    /// Self-excited or forced?
    void addAnswer()
    {
        std::vector<double> flutter, doubtful, incomplete, divergence, neutral;
        double slowest = -std::numeric_limits<double>::infinity();
        for (const EquilibriumLine& line : result_.lines)
            for (const StudiedEquilibrium& at : line.points) {
                if (line.outside) continue;
                slowest = std::max(slowest, at.growth().value_or(slowest));
                if (at.incomplete()) incomplete.push_back(at.value);
                if (result_.doubtful(at)) doubtful.push_back(at.value);
                else if (at.stability == Stability::Flutter) flutter.push_back(at.value);
                if (at.stability == Stability::Divergence) divergence.push_back(at.value);
                if (at.stability == Stability::Neutral) neutral.push_back(at.value);
            }
        const std::vector<double> bounces = bouncing();
        if (!flutter.empty()) addFlutter(flutter);
        if (!doubtful.empty())
            findings_.push_back("Not known on this grid: at " + valuesText(doubtful) +
                                " an equilibrium seems unstable by an oscillation above " + fewDigits(result_.resolved, "kHz") +
                                ", where the grid gives damping a wrong sign; a finer grid tells.");
        if (!incomplete.empty())
            findings_.push_back("Not known: at " + valuesText(incomplete) +
                                " an oscillation about an equilibrium could not be followed, or is damped so much that there is none.");
        const bool missing = addMissing(bounces);
        if (flutter.empty() && !missing && neutral.empty() && doubtful.empty() && incomplete.empty()) {
            std::string sentence = "no equilibrium" + inRange() + " loses its stability by an oscillation: there is no Hopf point, and "
                                 + (divergence.empty() ? "all are stable"
                                                       : "those that are unstable (" + valuesText(divergence) +
                                                             ") are left without oscillating")
                                 + ". Bouncing that lasts must be forced from outside, or be a cycle far from equilibrium.";
            if (divergence.empty() && slowest < 0.0)
                sentence += " The slowest disturbance fades within " + fewDigitsOfTime(-1.0 / slowest) + " by a factor of e.";
            findings_.push_back("Forced, as far as small motions tell: " + std::move(sentence));
            if (bounces.empty() && validEnds() > 0)
                findings_.push_back("No such cycle was seen: none of the " + std::to_string(validEnds()) +
                                    " held values that have a valid end ends in and out of contact.");
        } else if (!neutral.empty()) {
            findings_.push_back("At " + valuesText(neutral) +
                                " an equilibrium is neutral: its oscillations neither grow nor fade, since nothing damps them.");
        }
        if (!bounces.empty())
            findings_.push_back(std::to_string(bounces.size()) + " of " + std::to_string(validEnds()) +
                                " held values end in and out of contact (" + valuesText(bounces) + ").");
    }

    void addFlutter(const std::vector<double>& flutter)
    {
        std::string sentence = "Self-excited: an equilibrium is unstable by a growing oscillation at " + valuesText(flutter);
        for (const StudiedMark& mark : result_.marks) {
            if (mark.kind != EquilibriumMark::Hopf || mark.outside) continue;
            double frequency = 0.0, least = std::numeric_limits<double>::infinity();
            for (const std::complex<double>& value : mark.at.eigenvalues) {
                if (value.imag() == 0.0 || std::abs(value.real()) > least) continue;
                least = std::abs(value.real());
                frequency = std::abs(value.imag()) / (2.0 * std::numbers::pi);
            }
            sentence += "; Hopf point at " + text_.of(mark.at.value) + ", " + fewDigits(frequency, "kHz", 3);
        }
        findings_.push_back(sentence + ".");
    }

    void addTransitions()
    {
        const std::vector<Transition> transitions = transitionsOf(result_.steps);
        for (const Transition& each : transitions) {
            const bool rising = each.after > each.before;
            findings_.push_back(std::string(each.down ? "Touch-down" : "Take-off") + " at " + text_.of(each.middle()) + " +- " +
                                fewDigits(0.5 * std::abs(each.after - each.before), text_.displayUnit) + ", " +
                                (rising ? "rising" : "falling") + equilibriumEnd(each) + ".");
        }
        if (!transitions.empty()) return;
        const auto first = std::ranges::find_if(result_.steps, [](const HeldStep& step) {
            return step.done && step.end.kind != EndKind::Failed;
        });
        if (first != result_.steps.end())
            findings_.push_back("Neither touch-down nor take-off" + inRange() + " and back: " +
                                (first->end.kind == EndKind::Flying ? "the slider flies" : "the slider touches the disk") +
                                " at each of the values that ended.");
    }

    /// Where the branch that was left ends: within the step, or beyond it where the step itself set the slider swinging.
    std::string equilibriumEnd(const Transition& each) const
    {
        const double low = std::min(each.before, each.after), high = std::max(each.before, each.after);
        std::string beyond;
        for (const StudiedMark& mark : result_.marks) {
            if (mark.kind == EquilibriumMark::Kink || mark.kind == EquilibriumMark::Hopf || mark.outside) continue;
            if (mark.kind == EquilibriumMark::Switch && mark.name != (each.down ? "touch-down" : "take-off")) continue;
            // A fold of another branch may lie in the same step: the one that was left folds nearer to the state left.
            if (mark.kind == EquilibriumMark::Fold &&
                std::abs(mark.at.spacing - each.left) >= std::abs(mark.at.spacing - each.reached))
                continue;
            if (mark.at.value >= low && mark.at.value <= high)
                return "; the equilibrium that was left ends at " + text_.of(mark.at.value);
            if (mark.kind == EquilibriumMark::Switch && (mark.at.value - each.after) * (each.after - each.before) > 0.0)
                beyond = "; the equilibrium that was left ends only at " + text_.of(mark.at.value) +
                         ": the step set the slider swinging, and smaller steps come closer";
        }
        return beyond;
    }

    void addEndStates()
    {
        std::vector<double> flying, contact;
        for (const HeldStep& step : result_.steps) {
            if (!step.done || step.end.kind == EndKind::Failed) continue;
            (step.end.kind == EndKind::Flying ? flying : contact).push_back(step.value);
        }
        const auto part = [&](const std::vector<double>& values, const char* what) {
            return std::to_string(values.size()) + " of " + std::to_string(result_.steps.size()) + " starts end " + what +
                   (values.empty() ? "" : " (" + valuesText(values) + ")");
        };
        findings_.push_back(part(flying, "flying") + ", " + part(contact, "touching the disk") + ".");
    }

    void addLoop()
    {
        const LoopOf loop = loopOf(result_.steps);
        if (loop.known == 0) return;
        if (loop.values.empty()) {
            findings_.push_back("No hysteresis: there and back the end states are the same" +
                                std::string(loop.whole ? "." : " where both are known."));
            return;
        }
        const bool plain = text_.displayUnit.empty() || text_.displayUnit == "1";
        const std::string unit = plain ? " nm" : text_.displayUnit == "nm" ? " nm^2" : " nm " + text_.displayUnit;
        const double factor = plain ? 1.0 : unitFactor(text_.displayUnit);
        const bool lag = loop.moving == loop.values.size();
        std::string sentence = std::string(lag ? "Hysteresis or a lag" : "Hysteresis") + " at " + valuesText(loop.values) +
                               ": the ways there and back end in different states";
        if (loop.moving > 0)
            sentence += ", but at " + (lag ? std::string("none") : std::to_string(loop.moving)) + " of these values " +
                        (lag ? "have both" : "not both have") + " come to rest: a longer hold tells hysteresis from a lag";
        findings_.push_back(sentence + ". The loop of the mean "
                            "spacing has an area of " + fewDigits(loop.area / (1e-9 * factor), "", 3) + unit +
                            (loop.whole ? "." : ", without values at which a run failed."));
    }

    void addCoexistence()
    {
        std::vector<double> several;
        for (const double value : task_.values) {
            const auto rests = [](const EquilibriumAt& at) {
                return !at.outside && !at.incomplete && (at.stability == Stability::Stable || at.stability == Stability::Neutral);
            };
            if (std::ranges::count_if(equilibriaAt(result_.lines, value), rests) > 1) several.push_back(value);
        }
        if (!several.empty())
            findings_.push_back("More than one equilibrium is stable at " + valuesText(several) +
                                ": which one is reached depends on the way there.");
    }

    /// The held states against the equilibria, two ways to the same.
    void addAgreement()
    {
        double farthest = 0.0;
        std::size_t compared = 0;
        for (const HeldStep& step : result_.steps) {
            if (!step.done || (step.end.kind != EndKind::Flying && step.end.kind != EndKind::Contact)) continue;
            if (!step.atRest()) continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (const EquilibriumAt& at : equilibriaAt(result_.lines, step.value))
                nearest = std::min(nearest, std::abs(at.spacing - step.end.spacing));
            if (!std::isfinite(nearest)) continue;
            ++compared;
            farthest = std::max(farthest, nearest);
        }
        if (compared > 0)
            findings_.push_back("The " + std::to_string(compared) + " held values that came to rest did so within " +
                                fewDigits(farthest, "nm") + " of an equilibrium.");
    }

    void addUnsettled()
    {
        const auto count = std::ranges::count_if(result_.steps, stillMoves);
        if (count > 0)
            findings_.push_back(std::to_string(count) + (count == 1 ? " held value has" : " held values have") +
                                " not come to rest to 0.1 nm after " + fewDigitsOfTime(task_.hold, 3) + "; a longer hold tells more.");
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
        if (!values.empty())
            findings_.push_back("Without a valid end at " + valuesText(values) + ", after which runs begin anew: " + problem + ".");
    }

    const HeldSteps& task_;
    const HysteresisResult& result_;
    ParameterText text_;
    std::vector<std::string> findings_;
};

} // namespace

std::vector<std::string> hysteresisFindings(const HeldSteps& task, const HysteresisResult& result)
{
    return FindingsWriter(task, result).write();
}

} // namespace touchdown
