// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/cycles/bouncing_film.h"
#include "core/studies/cycles/bouncing_map_task.h"
#include "core/studies/cycles/cycle_keys.h"
#include "core/studies/cycles/cycles_report.h"
#include "core/studies/hysteresis/held_steps.h"
#include "core/studies/study/growing_report.h"
#include "core/studies/study/study_reader.h"
#include "core/work/parallel.h"

namespace touchdown {

namespace {

constexpr std::size_t mostBranches = 12;
constexpr double perturbation = 1e-3;  // of an unstable cycle, so that a run leaves it [-]
constexpr double mostOfBranches = 0.5; // of the time for them, when the range has been followed once
constexpr const char* standardKey = "ono_yamane.meniscus_force";

/// From no adhesion to twice the meniscus force at which W = 0, at most that of the case where there is none [N].
double largestMeniscusForce(const Case& c)
{
    const OnoYamane law = characteristic(c).value_or(OnoYamane());
    const double balanced = law.takeOff > law.touchDown ? meniscusForceForWork(law, 0.0) : 0.0;
    const double most = roundedTo(2.0 * balanced, 2);
    return most > 0.0 ? most : law.meniscusForce > 0.0 ? law.meniscusForce : 10e-3;
}

class CyclesPerformance {
public:
    CyclesPerformance(const CyclesTask& task, const StudyCallback& callback)
        : task_(task), callback_(callback), runs_(task_.values.size() * std::size_t(task_.starts))
    {}

    StudyReport perform(int jobs)
    {
        const std::size_t count = runs_.size();
        const auto search = [this](std::size_t i, const GoOn& goOn) { searchAt(i, goOn); };
        bool whole = runParallel(count, jobs, search, [this, count](std::size_t done) {
            return tell(0.5 * double(done) / double(count),
                        "run " + std::to_string(std::min(done + 1, count)) + " of " + std::to_string(count));
        });
        const auto trace = [this](std::size_t, const GoOn& goOn) { traceAll(goOn); };
        whole = whole && runParallel(1, 1, trace, [this](std::size_t) { return tell(0.5 + 0.5 * traced_, "cycles"); });
        CyclesResult& result = found();
        StudyReport report = cyclesReport(task_, result);
        if (!whole) return ended(report, StudyStatus::Cancelled, "stopped before all cycles were followed");
        if (std::ranges::all_of(result.runs, [](const BouncingRun& run) { return run.end == BouncingEnd::Failed; }))
            return ended(report, StudyStatus::Failed, "no run has a valid end: " + result.runs.front().problem);
        return report;
    }

private:
    std::optional<Case> caseAt(double value) const { return caseWith(task_.start, task_.parameter, value); }
    /// Null where the case is not valid there, or its motions are not found.
    std::shared_ptr<const BouncingSlider> sliderAt(double value, const GoOn& goOn) const
    {
        const std::optional<Case> c = caseAt(value);
        try {
            return c ? task_.sliderOf(*c, 0, goOn) : nullptr;
        } catch (const std::runtime_error&) {
            return nullptr;
        }
    }

    void searchAt(std::size_t i, const GoOn& goOn)
    {
        const double value = task_.values[i / std::size_t(task_.starts)];
        BouncingRun run;
        run.value = value;
        if (const std::optional<Case> c = caseAt(value)) {
            BouncingSearch search = task_.search;
            search.goOn = goOn;
            run = runOf(task_.sliderOf, *c, int(i % std::size_t(task_.starts)), value, search);
        } else {
            run.problem = "the case is not valid at " + task_.text.of(value);
        }
        if (run.end == BouncingEnd::Failed && !goOn()) return; // it was stopped
        const std::lock_guard lock(mutex_);
        runs_[i] = std::move(run);
        ++news_;
    }

    /// All that was found so far.
    CyclesResult& found()
    {
        result_.runs.clear();
        for (const std::optional<BouncingRun>& run : runs_)
            if (run) result_.runs.push_back(*run);
        return result_;
    }

    void keep(CycleBranch branch)
    {
        const std::lock_guard lock(mutex_);
        result_.branches.push_back(std::move(branch));
        ++news_;
    }

    /// In the order of the runs; a cycle on a branch that is known is not followed again.
    void traceAll(const GoOn& goOn)
    {
        double low = 1.0, high = 0.0; // of the range, between which branches have been followed
        const auto reached = [&](double share) {
            low = std::min(low, share);
            high = std::max(high, share);
            traced_ = std::max(traced_.load(), mostOfBranches * (high - low));
        };
        const CycleTrace trace{[this, goOn](double value) { return sliderAt(value, goOn); }, task_.from, task_.to, goOn,
                               reached};
        for (std::size_t i = 0; i < runs_.size() && result_.branches.size() < mostBranches && goOn(); ++i) {
            traced_ = std::max(traced_.load(), double(i) / double(runs_.size()));
            const std::optional<LimitCycle> cycle = runs_[i] ? runs_[i]->cycle : std::nullopt;
            if (!cycle) continue;
            const auto known = [&](const CycleBranch& branch) { return liesOn(branch, *cycle); };
            if (std::ranges::any_of(result_.branches, known)) continue;
            add(trace, *cycle);
        }
    }

