// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/studies/runs/parallel.h"
#include "core/studies/runs/trajectory_error.h"

namespace touchdown {

namespace {

constexpr double mostSamples = 20000; // of a run
constexpr double tenth = 0.1;         // of a setting, which the paper's criterion compares

/// One run that is to be made.
struct Job {
    const Case* c = nullptr;
    MeasuredRun* result = nullptr;
    std::string doing;
    double cost = 0.0; // expected, in right-hand sides
};

double expectedCost(const Case& c)
{
    const bool fixed = c.model == ModelKind::Film ? c.run.steps == StepControl::Fixed : hasFixedStep(c.run.integrator);
    if (fixed) return 4.0 * c.run.duration / c.run.step;
    // Of fifth order, an oscillation of a microsecond at a time.
    if (c.model == ModelKind::Springs)
        return 60.0 * c.run.duration / 1e-6 * std::pow(1e-8 / std::max(c.run.tolerance, 1e-14), 0.2);
    return 4.0 * c.run.duration / 0.2e-6 * std::cbrt(5e-12 / c.run.stepError);
}

/// With no more samples than a trajectory needs to be told from another.
Case lean(Case c)
{
    c.run.sampleInterval = std::max(c.run.sampleInterval, c.run.duration / mostSamples);
    return c;
}

bool performJobs(std::vector<Job>& jobs, int threads, double begin, double end, const MapCallback& callback)
{
    std::ranges::stable_sort(jobs, std::greater{}, &Job::cost); // so that no long one is left for the end
    const double all =
        std::accumulate(jobs.begin(), jobs.end(), 0.0, [](double sum, const Job& job) { return sum + job.cost; });
    std::vector<double> before{0.0};
    for (const Job& job : jobs) before.push_back(before.back() + job.cost);
    return runParallel(
        jobs.size(), threads,
        [&](std::size_t i, const GoOn& goOn) {
            const Case c = lean(*jobs[i].c);
            *jobs[i].result = measureRun(c, {std::string(spacingOf(c))}, goOn, {.energyBalance = true});
        },
        [&](std::size_t done) {
            const std::string doing = done < jobs.size() ? jobs[done].doing : std::string();
            return !callback || callback(begin + (end - begin) * (all > 0.0 ? before[done] / all : 1.0), doing);
        });
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
                map.cells.push_back(
                    {.row = row, .method = method, .setting = setting, .run = {}, .verdict = {}, .criterion = {}});

    std::vector<Job> all;
    std::vector<std::vector<MeasuredRun>> references(task.rows.size()), nudged(task.rows.size());
    const auto at = [&](std::size_t row) {
        return task.rows[row].label.empty() ? std::string() : " at " + task.rows[row].label;
    };
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        const std::vector<ReferenceCase>& cases = task.rows[row].references;
        references[row].resize(cases.size());
        for (std::size_t k = 0; k < cases.size(); ++k)
            all.push_back({&cases[k].c, &references[row][k], "reference" + at(row) + ": " + cases[k].label,
                           expectedCost(cases[k].c)});
    }
    for (StabilityCell& cell : map.cells) {
        const SweptMethod& method = task.rows[cell.row].methods[cell.method];
        const MethodSetting& setting = method.settings[cell.setting];
        all.push_back(
            {&setting.c, &cell.run, nameOf(method.name, setting.label) + at(cell.row), expectedCost(setting.c)});
    }
    constexpr double nudgedFrom = 0.9; // of the way
    if (!performJobs(all, jobs, 0.0, nudgedFrom, callback)) return false;

    all.clear();
    std::vector<std::vector<Case>> starts(task.rows.size());
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        const std::vector<ReferenceCase>& cases = task.rows[row].references;
        const ProvenReference& reference = map.references[row] =
            proveReference(cases, std::move(references[row]), task.rule.agreement);
        if (!reference.horizon || !reference.endKnown) continue;
        starts[row] = nudgedStarts(cases[reference.which].c);
        nudged[row].resize(starts[row].size());
        for (std::size_t k = 0; k < starts[row].size(); ++k)
            all.push_back({&starts[row][k], &nudged[row][k], "starts that hardly differ" + at(row),
                           expectedCost(starts[row][k])});
    }
    if (!performJobs(all, jobs, nudgedFrom, 1.0, callback)) return false;
    for (std::size_t row = 0; row < task.rows.size(); ++row) proveEnd(map.references[row], nudged[row]);
    for (StabilityCell& cell : map.cells) {
        const Case& c = task.rows[cell.row].methods[cell.method].settings[cell.setting].c;
        cell.verdict = classify(c, cell.run, map.references[cell.row], task.rule);
    }
    judgeByCriterion(task, map);
    return true;
}

} // namespace touchdown
