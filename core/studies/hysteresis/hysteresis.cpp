// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/hysteresis.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/simulation/equilibria/film_branches.h"
#include "core/simulation/equilibria/film_equilibria.h"
#include "core/simulation/equilibria/spring_equilibria.h"
#include "core/simulation/run.h"
#include "core/studies/hysteresis/hysteresis_report.h"
#include "core/studies/study/growing_report.h"
#include "core/studies/study/study_reader.h"
#include "core/work/parallel.h"
#include "core/work/work_done.h"

namespace touchdown {

namespace {

constexpr int mostValues = 1000;
constexpr double traceShare = 0.2; // of the time, for the equilibria, on one thread
constexpr int filmLooks = 3;       // values at which equilibria of a film are sought, from which they are followed

struct Range {
    std::string key;
    double from, to; // [unit of the key]
    int steps;
    double hold; // [s]
};

/// What a film in time costs by node of its grid and second of the run, on one core: measured on two sliders, one
/// flying quietly and one falling into contact. Elastic contact of surfaces comes on top.
constexpr double leastCost = 0.5, mostCost = 5.0; // [s/s per node]
constexpr double patience = 600.0;                // for a study by its defaults [s]
constexpr double settling = 200e-6;               // what the disk drags through a film takes as long to leave it [s]

double nodesOf(const Case& c) { return double(c.film.nodes[0]) * c.film.nodes[1]; }

/// "some 1 to 9 min" for so many runs of a film; "" of springs, which take seconds.
std::string expectedTime(const Case& c, int runs, double hold)
{
    if (c.model != ModelKind::Film) return {};
    const double work = runs * hold * nodesOf(c);
    const bool minutes = mostCost * work >= 120.0;
    const double unit = minutes ? 60.0 : 1.0; // [s]
    const std::string least = fewDigits(leastCost * work / unit, "", 1),
                      most = fewDigits(mostCost * work / unit, "", 1);
    return "some " + least + " to " + most + (minutes ? " min" : " s");
}

/// Of a film the disk is slowed to half its speed, in a few steps and for as long as patience allows. Of springs the
/// static height falls from twice its value to a fifth, or as far as a spring has a spacing: as pressure or speed would
/// lower it, and so that an end takes off again.
Range defaultRange(const Case& c)
{
    if (c.model == ModelKind::Film) {
        constexpr int steps = 6, runs = 2 * (steps + 1);
        const double affordable = roundedTo(patience / (runs * mostCost * nodesOf(c)), 2);
        const double hold = std::min(c.run.duration, std::clamp(affordable, 0.25 * settling, settling));
        return {"disk.speed", c.disk.speed, 0.5 * c.disk.speed, steps, hold};
    }
    const double height = c.springs.flyingHeight;
    if (!(height > 0.0)) {
        if (const auto law = characteristic(c))
            return {"ono_yamane.meniscus_force", 5.0 * law->meniscusForce, 0.0, 40, c.run.duration};
        const double stiffness = c.springs.rearStiffness;
        return {"springs.rear_stiffness", stiffness, 0.5 * stiffness, 40, c.run.duration};
    }
    Range range{"springs.flying_height", roundedTo(2.0 * height, 2), 0.0, 40, c.run.duration};
    for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
        range.to = roundedTo(share * height, 2);
        Case lowest = c;
        lowest.springs.flyingHeight = range.to;
        if (checkCombinations(lowest).empty()) break;
    }
    return range;
}

std::string reasonNotToTrace(const Case& c)
{
    if (c.model != ModelKind::Springs) return reasonForNoFilmEquilibria(c);
    return c.diskSurface.kind == DiskSurfaceKind::Flat
               ? ""
               : "equilibria of springs are followed above a flat disk only (disk.surface.kind = \"flat\")";
}

/// Its branches lie on one grid.
std::string reasonNotToTrace(const Case& c, const std::string& key)
{
    if (c.model == ModelKind::Film && (key == "slider.length" || key == "slider.width"))
        return "equilibria of a film are followed on one grid over the slider, which " + key + " would change";
    return reasonNotToTrace(c);
}

struct Plan {
    HeldSteps steps;
    bool equilibria = true;
    std::string notTraced; // why no equilibria are sought though nobody said so, in a sentence
};

class HysteresisPerformance {
public:
    HysteresisPerformance(const Plan& plan, const StudyCallback& callback)
        : plan_(plan), task_(plan.steps), callback_(callback), work_(std::vector(task_.count(), 1.0))
    {
        result_.steps.resize(task_.count());
        for (std::size_t i = 0; i < result_.steps.size(); ++i)
            result_.steps[i].value = task_.values[i % task_.values.size()];
    }

