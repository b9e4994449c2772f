// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/studies/hysteresis/equilibrium_ranges.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

std::string counted(std::ptrdiff_t count, const char* one, const char* several)
{
    return std::to_string(count) + " " + (count == 1 ? one : several);
}

namespace {

/// Self-excited or forced: what the equilibria say.
class EquilibriumFindings {
public:
    EquilibriumFindings(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings)
        : task_(task), result_(result), text_(parameterText(task.parameter)), findings_(findings)
    {}

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
            say("In and out of contact until the end: " + counted(std::ptrdiff_t(bounces.size()), "run", "runs") +
                " of " + std::to_string(validEnds()) + " (" + text(rangesAmong(task_.values, bounces), text_) + ")");
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
        std::ptrdiff_t atRest = 0, compared = 0;
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
        say(compared == atRest ? counted(compared, "run", "runs") + " " + within
                               : std::to_string(compared) + " of " + counted(atRest, "run", "runs") + " at rest " +
                                     within + " that is stable and in the same state; for the others none is known");
    }

private:
    void say(const std::string& sentence) { findings_.push_back(sentence + "."); }
    std::string of(const std::vector<ValueRange>& ranges, bool begins = false) const
    {
        std::string where = text(ranges, text_);
        if (begins) where[0] = where[0] == 'a' ? 'A' : where[0] == 'i' ? 'I' : 'F';
        return where;
    }
    std::string inRange() const
    {
        return "from " + text_.of(task_.values.front()) + " to " + text_.of(task_.values.back());
    }

    std::vector<double> bouncing() const
    {
        std::vector<double> values;
        for (const HeldStep& step : result_.steps)
            if (step.done && step.end.kind == EndKind::Intermittent) values.push_back(step.value);
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
                " the slider ends in and out of contact, and no equilibrium was found that it could reach");
        if (!quiet.empty())
            say(where(quiet, true) +
                " no equilibrium was found, and no run ends in and out of contact; one may have been missed");
        if (!unsought.empty()) say("Not known: " + where(unsought) + " the search for equilibria was not complete");
        return !excited.empty() || !quiet.empty() || !unsought.empty();
    }

    void addForced(const std::vector<ValueRange>& divergence)
    {
        std::string sentence = "Forced, by the small motions: ";
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
            say(validEnds() == 1 ? "No such cycle occurred: the run does not end in and out of contact"
                                 : "No such cycle occurred: none of the " + std::to_string(validEnds()) +
                                       " runs ends in and out of contact");
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

    const HeldSteps& task_;
    const HysteresisResult& result_;
    ParameterText text_;
    std::vector<std::string>& findings_;
};

} // namespace

void addAnswer(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings)
{
    EquilibriumFindings(task, result, findings).addAnswer();
}

void addEquilibriaReached(const HeldSteps& task, const HysteresisResult& result, std::vector<std::string>& findings)
{
    EquilibriumFindings equilibria(task, result, findings);
    equilibria.addCoexistence();
    equilibria.addAgreement();
}

} // namespace touchdown
