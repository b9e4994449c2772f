// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_runs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/formats/units.h"
#include "core/simulation/static_state/steady.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/studies/precision/precision_pace.h"
#include "core/studies/precision/precision_task.h"
#include "core/work/wall_clock.h"
#include "core/work/work_done.h"

namespace touchdown {

namespace {

constexpr double budgetOfFirstRuns = 0.7; // the rest is for repeats
constexpr double budgetOfReferences = 0.6;
constexpr double shortRun = 5e-3; // [s]
constexpr double sameState = 0.5; // a film's spacings in one state differ by no more than this share, whatever the grid

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
        run.summary.failure = RunFailure::NotConverged;
        return run;
    }
    run.time = {0.0};
    for (const SteadyQuantity& each : steadyQuantities(state))
        for (std::size_t i = 0; i < names.size(); ++i)
            if (each.quantity.name == names[i] && std::isfinite(each.value)) run.columns[i] = {each.value};
    run.end = {EndKind::Flying, state.minimumSpacing, 0.0, Motion::AtRest};
    return run;
}

MeasuredRun measure(const PrecisionTask& task, const Case& c, const GoOn& goOn, const ShareTeller& tell = {})
{
    if (task.inTime) return measureRun(c, namesOf(task), goOn, {.kept = KeptStates::None}, tell);
    MeasuredRun run = measureSteady(c, namesOf(task), goOn);
    if (tell) tell(1.0);
    return run;
}

/// Springs take milliseconds, of which their samples take most.
double secondsOf(const PrecisionTask& task, const Summary& summary)
{
    return task.start.model == ModelKind::Springs ? summary.solverSeconds : summary.wallSeconds;
}

/// Over what is determined, first the task's quantity, then the others.
std::vector<TrajectoryError> errorsOf(const PrecisionTask& task, const MeasuredRun& run,
                                      const ProvenReference& reference)
{
    std::vector<TrajectoryError> errors;
    for (std::size_t i = 0; i <= task.also.size(); ++i)
        errors.push_back(trajectoryError(run, reference.run, i, reference.samples));
    return errors;
}

/// How far apart the spacings of one end state may lie [m].
double distanceOfEnds(const PrecisionTask& task, const MeasuredRun& reference)
{
    if (!task.inTime) return INFINITY;
    return task.start.model == ModelKind::Springs ? sameSpacing
                                                  : std::max(sameSpacing, sameState * std::abs(reference.end.spacing));
}

