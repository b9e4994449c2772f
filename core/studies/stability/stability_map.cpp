// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_map.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>

#include "core/studies/runs/trajectory_error.h"
#include "core/studies/runs/work_done.h"
#include "core/work/parallel.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double mostSamples = 20000; // of a run
constexpr double tenth = 0.1;         // of a setting, which the paper's criterion compares
constexpr double nudgedShare = 0.05;  // of the progress, for starts that hardly differ, if any are needed
constexpr double betweenNews = 0.25;  // while the map is made [s]

/// One run that is to be made.
struct Job {
    const Case* c = nullptr;
    MeasuredRun* result = nullptr;
    std::string doing;
    double cost = 0.0;    // expected, in right-hand sides
    std::size_t cell = 0; // of the map, whose run it is
};

/// The classes of the cells so far, for the thread of the study.
class CellsSoFar {
public:
    explicit CellsSoFar(const std::vector<StabilityCell>& all) { map_.cells = all; }

    void take(std::size_t i, const StabilityCell& cell)
    {
        const std::lock_guard lock(mutex_);
        map_.cells[i].verdict = cell.verdict;
        map_.cells[i].done = true;
        changed_ = true;
    }
    /// A copy, which the next call replaces; nullptr where there is nothing new, or the last news are young.
    const StabilityMap* news()
    {
        const double now = wallClock();
        if (now - toldAt_ < betweenNews) return nullptr;
        const std::lock_guard lock(mutex_);
        if (!std::exchange(changed_, false)) return nullptr;
        toldAt_ = now;
        told_ = map_;
        return &told_;
    }

private:
    std::mutex mutex_; // of map_ and changed_
    StabilityMap map_, told_;
    bool changed_ = true; // the empty map is the first news
    double toldAt_ = 0.0; // wall clock [s]
};

/// With no more samples than a trajectory needs to be told from another.
Case lean(Case c)
{
    c.run.sampleInterval = std::max(c.run.sampleInterval, c.run.duration / mostSamples);
    return c;
}

/// So that no long one is left for the end.
void putLongestFirst(std::vector<Job>& jobs) { std::ranges::stable_sort(jobs, std::greater{}, &Job::cost); }

/// So that the map shows its whole early.
void scatter(std::vector<Job>& jobs)
{
    std::vector<Job> scattered;
    for (const std::size_t i : scatteredOrder(jobs.size())) scattered.push_back(std::move(jobs[i]));
    jobs = std::move(scattered);
}

/// In this order; `ended` may be called on any thread.
bool performJobs(const std::vector<Job>& jobs, int threads, const std::function<void(const Job&)>& ended,
                 const std::function<bool(double share, const std::string& doing)>& tell)
{
    std::vector<double> costs;
    for (const Job& job : jobs) costs.push_back(job.cost);
    WorkDone work(std::move(costs));
    return runParallel(
        jobs.size(), threads,
        [&](std::size_t i, const GoOn& goOn) {
            const Case c = lean(*jobs[i].c);
            *jobs[i].result = measureRun(c, {std::string(spacingOf(c))}, goOn, {.energyBalance = true}, work.teller(i));
            if (goOn()) ended(jobs[i]);
        },
        [&](std::size_t done) { return tell(work.share(), done < jobs.size() ? jobs[done].doing : std::string()); });
}

double costOf(const std::vector<Job>& jobs)
{
    return std::accumulate(jobs.begin(), jobs.end(), 0.0, [](double sum, const Job& job) { return sum + job.cost; });
}

