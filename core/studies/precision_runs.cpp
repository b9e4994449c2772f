// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision_runs.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/wall_clock.h"
#include "core/simulation/steady.h"
#include "core/simulation/steady_quantities.h"
#include "core/studies/run_failure.h"

namespace touchdown {

namespace {

constexpr double shareOfReference = 0.15, shareOfFirstRuns = 0.5; // of the progress that is shown
constexpr double budgetOfFirstRuns = 0.7; // what is left is for repeats
constexpr double shortRun = 5e-3;         // [s]
constexpr double sameState = 0.5;         // a film's spacings in one state differ by no more than this share, whatever the grid

std::vector<std::string> namesOf(const PrecisionTask& task)
{
    std::vector<std::string> names{task.quantity.name};
    for (const Quantity& quantity : task.also) names.push_back(quantity.name);
    return names;
}

/// A static state as a run with one sample.
MeasuredRun measureSteady(const Case& c, const std::vector<std::string>& names, const GoOn& goOn)
{
    const double begin = wallClock();
    const SteadyResult state = steady(c, [&](const SteadyProgress&) { return !goOn || goOn(); });
    MeasuredRun run;
    run.summary.wallSeconds = run.summary.solverSeconds = wallClock() - begin;
    run.summary.evaluations = state.solves;
    run.summary.steps = state.iterations;
    run.summary.message = state.message;
    run.columns.resize(names.size());
    if (state.status != SteadyStatus::Converged) {
        run.summary.status = state.status == SteadyStatus::Cancelled ? RunStatus::Cancelled : RunStatus::Failed;
        return run;
    }
    run.time = {0.0};
    for (const SteadyQuantity& each : steadyQuantities(state))
        for (std::size_t i = 0; i < names.size(); ++i)
            if (each.quantity.name == names[i] && std::isfinite(each.value)) run.columns[i] = {each.value};
    run.end = {EndKind::Flying, state.minimumSpacing, 0.0};
    return run;
}

MeasuredRun measure(const PrecisionTask& task, const Case& c, const GoOn& goOn)
{
    return task.inTime ? measureRun(c, namesOf(task), goOn) : measureSteady(c, namesOf(task), goOn);
}

/// Springs take milliseconds, of which their samples take most.
double secondsOf(const PrecisionTask& task, const Summary& summary)
{
    return task.start.model == ModelKind::Springs ? summary.solverSeconds : summary.wallSeconds;
}

std::vector<TrajectoryError> errorsOf(const PrecisionTask& task, const MeasuredRun& run, const MeasuredRun& reference, std::size_t samples)
{
    std::vector<TrajectoryError> errors;
    for (std::size_t i = 0; i <= task.also.size(); ++i) errors.push_back(trajectoryError(run, reference, i, samples));
    return errors;
}

/// They end in one state, or fail alike.
bool sameOutcome(const PrecisionTask& task, const MeasuredRun& run, const MeasuredRun& reference)
{
    if (run.valid() != reference.valid()) return false;
    if (!run.valid()) return failureOf(run.summary) == failureOf(reference.summary);
    if (!task.inTime) return true;
    const double share = task.start.model == ModelKind::Springs ? 0.0 : sameState;
    return sameEnd(run.end, reference.end, std::max(0.1e-9, share * std::abs(reference.end.spacing)));
}

class Performance {
public:
    Performance(const PrecisionTask& task, int jobs, PrecisionRuns& runs, const RunsCallback& callback)
        : task_(task), jobs_(jobs), runs_(runs), callback_(callback), begin_(wallClock())
    {
        for (std::size_t m = 0; m < task.methods.size(); ++m)
            for (std::size_t s = 0; s < task.methods[m].settings.size(); ++s) {
                PrecisionPoint& point = runs_.points.emplace_back();
                point.method = m;
                point.setting = s;
            }
    }

    bool perform()
    {
        if (!findReference()) return false;
        if (!runs_.reference.problem.empty()) return true;
        return runEach() && repeat();
    }

private:
    double spent() const { return wallClock() - begin_; }