    /// The branch of a cycle, then those that leave it at period doublings.
    void add(const CycleTrace& trace, const LimitCycle& cycle)
    {
        keep(traceCycle(trace, cycle));
        for (std::size_t k = result_.branches.size() - 1; k < result_.branches.size(); ++k) {
            const CycleBranch branch = result_.branches[k];
            for (const MarkedCycle& mark : branch.marks) {
                if (mark.kind != CycleMark::PeriodDoubling || mark.ends || result_.branches.size() >= mostBranches)
                    continue;
                const LimitCycle* unstable = unstableNear(branch, mark.point);
                const auto slider = unstable ? trace.sliderAt(unstable->value) : nullptr;
                if (!slider) continue;
                BouncingSearch search = task_.search;
                search.goOn = trace.goOn;
                const BouncingRun run =
                    searchCycle(*slider, unstable->value, search, Eigen::VectorXd((1.0 + perturbation) * unstable->x));
                const auto known = [&](const CycleBranch& each) { return liesOn(each, *run.cycle); };
                if (run.cycle && std::ranges::none_of(result_.branches, known)) keep(traceCycle(trace, *run.cycle));
            }
        }
    }

    /// A few points from a mark, on its unstable side.
    static const LimitCycle* unstableNear(const CycleBranch& branch, std::size_t mark)
    {
        for (const std::ptrdiff_t step : {3, -3, 1, -1}) {
            const std::ptrdiff_t i = std::ptrdiff_t(mark) + step;
            if (i < 0 || i >= std::ptrdiff_t(branch.points.size())) continue;
            if (!branch.points[std::size_t(i)].stable()) return &branch.points[std::size_t(i)];
        }
        return nullptr;
    }

    bool tell(double share, const std::string& doing)
    {
        const std::lock_guard lock(mutex_);
        return tellProgress(callback_, {share, doing}, std::exchange(news_, 0) > 0,
                            [this] { return withoutFindings(cyclesReport(task_, found())); });
    }

