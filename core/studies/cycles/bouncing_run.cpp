// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/formats/units.h"
#include "core/simulation/recording/motion_verdict.h"
#include "core/studies/cycles/bouncing_film.h"
#include "core/studies/cycles/bouncing_springs.h"

namespace touchdown {

namespace {

constexpr double nearReturn = 0.05;    // distance of a state that returns nearly, of its size [-]
constexpr std::size_t keptStates = 64; // on the section
constexpr int stepsBetweenAsking = 4096;
constexpr double samplesInPeriod = 32.0; // of the shortest motion
constexpr double leastSamples = 2000.0;  // of a run

/// The states on the section, the newest last, the swing in the last tenth, and what the verdict needs.
class BouncingRecorder final : public BouncingWatch {
public:
    BouncingRecorder(const BouncingSlider& slider, const BouncingSearch& search)
        : search_(search), judgedFrom_((1.0 - judgedShare) * search.duration)
    {
        samples_.interval = std::min(slider.shortestPeriod() / samplesInPeriod, search.duration / leastSamples);
    }

    void begin(double minimumSpacing, ContactRegion region) override
    {
        region_ = region;
        addSample(minimumSpacing);
    }
    bool step(double t, const std::function<double(double)>& spacingAt) override
    {
        if (t >= judgedFrom_)
            for (const double s : {0.25, 0.5, 0.75, 1.0}) {
                const double time = std::lerp(time_, t, s);
                if (time >= judgedFrom_) spacing_.add(spacingAt(time));
            }
        for (double time; (time = double(taken_) * samples_.interval) <= t;) addSample(spacingAt(time));
        time_ = t;
        return ++steps_ % stepsBetweenAsking != 0 || !search_.goOn || search_.goOn();
    }
    void event(double time, const CycleSwitch& of, const Eigen::VectorXd* x) override
    {
        region_ = of.after.contact;
        if ((of.before.contact == ContactRegion::Apart) != (region_ == ContactRegion::Apart))
            samples_.switches.push_back(time);
        if (!x) return;
        if (time >= judgedFrom_) ++crossings_;
        states_[next_ % keptStates] = *x;
        times_[next_ % keptStates] = time;
        ++next_;
    }

    /// The k-th newest state on the section, k = 0, 1, ...; its time [s].
    const Eigen::VectorXd& state(std::size_t k) const { return states_[(next_ - 1 - k) % keptStates]; }
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
    void addSample(double spacing)
    {
        samples_.add(spacing, region_ == ContactRegion::Apart ? Touch::Never : Touch::Always);
        ++taken_;
        const std::size_t most = search_.mostSamples;
        if (samples_.spacing.size() > 2 * most) samples_.dropFirst(samples_.spacing.size() - most);
    }

    const BouncingSearch& search_;
    ContactRegion region_ = ContactRegion::Apart;
    double judgedFrom_, time_ = 0.0; // [s]
    long long steps_ = 0;
    std::array<Eigen::VectorXd, keptStates> states_;
    std::array<double, keptStates> times_{}; // [s]
    std::size_t next_ = 0, crossings_ = 0;
    MotionSamples samples_; // the newest
    long long taken_ = 0;   // all samples
    SwingOf spacing_;
};

} // namespace

SliderOf slidersLike(const Case& c)
{
    if (c.model == ModelKind::Film) return filmsLike(c);
    return [units = sectionUnits(c)](const Case& at, int start, const GoOn&) {
        return std::make_shared<const BouncingSprings>(caseOfStart(at, start), units);
    };
}

BouncingRun searchCycle(const BouncingSlider& slider, double value, const BouncingSearch& search,
                        const std::optional<Eigen::VectorXd>& from)
{
    BouncingRun run;
    run.value = value;
    run.height = slider.startHeight();
    BouncingRecorder recorder(slider, search);
    const LongMotion motion = slider.run(from, search.duration, search.tolerance, recorder);
    run.problem = motion.problem;
    if (!run.problem.empty()) return run;
    run.minimumSpacing = recorder.spacing();
    run.end = recorder.end();
    run.samples = recorder.samples();
    const auto leaveOut = [&](double modelError) {
        run.cycle.reset();
        run.end = BouncingEnd::Failed;
        run.modelError = modelError;
        run.problem = "it bounces so far that the linear film has an estimated error of " + percent(modelError) +
                      " of the motion, above film.linear_limit";
        return run;
    };
    if (run.end == BouncingEnd::Bounces && motion.tooFar) return leaveOut(motion.modelError);
    if (search.mostCrossings == 0) return run;
    if (recorder.crossings() < fewestCrossings) {
        if (run.end == BouncingEnd::Bounces)
            run.problem = "it comes down to d_s fewer than " + std::to_string(fewestCrossings) +
                          " times in the last tenth: no cycle was sought";
        return run;
    }
    const std::size_t most = std::min<std::size_t>(static_cast<std::size_t>(search.mostCrossings), recorder.kept() - 1);
    const Eigen::VectorXd& last = recorder.state(0);
    const auto frequencyOf = [&](std::size_t crossings) { // of cycles with so many
        const std::size_t whole = (recorder.kept() - 1) / crossings;
        return double(whole) / (recorder.time(0) - recorder.time(whole * crossings));
    };
    run.frequency = frequencyOf(1);
    run.problem = "no state on the section returns after up to " + std::to_string(search.mostCrossings) + " crossings";
    for (std::size_t n = 1; n <= most; ++n) {
        if ((recorder.state(n) - last).norm() > nearReturn * last.norm()) continue;
        const double limit = 4.0 * (recorder.time(0) - recorder.time(n));
        const CycleSolution solution = solveCycle(slider, last, static_cast<int>(n), limit);
        run.problem = solution.problem;
        if (!solution.found) continue;
        LimitCycle cycle = figuresOf(slider, value, solution.x, solution.crossings, limit);
        if (!(cycle.period > 0.0)) continue;
        if (cycle.tooFar) return leaveOut(cycle.modelError);
        run.frequency = frequencyOf(std::size_t(cycle.crossings));
        run.cycle = std::move(cycle);
        run.problem.clear();
        break;
    }
    return run;
}

BouncingRun runOf(const SliderOf& sliderOf, const Case& c, int start, double value, const BouncingSearch& search)
{
    BouncingRun none;
    none.value = value;
    none.problem = "stopped";
    try {
        if (const auto slider = sliderOf(c, start, search.goOn)) return searchCycle(*slider, value, search);
    } catch (const std::runtime_error& error) {
        none.problem = error.what();
    }
    return none;
}

} // namespace touchdown