    /// Runs tasks; a stop by the callback and one because the budget is spent are told apart.
    enum class Ended : std::uint8_t { Well, Late, Stopped };
    Ended runTasks(std::size_t count, int jobs, double until, const std::function<void(std::size_t, const GoOn&)>& task,
                   const std::function<std::string(std::size_t)>& doing)
    {
        bool stopped = false;
        const bool well = runParallel(count, jobs, task, [&](std::size_t done) {
            stopped = !tell(doing(done));
            return !stopped && spent() < until;
        });
        return stopped ? Ended::Stopped : well ? Ended::Well : Ended::Late;
    }

    bool tell(const std::string& doing)
    {
        const bool changed = std::exchange(changed_, false);
        return callback_(share_, doing, changed);
    }

    bool findReference()
    {
        std::vector<MeasuredRun> found(task_.references.size());
        const Ended ended = runTasks(
            found.size(), jobs_, INFINITY,
            [&](std::size_t i, const GoOn& goOn) { found[i] = measure(task_, task_.references[i].c, goOn); },
            [&](std::size_t done) {
                share_ = shareOfReference * static_cast<double>(done) / static_cast<double>(found.size());
                return std::string("reference");
            });
        if (ended == Ended::Stopped) return false;
        choose(found);
        share_ = shareOfReference;
        changed_ = true;
        return true;
    }

    /// The pair that lies closest; its first one is the reference.
    void choose(std::vector<MeasuredRun>& found)
    {
        ProvenReference& reference = runs_.reference;
        std::size_t best = found.size(), other = best;
        reference.apart = INFINITY;
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t k = i + 1; k < found.size(); ++k) {
                if (!sameOutcome(task_, found[i], found[k])) continue;
                const auto apart = trajectoryError(found[i], found[k], 0).at(ErrorMeasure::Worst);
                if (!apart || *apart >= reference.apart) continue;
                best = i;
                other = k;
                reference.apart = *apart;
            }
        if (best == found.size()) return chooseApart(found);
        take(found, best, other);
    }

    /// No two end alike: what they share before they part.
    void chooseApart(std::vector<MeasuredRun>& found)
    {
        std::size_t best = found.size(), other = best, together = 0;
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t k = i + 1; k < found.size(); ++k) {
                const std::size_t both = std::min(found[i].columns[0].size(), found[k].columns[0].size());
                const std::size_t apart = firstApart(found[i], found[k], task_.agreement).value_or(both);
                if (apart <= together) continue;
                best = i;
                other = k;
                together = apart;
            }
        if (best < found.size()) {
            runs_.reference.apart = trajectoryError(found[best], found[other], 0).at(ErrorMeasure::Worst).value_or(0.0);
            take(found, best, other);
            if (!runs_.reference.horizon) setHorizon(together);
            return;
        }
        runs_.reference.problem = "no two of the reference runs agree at all";
        for (std::size_t i = 0; i < found.size(); ++i)
            if (!found[i].valid()) runs_.reference.problem += "; " + task_.references[i].label + ": " + found[i].summary.message;
    }

    void take(std::vector<MeasuredRun>& found, std::size_t best, std::size_t other)
    {
        ProvenReference& reference = runs_.reference;
        reference.label = task_.references[best].label;
        reference.other = task_.references[other].label;
        reference.run = std::move(found[best]);
        reference.samples = reference.run.time.size();
        uncertain_ = &found[other];
        if (const auto apart = firstApart(reference.run, found[other], task_.agreement)) setHorizon(*apart);
        reference.uncertainty = errorsOf(task_, found[other], reference.run, reference.samples);
    }

    void setHorizon(std::size_t sample)
    {
        ProvenReference& reference = runs_.reference;
        reference.samples = sample;
        reference.horizon = reference.run.time[std::min(sample, reference.run.time.size() - 1)];
        reference.uncertainty = errorsOf(task_, *uncertain_, reference.run, sample);
    }

    std::string nameOf(const PrecisionPoint& point) const
    {
        const PrecisionMethod& method = task_.methods[point.method];
        const std::string& label = method.settings[point.setting].label;
        return label.empty() ? method.name : method.name + ", " + label;
    }
    const Case& caseOf(const PrecisionPoint& point) const { return task_.methods[point.method].settings[point.setting].c; }

    /// Coarse settings of all methods before fine ones of any.
    std::vector<PrecisionPoint*> byFineness()
    {
        std::vector<PrecisionPoint*> order;
        for (PrecisionPoint& point : runs_.points) order.push_back(&point);
        std::ranges::stable_sort(order, {}, [](const PrecisionPoint* point) { return point->setting; });
        return order;
    }

