// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_run.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/numerics/adaptive.h"
#include "core/simulation/recording/motion_verdict.h"

namespace touchdown {

namespace {

constexpr double judgedShare = 0.1;    // of a run, at its end [-]
constexpr double nearReturn = 0.05;    // distance of a state that returns nearly, of its size [-]
constexpr std::size_t keptStates = 64; // on the section
constexpr int stepsBetweenAsking = 4096;
constexpr double samplesInPeriod = 32.0; // of the shortest motion
constexpr double leastSamples = 2000.0;  // of a run

/// The states on the section, the newest last, the swing in the last tenth, and what the verdict needs.
class BouncingRecorder {
public:
    BouncingRecorder(const ReturnMap& map, const BouncingSearch& search, const SpringModel::State& start,
                     SpringModel::Mode mode)
        : map_(map), search_(search), last_(start), mode_(mode), judgedFrom_((1.0 - judgedShare) * search.duration)
    {
        samples_.interval = std::min(map.model().shortestPeriod() / samplesInPeriod, search.duration / leastSamples);
        addSample(start);
    }

    template <class At>
    bool step(double t, const SpringModel::State& y, SpringModel::Mode, At&& at)
    {
        if (t >= judgedFrom_)
            for (const double s : {0.25, 0.5, 0.75, 1.0}) {
                const double time = std::lerp(time_, t, s);
                if (time >= judgedFrom_) spacing_.add(map_.model().guards(at(time).template head<2>()).minCoeff());
            }
        for (double time; (time = double(taken_) * samples_.interval) <= t;) addSample(at(time));
        time_ = t;
        last_ = y;
        return ++steps_ % stepsBetweenAsking != 0 || !search_.goOn || search_.goOn();
    }
    void event(double time, int guard, bool, SpringModel::Mode before, SpringModel::Mode after)
    {
        mode_ = after;
        if ((before.contact == ContactRegion::Apart) != (after.contact == ContactRegion::Apart))
            samples_.switches.push_back(time);
        if (!ReturnMap::crosses(guard, before, after)) return;
        if (time >= judgedFrom_) ++crossings_;
        states_[next_ % keptStates] = map_.coordinates(last_);
        times_[next_ % keptStates] = time;
        ++next_;
    }

    /// The k-th newest state on the section, k = 0, 1, ...; its time [s].
    const Vector3& state(std::size_t k) const { return states_[(next_ - 1 - k) % keptStates]; }
    double time(std::size_t k) const { return times_[(next_ - 1 - k) % keptStates]; }
    std::size_t kept() const { return std::min(next_, keptStates); }
    std::size_t crossings() const { return crossings_; } // in the last tenth
    const SwingOf& spacing() const { return spacing_; }
    std::size_t samples() const { return samples_.spacing.size(); }
    BouncingEnd end() const
    {
        const MotionVerdict verdict = judgeMotion(samples_);
        if (verdict.motion == Motion::Bounces) return BouncingEnd::Bounces;
        if (verdict.motion == Motion::TooShort || verdict.touch == Touch::AtTimes) return BouncingEnd::Unknown;
        return verdict.touch == Touch::Always ? BouncingEnd::Caught : BouncingEnd::Flies;
    }

private:
    void addSample(const SpringModel::State& y)
    {
        samples_.add(map_.model().guards(y.template head<2>()).minCoeff(),
                     mode_.contact == ContactRegion::Apart ? Touch::Never : Touch::Always);
        ++taken_;
        const std::size_t most = search_.mostSamples;
        if (samples_.spacing.size() > 2 * most) samples_.dropFirst(samples_.spacing.size() - most);
    }

    const ReturnMap& map_;
    const BouncingSearch& search_;
    SpringModel::State last_;
    SpringModel::Mode mode_;
    double judgedFrom_, time_ = 0.0; // [s]
    long long steps_ = 0;
    std::array<Vector3, keptStates> states_;
    std::array<double, keptStates> times_{}; // [s]
    std::size_t next_ = 0, crossings_ = 0;
    MotionSamples samples_; // the newest
    long long taken_ = 0;   // all samples
    SwingOf spacing_;
};

} // namespace

Case caseOfStart(const Case& c, int k)
{
    if (k == 0) return c;
    Case lower = c;
    const double takeOff = characteristic(c).value().takeOff;
    const double height = std::max(c.initial.flyingHeight, 2.0 * takeOff);
    lower.initial.flyingHeight = takeOff + (height - takeOff) * std::pow(10.0, -k);
    lower.initial.pitch = c.springs.pitch;
    lower.initial.verticalVelocity = lower.initial.pitchVelocity = 0.0;
    lower.initial.branch = ContactBranch::TouchDown;
    return checkCombinations(lower).empty() ? lower : c;
}

BouncingRun searchCycle(const Case& c, double value, const Vector3& units, const BouncingSearch& search,
                        const std::optional<Vector3>& from)
{
    const ReturnMap map(c, units);
    const SpringModel& model = map.model();
    BouncingRun run;
    run.value = value;
    run.height = c.initial.flyingHeight;
    const Start<SpringModel> start =
        from ? map.start(*from) : Start<SpringModel>{model.initialState(), model.initialMode()};
    BouncingRecorder recorder(map, search, start.y, start.mode);
    const AdaptiveOptions options{.tolerance = search.tolerance, .firstStep = 1e-3 * model.shortestPeriod()};
    const IntegrationResult result = integrateAdaptive(model, start, search.duration, options, recorder);
    if (result.end != IntegrationEnd::Reached) {
        run.problem =
            result.end == IntegrationEnd::Stopped ? "stopped" : "the run ends at " + fewDigitsOfTime(result.time, 3);
        return run;
    }
    run.minimumSpacing = recorder.spacing();
    run.end = recorder.end();
    run.samples = recorder.samples();
    if (recorder.crossings() < fewestCrossings || search.mostCrossings == 0) return run;
    const std::size_t most = std::min<std::size_t>(static_cast<std::size_t>(search.mostCrossings), recorder.kept() - 1);
    const Vector3& last = recorder.state(0);
    const auto frequencyOf = [&](std::size_t crossings) { // of cycles with so many
        const std::size_t whole = (recorder.kept() - 1) / crossings;
        return double(whole) / (recorder.time(0) - recorder.time(whole * crossings));
    };
    run.frequency = frequencyOf(1);
    run.problem = "no state on the section returns after up to " + std::to_string(search.mostCrossings) + " crossings";
    for (std::size_t n = 1; n <= most; ++n) {
        if ((recorder.state(n) - last).norm() > nearReturn * last.norm()) continue;
        const double limit = 4.0 * (recorder.time(0) - recorder.time(n));
        const CycleSolution solution = solveCycle(map, last, static_cast<int>(n), limit);
        run.problem = solution.problem;
        if (!solution.found) continue;
        LimitCycle cycle = figuresOf(map, c, value, solution.x, solution.crossings, limit);
        if (!(cycle.period > 0.0)) continue;
        run.frequency = frequencyOf(std::size_t(cycle.crossings));
        run.cycle = std::move(cycle);
        run.problem.clear();
        break;
    }
    return run;
}

} // namespace touchdown