class Performance {
public:
    Performance(const PrecisionTask& task, int jobs, PrecisionRuns& runs, const RunsCallback& callback)
        : task_(task),
          jobs_(jobs),
          runs_(runs),
          callback_(callback),
          begin_(wallClock()),
          pace_(task, jobs, casesOf(task))
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
        runs_.secondsPerCost = pace_.secondsPerCost();
        return callback_(std::clamp(task_.budget - spent(), 0.0, pace_.left()), doing, changed);
    }

    /// Point by point.
    static std::vector<const Case*> casesOf(const PrecisionTask& task)
    {
        std::vector<const Case*> cases;
        for (const SweptMethod& method : task.methods)
            for (const MethodSetting& setting : method.settings) cases.push_back(&setting.c);
        return cases;
    }

    bool findReference()
    {
        std::vector<MeasuredRun> found(task_.references.size());
        for (MeasuredRun& each : found) each.summary.status = RunStatus::Cancelled; // until it ends
        const Ended ended = runTasks(
            found.size(), jobs_, budgetOfReferences * task_.budget,
            [&](std::size_t i, const GoOn& goOn) {
                found[i] = measure(task_, task_.references[i].c, goOn, pace_.tellerOfReference(i));
            },
            [&](std::size_t done) { return "reference: " + task_.references[std::min(done, found.size() - 1)].label; });
        pace_.endReferences();
        if (ended == Ended::Stopped) return false;
        runs_.referencesLate = ended == Ended::Late;
        const auto ran = [](const MeasuredRun& run) { return run.summary.status != RunStatus::Cancelled; };
        if (std::ranges::count_if(found, ran) < 2) {
            runs_.reference.problem =
                "fewer than two reference runs ended within " + fewDigitsOfTime(budgetOfReferences * task_.budget) +
                ", their share of the budget of " + fewDigitsOfTime(task_.budget) + "; give it more";
            return true;
        }
        const auto valid = std::ranges::find_if(found, &MeasuredRun::valid);
        sameDistance_ = distanceOfEnds(task_, valid != found.end() ? *valid : found.front());
        runs_.reference = proveReference(task_.references, std::move(found), task_.agreement, sameDistance_);
        if (runs_.reference.problem.empty())
            runs_.uncertainty = errorsOf(task_, runs_.reference.check, runs_.reference);
        changed_ = true;
        return proveEnd();
    }

    /// Where the trajectory of springs is not determined, which takes milliseconds, whether its end is.
    bool proveEnd()
    {
        ProvenReference& reference = runs_.reference;
        // Of what is no length nobody has said when it parts.
        const bool parts = reference.horizon || !std::isfinite(task_.agreement);
        if (!reference.endKnown || !parts || task_.start.model != ModelKind::Springs) return true;
        const std::vector<Case> starts = nudgedStarts(task_.references[reference.which].c);
        std::vector<MeasuredRun> ends(starts.size());
        const Ended ended = runTasks(
            ends.size(), jobs_, budgetOfReferences * task_.budget,
            [&](std::size_t i, const GoOn& goOn) { ends[i] = measure(task_, starts[i], goOn); },
            [](std::size_t) { return std::string("starts that hardly differ"); });
        if (ended == Ended::Well) touchdown::proveEnd(reference, ends, sameDistance_);
        runs_.referencesLate = runs_.referencesLate || ended == Ended::Late;
        return ended != Ended::Stopped;
    }

    const Case& caseOf(const PrecisionPoint& point) const
    {
        return task_.methods[point.method].settings[point.setting].c;
    }

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
        pace_.beginPoint(static_cast<std::size_t>(&point - runs_.points.data()));
        const Ended ended = runTasks(1, 1, until, runIt, [&](std::size_t) { return nameOf(task_, point); });
        pace_.endPoint();
        return ended;
    }

    bool runEach()
    {
        const double until = spent() + budgetOfFirstRuns * std::max(0.0, task_.budget - spent());
        const std::vector<PrecisionPoint*> order = byFineness();
        for (std::size_t i = 0; i < order.size(); ++i) {
            MeasuredRun run;
            const Ended ended = spent() < until ? runAlone(*order[i], until, run) : Ended::Late;
            if (ended == Ended::Stopped) return false;
            if (ended == Ended::Late) {
                runs_.late = true;
                break;
            }
            record(*order[i], run);
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
        // Where the end is not determined, none is the right one.
        const bool right = sameOutcome(run, reference.run, sameDistance_) || (!reference.endKnown && run.valid());
        point.kind = right ? PointKind::Good : run.valid() ? PointKind::WrongState : PointKind::Failed;
        if (point.kind == PointKind::Failed || run.columns[0].size() < reference.samples) return;
        point.errors = errorsOf(task_, run, reference);
    }

    bool repeat()
    {
        std::vector<PrecisionPoint*> order = byFineness();
        std::erase_if(order,
                      [&](const PrecisionPoint* point) { return !point->ran || point->fastest() > task_.timeLimit; });
        pace_.beginRepeats();
        std::vector<std::vector<double>> timed(order.size());
        Ended ended = Ended::Well;
        for (int round = 0; round < task_.repeats && ended == Ended::Well; ++round)
            for (std::size_t i = 0; i < order.size() && ended == Ended::Well; ++i) {
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
    double begin_; // wall clock [s]
    PrecisionPace pace_;
    bool changed_ = false;              // since the last call
    double sameDistance_ = sameSpacing; // of ends [m]
};

} // namespace

std::string nameOf(const PrecisionTask& task, const PrecisionPoint& point)
{
    const SweptMethod& method = task.methods[point.method];
    return nameOf(method.name, method.settings[point.setting].label);
}

bool performRuns(const PrecisionTask& task, int jobs, PrecisionRuns& runs, const RunsCallback& callback)
{
    return Performance(task, jobs, runs, callback).perform();
}

ErrorUnit unitOf(const PrecisionTask& task, ErrorMeasure measure)
{
    if (measure == ErrorMeasure::PeakFrequency) return {"Hz", "kHz"};
    if (measure == ErrorMeasure::PeakAmplitude) return {"m", "nm"};
    return {task.quantity.unit, task.quantity.displayUnit};
}

std::optional<double> errorOf(const PrecisionTask& task, const PrecisionPoint& point)
{
    if (!point.ran || point.kind == PointKind::Failed || point.errors.empty()) return {};
    return point.errors[0].at(task.measure);
}

double uncertaintyOf(const PrecisionTask& task, const PrecisionRuns& runs)
{
    return runs.uncertainty.empty() ? 0.0 : runs.uncertainty[0].at(task.measure).value_or(0.0);
}

std::optional<double> worthOf(const PrecisionTask& task, const PrecisionRuns& runs, const PrecisionPoint& point)
{
    std::optional<double> worth = errorOf(task, point);
    if (!worth) return worth;
    *worth = std::max(*worth, uncertaintyOf(task, runs));
    if (!task.methods[point.method].ordered) return worth;
    for (const PrecisionPoint& finer : runs.points)
        if (finer.method == point.method && finer.setting > point.setting)
            *worth = std::max(*worth, errorOf(task, finer).value_or(0.0));
    return worth;
}

std::vector<const PrecisionPoint*> paretoFront(const PrecisionTask& task, const PrecisionRuns& runs,
                                               const std::function<double(const PrecisionPoint&)>& cost)
{
    std::vector<const PrecisionPoint*> order, front;
    const auto error = [&](const PrecisionPoint* point) { return *worthOf(task, runs, *point); };
    for (const PrecisionPoint& point : runs.points)
        if (point.kind == PointKind::Good && errorOf(task, point) && cost(point) > 0.0) order.push_back(&point);
    std::ranges::stable_sort(order, {},
                             [&](const PrecisionPoint* point) { return std::tuple(cost(*point), error(point)); });
    for (const PrecisionPoint* point : order)
        if (front.empty() || error(point) < error(front.back())) front.push_back(point);
    std::ranges::reverse(front);
    return front;
}

} // namespace touchdown