    StudyReport perform(int jobs)
    {
        const std::size_t sweeps = task_.fresh ? task_.values.size() : 1;
        stepWarnings_.resize(sweeps);
        const std::size_t traces = plan_.equilibria ? 1 : 0;
        const std::size_t tasks = traces + sweeps;
        beside_ = jobs > 1;
        // The equilibria are one task; there and back is another, since each value needs the one before.
        const auto work = [&](std::size_t i, const GoOn& goOn) {
            if (i < traces)
                trace(goOn);
            else if (task_.fresh)
                holdFresh(i - traces, goOn);
            else
                holdAll(
                    task_, goOn, [this](std::size_t k, HeldStep&& step) { take(k, std::move(step)); },
                    stepWarnings_.front(), [this](std::size_t k) { return work_.teller(k); });
        };
        const bool whole = runParallel(tasks, jobs, work, [this](std::size_t) { return tell(); });
        if (!task_.fresh && task_.start.model == ModelKind::Film)
            result_.warnings.push_back(
                std::string("each value begins with the air steady at the attitude of the one before") +
                (contactLaw(task_.start).remembers ? ", and without what contact and adhesion remember of the way there"
                                                   : ""));
        addStepWarnings();
        if (!plan_.notTraced.empty()) result_.warnings.push_back(plan_.notTraced);
        StudyReport report = hysteresisReport(task_, result_);
        return whole ? report : ended(report, StudyStatus::Cancelled, "stopped before all values were held");
    }

private:
    void take(std::size_t i, HeldStep&& step)
    {
        const std::lock_guard lock(mutex_);
        result_.steps[i] = std::move(step);
        ++held_;
    }

    void holdFresh(std::size_t i, const GoOn& goOn)
    {
        HeldEnd none;
        HeldStep step = holdValue(task_, task_.values[i], none, stepWarnings_[i], goOn, work_.teller(i));
        if (!goOn()) return;
        step.done = true;
        take(i, std::move(step));
    }

    /// In the order of the values, whatever thread came first.
    void addStepWarnings()
    {
        std::vector<std::string>& all = result_.warnings;
        for (const std::vector<std::string>& list : stepWarnings_)
            for (const std::string& warning : list)
                if (std::ranges::find(all, warning) == all.end()) all.push_back(warning);
    }

    void trace(const GoOn& goOn)
    {
        const CaseAt caseAt = [this](double value) { return caseWith(task_.start, task_.parameter, value); };
        const auto tell = [&](double share) {
            traced_ = share;
            return goOn();
        };
        const double from = task_.values.front(), to = task_.values.back();
        if (task_.start.model == ModelKind::Film) {
            const EquilibriumBranches found = traceFilmBranches(caseAt, from, to, filmLooks, tell);
            if (found.stopped) return;
            const std::lock_guard lock(mutex_);
            addFilmEquilibria(found, result_);
        } else {
            const int looks = std::clamp(static_cast<int>(task_.values.size()), 9, 65);
            const EquilibriumBranches found = traceSpringEquilibria(caseAt, from, to, looks, tell);
            if (found.stopped) return;
            const std::lock_guard lock(mutex_);
            addSpringEquilibria(found, result_);
        }
        traced_ = 1.0;
    }

    /// Of two tasks beside each other, the slower one decides.
    double share() const
    {
        const double held = work_.share(), traced = traced_;
        if (!plan_.equilibria) return held;
        return beside_ ? std::min(held, traced) : std::lerp(held, traced, traceShare);
    }

    bool tell()
    {
        const std::lock_guard lock(mutex_);
        std::string doing = parameterText(task_.parameter).label + ", " + std::to_string(held_) + " of " +
                            std::to_string(result_.steps.size()) + " values";
        if (const std::string time = expectedTime(task_.start, static_cast<int>(task_.count()), task_.hold);
            held_ == 0 && !time.empty())
            doing += ", " + time + " in all by an estimate";
        return tellProgress(callback_, {share(), doing}, std::exchange(told_, held_) < held_,
                            [this] { return withoutFindings(hysteresisReport(task_, result_)); });
    }