/// Compares with the run whose setting is a tenth.
void judgeByCriterion(const StabilityTask& task, StabilityMap& map)
{
    for (StabilityCell& cell : map.cells) {
        const SweptMethod& method = task.rows[cell.row].methods[cell.method];
        if (method.key != "run.step") continue;
        const double wanted = tenth * method.settings[cell.setting].value;
        const ProvenReference& reference = map.references[cell.row];
        for (const StabilityCell& finer : map.cells) {
            if (finer.row != cell.row || finer.method != cell.method) continue;
            if (!(std::abs(method.settings[finer.setting].value - wanted) <= 1e-6 * wanted)) continue;
            CriterionResult& result = cell.criterion.emplace();
            result.finer = method.settings[finer.setting].label;
            result.endChanges = !sameOutcome(cell.run, finer.run);
            result.trajectoryChange = trajectoryError(cell.run, finer.run, 0).at(ErrorMeasure::Worst).value_or(0.0);
            const bool right = reference.endKnown && sameOutcome(cell.run, reference.run);
            if (!reference.endKnown)
                result.verdict = CriterionVerdict::NotDetermined;
            else if (right == result.endChanges)
                result.verdict = right ? CriterionVerdict::FalseAlarm : CriterionVerdict::Fooled;
            break;
        }
    }
}

} // namespace

bool performMap(const StabilityTask& task, int jobs, StabilityMap& map, const MapCallback& callback)
{
    map = {};
    map.references.resize(task.rows.size());
    for (std::size_t row = 0; row < task.rows.size(); ++row)
        for (std::size_t method = 0; method < task.rows[row].methods.size(); ++method)
            for (std::size_t setting = 0; setting < task.rows[row].methods[method].settings.size(); ++setting)
                map.cells.push_back({row, method, setting, false, {}, {}, {}});
    CellsSoFar soFar(map.cells);

    std::vector<Job> references, nudges, runs;
    std::vector<std::vector<MeasuredRun>> found(task.rows.size()), nudged(task.rows.size());
    const auto at = [&](std::size_t row) {
        return task.rows[row].label.empty() ? std::string() : " at " + task.rows[row].label;
    };
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        const std::vector<ReferenceCase>& cases = task.rows[row].references;
        found[row].resize(cases.size());
        for (std::size_t k = 0; k < cases.size(); ++k)
            references.push_back({&cases[k].c, &found[row][k], "reference" + at(row) + ": " + cases[k].label,
                                  expectedCost(cases[k].c), 0});
    }
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        StabilityCell& cell = map.cells[i];
        const SweptMethod& method = task.rows[cell.row].methods[cell.method];
        const MethodSetting& setting = method.settings[cell.setting];
        runs.push_back(
            {&setting.c, &cell.run, nameOf(method.name, setting.label) + at(cell.row), expectedCost(setting.c), i});
    }
    putLongestFirst(references);
    scatter(runs);
    const double all = costOf(references) + costOf(runs);
    const double proven = all > 0.0 ? (1.0 - nudgedShare) * costOf(references) / all : 0.0;
    const auto between = [&](double from, double to) {
        return [&, from, to](double share, const std::string& doing) {
            return !callback || callback(std::lerp(from, to, share), doing, soFar.news());
        };
    };
    const auto nothing = [](const Job&) {};
    if (!performJobs(references, jobs, nothing, between(0.0, proven))) return false;

    std::vector<std::vector<Case>> starts(task.rows.size());
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        const std::vector<ReferenceCase>& cases = task.rows[row].references;
        const ProvenReference& reference = map.references[row] =
            proveReference(cases, std::move(found[row]), task.rule.agreement);
        if (!reference.horizon || !reference.endKnown) continue;
        starts[row] = nudgedStarts(cases[reference.which].c);
        nudged[row].resize(starts[row].size());
        for (std::size_t k = 0; k < starts[row].size(); ++k)
            nudges.push_back({&starts[row][k], &nudged[row][k], "starts that hardly differ" + at(row),
                              expectedCost(starts[row][k]), 0});
    }
    putLongestFirst(nudges);
    if (!performJobs(nudges, jobs, nothing, between(proven, proven + nudgedShare))) return false;
    for (std::size_t row = 0; row < task.rows.size(); ++row) proveEnd(map.references[row], nudged[row]);

    const auto classified = [&](const Job& job) {
        StabilityCell& cell = map.cells[job.cell];
        cell.verdict = classify(*job.c, cell.run, map.references[cell.row], task.rule);
        cell.done = true;
        soFar.take(job.cell, cell);
    };
    if (!performJobs(runs, jobs, classified, between(proven + nudgedShare, 1.0))) return false;
    judgeByCriterion(task, map);
    return true;
}

} // namespace touchdown
