// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/studies/parallel.h"

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
    const bool fixed = c.model == ModelKind::Film ? c.run.steps == StepControl::Fixed
                                                  : c.run.integrator != IntegratorKind::Dopri5 && c.run.integrator != IntegratorKind::Cvode;
    if (fixed) return 4.0 * c.run.duration / c.run.step;
    // Of fifth order, an oscillation of a microsecond at a time.
    if (c.model == ModelKind::Springs) return 60.0 * c.run.duration / 1e-6 * std::pow(1e-8 / std::max(c.run.tolerance, 1e-14), 0.2);
    return 4.0 * c.run.duration / 0.2e-6 * std::cbrt(5e-12 / c.run.stepError);
}

/// Without what costs time beside the solution, and with no more samples than a trajectory needs to be told from another.
Case lean(Case c)
{
    c.run.stepCheck = false;
    c.run.fieldSnapshots = 0;
    c.run.sampleInterval = std::max(c.run.sampleInterval, c.run.duration / mostSamples);
    return c;
}

bool performJobs(std::vector<Job>& jobs, int threads, double begin, double end, const MapCallback& callback)
{
    std::ranges::stable_sort(jobs, std::greater{}, &Job::cost); // so that no long one is left for the end
    const double all = std::accumulate(jobs.begin(), jobs.end(), 0.0, [](double sum, const Job& job) { return sum + job.cost; });
    std::vector<double> before{0.0};
    for (const Job& job : jobs) before.push_back(before.back() + job.cost);
    return runParallel(
        jobs.size(), threads,
        [&](std::size_t i, const GoOn& goOn) {
            const Case c = lean(*jobs[i].c);
            *jobs[i].result = measureRun(c, {std::string(spacingOf(c))}, goOn, {.energyBooks = true});
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
        const PrecisionMethod& method = task.rows[cell.row].methods[cell.method];
        if (method.key != "run.step") continue;
        const double wanted = tenth * settingValue(method, method.settings[cell.setting]);
        for (const StabilityCell& finer : map.cells) {
            if (finer.row != cell.row || finer.method != cell.method) continue;
            const double value = settingValue(method, method.settings[finer.setting]);
            if (!(std::abs(value - wanted) <= 1e-6 * wanted)) continue;
            CriterionResult& result = cell.criterion.emplace();
            result.finer = method.settings[finer.setting].label;
            result.endChanges = !sameOutcome(cell.run, finer.run);
            result.trajectoryChange = largestDistance(cell.run, finer.run);
            const ReferenceRun& reference = map.references[cell.row];
            if (result.endChanges) result.verdict = reference.endKnown ? CriterionVerdict::CriesWolf : CriterionVerdict::Right;
            else if (reference.endKnown) result.verdict = sameOutcome(finer.run, reference.run) ? CriterionVerdict::Right : CriterionVerdict::Fooled;
            else result.verdict = CriterionVerdict::Fooled; // there is no one answer to agree on
            break;
        }
    }
}

} // namespace

std::string_view name(CriterionVerdict verdict)
{
    switch (verdict) {
    case CriterionVerdict::Right: return "right";
    case CriterionVerdict::Fooled: return "fooled";
    case CriterionVerdict::CriesWolf: return "cries wolf";
    }
    return {};
}

double settingValue(const PrecisionMethod& method, const PrecisionSetting& setting)
{
    const Field* field = findField(method.key);
    if (field == nullptr) return std::nan("");
    const FieldValue value = field->get(setting.c);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* whole = std::get_if<int>(&value)) return *whole;
    if (const auto* list = std::get_if<std::vector<double>>(&value); list != nullptr && !list->empty()) return list->front();
    return std::nan("");
}

bool performMap(const StabilityTask& task, int jobs, StabilityMap& map, const MapCallback& callback)
{
    map = {};
    map.references.resize(task.rows.size());
    for (std::size_t row = 0; row < task.rows.size(); ++row)
        for (std::size_t method = 0; method < task.rows[row].methods.size(); ++method)
            for (std::size_t setting = 0; setting < task.rows[row].methods[method].settings.size(); ++setting)
                map.cells.push_back({.row = row, .method = method, .setting = setting, .run = {}, .verdict = {}, .criterion = {}});

    std::vector<Job> all;
    const auto at = [&](std::size_t row) { return task.rows[row].label.empty() ? std::string() : " at " + task.rows[row].label; };
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        const ReferenceCases& cases = task.rows[row].references;
        all.push_back({&cases.reference, &map.references[row].run, "reference" + at(row), expectedCost(cases.reference)});
        all.push_back({&cases.check, &map.references[row].check, "second reference" + at(row), expectedCost(cases.check)});
    }
    for (StabilityCell& cell : map.cells) {
        const PrecisionMethod& method = task.rows[cell.row].methods[cell.method];
        const PrecisionSetting& setting = method.settings[cell.setting];
        all.push_back({&setting.c, &cell.run, method.name + ", " + setting.label + at(cell.row), expectedCost(setting.c)});
    }
    constexpr double nudgedFrom = 0.9; // of the way
    if (!performJobs(all, jobs, 0.0, nudgedFrom, callback)) return false;

    std::vector<Job> nudged;
    for (std::size_t row = 0; row < task.rows.size(); ++row) {
        ReferenceRun& reference = map.references[row];
        judgeReference(reference, task.rule);
        if (!reference.horizon && reference.endKnown) continue;
        const std::vector<Case>& cases = task.rows[row].references.nudged;
        reference.nudged.resize(cases.size());
        for (std::size_t k = 0; k < cases.size(); ++k)
            nudged.push_back({&cases[k], &reference.nudged[k], "starts that hardly differ" + at(row), expectedCost(cases[k])});
    }
    if (!performJobs(nudged, jobs, nudgedFrom, 1.0, callback)) return false;
    for (ReferenceRun& reference : map.references) judgeReference(reference, task.rule);
    for (StabilityCell& cell : map.cells) {
        const Case& c = task.rows[cell.row].methods[cell.method].settings[cell.setting].c;
        cell.verdict = classify(c, cell.run, map.references[cell.row], task.rule);
    }
    judgeByCriterion(task, map);
    return true;
}

} // namespace touchdown