    const Plan& plan_;
    const HeldSteps& task_;
    const StudyCallback& callback_;
    WorkDone work_;       // of the values that are held
    bool beside_ = false; // the equilibria are sought beside the runs, not before them
    std::mutex mutex_;    // of all below
    HysteresisResult result_;
    std::vector<std::vector<std::string>> stepWarnings_; // each by its own task; not of the mutex
    std::size_t held_ = 0, told_ = 0;
    std::atomic<double> traced_ = 0.0;
};

/// The key and its ends, each within the case's ranges; false where there is a problem.
bool readRange(StudyReader& reader, const Range& standard, HeldSteps& steps)
{
    const std::string key = reader.text("parameter", "a key of the case in quotation marks").value_or(standard.key);
    const auto found = sceneKey(reader.start(), key);
    if (const auto* problem = std::get_if<std::string>(&found)) {
        reader.add("parameter", inQuotes(key) + " " + *problem);
        return false;
    }
    steps.parameter = std::get<Parameter>(found);
    const auto end = [&](const char* name, double own) {
        return readEnd(reader, name, steps.parameter, key == standard.key ? std::optional(own) : std::nullopt);
    };
    const std::optional<double> from = end("from", standard.from), to = end("to", standard.to);
    if (!from || !to) return false;
    if (*from == *to) {
        reader.add("to", "is the same as from: there is nothing to move");
        return false;
    }
    steps.values = {*from, *to};
    return true;
}

} // namespace

StudyPerformance planHysteresis(StudyReader& reader)
{
    const Case& c = reader.start();
    Plan plan;
    plan.steps.start = c;
    if (c.model == ModelKind::Contact) {
        reader.add("case", "is of model \"contact\", whose pad follows a prescribed motion; a hysteresis study takes a "
                           "case of model \"springs\" or \"film\"");
        return {};
    }
    const Range standard = defaultRange(c);
    const bool ranged = readRange(reader, standard, plan.steps);
    const int count = reader.integer("steps");
    plan.steps.hold = reader.number("hold");
    const std::optional<bool> anew = reader.boolean("anew");
    const std::string reasonNot = reasonNotToTrace(c, plan.steps.parameter.key);
    const std::optional<bool> asked = reader.boolean("equilibria");
    const bool wanted = asked.value_or(reasonNot.empty());
    if (wanted && !reasonNot.empty()) reader.add("equilibria", reasonNot);
    if (!asked && reasonNotToTrace(c).empty()) plan.notTraced = reasonNot;
    if (const std::string reason = reasonNotToRun(c); !reason.empty()) reader.add("case", reason);
    if (c.model == ModelKind::Film && c.steady.fixedAttitude)
        reader.add("case", "is meant for one attitude alone (steady.fixed_attitude = true): nothing says what carries "
                           "its load; a hysteresis study takes one that flies");
    if (!ranged) return {};

    plan.equilibria = wanted;
    const bool ofStart = belongsToStart(plan.steps.parameter.key);
    plan.steps.fresh = anew.value_or(ofStart);
    if (ofStart && !plan.steps.fresh) {
        reader.add("anew",
                   plan.steps.parameter.key +
                       " belongs to the start: each value begins anew, and nothing can be carried over (anew = true)");
        return {};
    }
    const double from = plan.steps.values.front(), to = plan.steps.values.back();
    plan.steps.values.clear();
    for (int i = 0; i <= count; ++i) plan.steps.values.push_back(std::lerp(from, to, double(i) / count));
    return
        [plan](int jobs, const StudyCallback& callback) { return HysteresisPerformance(plan, callback).perform(jobs); };
}

StudyForm hysteresisForm(const Case& c)
{
    const Range range = defaultRange(c);
    const Parameter& parameter = *findParameter(range.key);
    StudyForm form;
    form.keys = {
        textKey("parameter", range.key, "a key of the case in quotation marks", "the number of the case that moves"),
        numberKey("from", range.from, parameter.unit, parameter.displayUnit, parameter.minimum, parameter.maximum,
                  "the first value; it starts as the case says"),
        numberKey("to", range.to, parameter.unit, parameter.displayUnit, parameter.minimum, parameter.maximum,
                  "the last value, from which the way leads back"),
        integerKey("steps", range.steps, 1, mostValues - 1, "from one end to the other"),
        numberKey("hold", range.hold, "s", "us", 1e-7, 1.0, "time at each value; its last tenth is evaluated"),
        booleanKey("anew", false, "true: each value starts as the case says, one way only; always so for initial.*"),
        booleanKey("equilibria", true, "all equilibria and their stability"),
    };
    if (!reasonNotToTrace(c).empty()) form.keys.back().standard = {};
    const int runs = 2 * (range.steps + 1);
    if (const std::string time = expectedTime(c, runs, range.hold); !time.empty())
        form.remark = std::to_string(runs) + " runs of the film take " + time +
                      " (estimate), plus equilibria and contact of surfaces. Fewer steps, a shorter hold or fewer "
                      "film.nodes take less; with a hold below " +
                      fewDigits(settling, "us") + " the film may not have settled.";
    return form;
}

} // namespace touchdown