    const CyclesTask& task_;
    const StudyCallback& callback_;
    std::mutex mutex_;                             // of all below
    std::vector<std::optional<BouncingRun>> runs_; // that have ended
    CyclesResult result_;
    std::size_t news_ = 0; // since the last report
    std::atomic<double> traced_ = 0.0;
};

/// Whether a file with the table [map] has cycles followed as well.
bool asksForCycles(StudyReader& reader)
{
    return std::ranges::any_of(std::array{"parameter", "from", "to", "values", "crossings"},
                               [&](const char* key) { return reader.has(key); });
}

/// Progress of one part of the study, between two shares of the whole.
StudyCallback partOf(const StudyCallback& callback, double from, double to)
{
    if (!callback) return {};
    return [&callback, from, to](const StudyProgress& progress) {
        StudyProgress whole = progress;
        whole.share = std::lerp(from, to, progress.share);
        return callback(whole);
    };
}

/// The cycles, then the map, in one report.
StudyReport performBoth(const CyclesTask& cycles, const MarkedMapTask& map, int jobs, const StudyCallback& callback)
{
    // Runs; following the cycles takes about as long as they do.
    const double ofCycles = 2.0 * double(cycles.values.size()) * cycles.starts;
    const double ofMap = double(map.x.values.size() * map.y.values.size()) * map.starts;
    const double mapBegins = ofCycles / (ofCycles + ofMap);
    const StudyCallback first = partOf(callback, 0.0, mapBegins);
    StudyReport report = CyclesPerformance(cycles, first).perform(jobs);
    if (report.status != StudyStatus::Completed) return report;
    const auto withMap = [&](const StudyReport& ofTheMap) {
        StudyReport whole = report;
        whole.status = ofTheMap.status;
        whole.message = ofTheMap.message;
        whole.findings.insert(whole.findings.begin(), ofTheMap.findings.begin(), ofTheMap.findings.end());
        std::ranges::copy(ofTheMap.warnings, std::back_inserter(whole.warnings));
        std::ranges::copy(ofTheMap.charts, std::back_inserter(whole.charts));
        std::ranges::copy(ofTheMap.tables, std::back_inserter(whole.tables));
        return whole;
    };
    const StudyCallback second = partOf(callback, mapBegins, 1.0);
    return withMap(performItems(bouncingMapItems(map), {.jobs = jobs}, [&](const StudyProgress& progress) {
        if (!second) return true;
        if (progress.soFar == nullptr) return second(progress);
        const StudyReport whole = withMap(*progress.soFar);
        return second({progress.share, progress.doing, &whole});
    }));
}

} // namespace

StudyWork planCycles(StudyReader& reader)
{
    CyclesTask task;
    task.start = reader.start();
    const bool film = task.start.model == ModelKind::Film;
    if (!film && task.start.model != ModelKind::Springs) {
        reader.add("case", "is of model \"contact\": a study of cycles takes springs or a linear film");
        return {};
    }
    if (const std::string reason = film ? reasonAgainstBouncingFilm(task.start) : std::string(); !reason.empty()) {
        reader.add("case", reason);
        return {};
    }
    if (task.start.diskSurface.kind != DiskSurfaceKind::Flat) {
        reader.add("case", "has a disk that is not flat; cycles are sought above a flat one, which drives no motion "
                           "(disk.surface.kind = \"flat\")");
        return {};
    }
    if (!characteristic(task.start)) {
        const std::string law(contactLaw(task.start).name);
        reader.add("case", task.start.contact == noContact
                               ? "has no contact, so that every motion decays; a study of cycles takes contact = "
                                 "\"ono-yamane\""
                               : "has contact = \"" + law +
                                     "\"; a study of cycles takes contact = \"ono-yamane\", "
                                     "at whose touch-down each cycle is closed");
        return {};
    }
    const std::string keys = reader.text("parameter", neededKeys).value_or(standardKey);
    const int values = reader.integer("values");
    task.starts = reader.integer("starts");
    task.search.duration = reader.number("duration");
    task.search.mostCrossings = reader.integer("crossings");
    task.sliderOf = slidersLike(task.start);
    std::optional<MarkedMapTask> map;
    if (reader.has("map")) {
        map = readBouncingMap(reader, task.starts, task.search.duration);
        if (!asksForCycles(reader)) return map ? StudyWork(bouncingMapItems(*map)) : StudyWork();
    } else {
        for (const std::string& mark : reader.tables("mark"))
            reader.add(mark, "needs a map: the table [map] is missing");
    }
    const std::optional<Parameter> parameter = readKeys(reader, "parameter", keys, task.text);
    if (!parameter) return {};
    task.parameter = *parameter;
    const auto end = [&](const char* name, double own) {
        return readEnd(reader, name, *parameter, parameter->key == standardKey ? std::optional(own) : std::nullopt);
    };
    const std::optional<double> from = end("from", 0.0), to = end("to", largestMeniscusForce(task.start));
    if (!from || !to || !keepsFilm(reader, "parameter", *parameter, *from) ||
        !keepsFilm(reader, "parameter", *parameter, *to))
        return {};
    if (*from == *to) {
        reader.add("to", "is the same as from: there is nothing to follow");
        return {};
    }
    task.from = *from;
    task.to = *to;
    for (int i = 0; i < values; ++i) task.values.push_back(std::lerp(*from, *to, (i + 0.5) / values));
    return [task, map](int jobs, const StudyCallback& callback) {
        return map ? performBoth(task, *map, jobs, callback) : CyclesPerformance(task, callback).perform(jobs);
    };
}

StudyForm cyclesForm(const Case& c)
{
    const Parameter& force = *findParameter(standardKey);
    StudyForm form;
    form.keys = {
        textKey("parameter", standardKey, neededKeys, "what changes; several keys take the same value"),
        numberKey("from", 0.0, force.unit, force.displayUnit, force.minimum, force.maximum, "one end of the range"),
        numberKey("to", largestMeniscusForce(c), force.unit, force.displayUnit, force.minimum, force.maximum,
                  "the other end"),
        integerKey("values", 10, 1, 200, "in the range, at which runs are made"),
        integerKey("starts", 3, 1, 8, "at each value: as the case says, then lower and lower ones"),
        numberKey("duration", c.run.duration, "s", "us", 1e-6, 1.0, "of each run; its last part is judged"),
        integerKey("crossings", 8, 1, 32, "of the touch-down height in one cycle, at most"),
    };
    form.remark =
        "On springs, or on a film that is linear about its static state (film.motion = \"linear\"), under Ono and "
        "Yamane's contact over a flat disk. On a film the values that change are those of contact, friction, "
        "suspension, load and mass.";
    for (StudyKey& key : bouncingMapKeys(c, largestMeniscusForce(c))) form.keys.push_back(std::move(key));
    return form;
}

} // namespace touchdown