    /// One run alone, while the caller's thread watches.
    Ended runAlone(const PrecisionPoint& point, double until, MeasuredRun& run)
    {
        const auto runIt = [&](std::size_t, const GoOn& goOn) {
            run = measure(task_, caseOf(point), goOn);
            // What others have cooled since its last run makes the first of two short ones slower.
            if (run.valid() && secondsOf(task_, run.summary) < shortRun) run = measure(task_, caseOf(point), goOn);
        };
        return runTasks(1, 1, until, runIt, [&](std::size_t) { return nameOf(point); });
    }

    bool runEach()
    {
        const double until = spent() + budgetOfFirstRuns * std::max(0.0, task_.budget - spent());
        const std::vector<PrecisionPoint*> order = byFineness();
        runs_.complete = true;
        for (std::size_t i = 0; i < order.size(); ++i) {
            MeasuredRun run;
            const Ended ended = spent() < until ? runAlone(*order[i], until, run) : Ended::Late;
            if (ended == Ended::Stopped) return false;
            if (ended == Ended::Late) {
                runs_.late = true;
                runs_.complete = false;
                break;
            }
            record(*order[i], run);
            share_ = shareOfReference + shareOfFirstRuns * static_cast<double>(i + 1) / static_cast<double>(order.size());
            changed_ = true;
        }
        return true;
    }

    void record(PrecisionPoint& point, const MeasuredRun& run)
    {
        const ProvenReference& reference = runs_.reference;
        point.ran = true;
        point.summary = run.summary;
        point.end = run.end;
        point.seconds = {secondsOf(task_, run.summary)};
        point.work = workOf(caseOf(point), run.summary);
        const bool alike = sameOutcome(task_, run, reference.run);
        // Beyond the horizon no end is the right one.
        const bool right = alike || (reference.horizon && run.valid());
        point.kind = right ? PointKind::Good : run.valid() ? PointKind::WrongState : PointKind::Failed;
        if (point.kind == PointKind::Failed || run.columns[0].size() < reference.samples) return;
        point.errors = errorsOf(task_, run, reference.run, reference.samples);
    }

    bool repeat()
    {
        std::vector<PrecisionPoint*> order = byFineness();
        std::erase_if(order, [&](const PrecisionPoint* point) { return !point->ran || point->fastest() > task_.timeLimit; });
        const double first = share_;
        const std::size_t all = order.size() * static_cast<std::size_t>(task_.repeats);
        std::vector<std::vector<double>> timed(order.size());
        std::size_t done = 0;
        Ended ended = Ended::Well;
        for (int round = 0; round < task_.repeats && ended == Ended::Well; ++round)
            for (std::size_t i = 0; i < order.size() && ended == Ended::Well; ++i, ++done) {
                share_ = first + (1.0 - first) * static_cast<double>(done) / static_cast<double>(all);
                MeasuredRun run;
                ended = spent() < task_.budget ? runAlone(*order[i], task_.budget, run) : Ended::Late;
                if (ended == Ended::Well) timed[i].push_back(secondsOf(task_, run.summary));
            }
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (timed[i].empty()) continue;
            std::ranges::sort(timed[i]);
            order[i]->seconds = timed[i];
        }
        changed_ = true;
        return ended != Ended::Stopped;
    }

    const PrecisionTask& task_;
    int jobs_;
    PrecisionRuns& runs_;
    const RunsCallback& callback_;
    double begin_;         // wall clock [s]
    double share_ = 0.0;   // done
    bool changed_ = false; // since the last call
    const MeasuredRun* uncertain_ = nullptr; // with which the reference was compared, while it is chosen
};

} // namespace

double PrecisionPoint::median() const
{
    if (seconds.empty()) return 0.0;
    const std::size_t middle = seconds.size() / 2;
    return seconds.size() % 2 == 1 ? seconds[middle] : 0.5 * (seconds[middle - 1] + seconds[middle]);
}

bool performRuns(const PrecisionTask& task, int jobs, PrecisionRuns& runs, const RunsCallback& callback)
{
    return Performance(task, jobs, runs, callback).perform();
}

} // namespace touchdown
