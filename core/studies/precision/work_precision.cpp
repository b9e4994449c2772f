// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/work_precision.h"
#include "core/studies/runs/expected_cost.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/studies/precision/precision_report.h"
#include "core/studies/precision/precision_runs.h"
#include "core/studies/precision/precision_task.h"
#include "core/studies/runs/ensemble.h"
#include "core/studies/study/study_reader.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double secondsBetweenReports = 0.5;
constexpr double knownEnsembles = 0.02; // of the ensembles that tells their pace

class PrecisionStudy {
public:
    PrecisionStudy(const PrecisionTask& task, int jobs, const StudyCallback& callback)
        : task_(task), jobs_(jobs), callback_(callback)
    {}

    StudyReport perform()
    {
        bool went = performRuns(task_, jobs_, runs_, [&](double left, const std::string& doing, bool changed) {
            if (changed) renew();
            return tell(left + (wantsEnsembles() ? secondsOfEnsembles() : 0.0), doing);
        });
        if (went && wantsEnsembles()) went = performEnsembles();
        StudyReport report = reportNow();
        if (went && !ensembles_.empty()) reportEnsembles(task_.start, task_.ensemble, ensembles_, report);
        if (!went) {
            report.status = StudyStatus::Cancelled;
            report.message = "stopped before all runs were made";
        } else if (!runs_.reference.problem.empty() && ensembles_.empty()) {
            report.status = StudyStatus::Failed;
            report.message = "there is no reference: " + runs_.reference.problem;
        } else if (!runs_.reference.problem.empty()) {
            report.warnings.push_back("There is no reference, so that no run has an error: " + runs_.reference.problem +
                                      ".");
        }
        const bool none = std::ranges::none_of(runs_.points, &PrecisionPoint::ran);
        if (report.status == StudyStatus::Completed && none && ensembles_.empty()) {
            report.status = StudyStatus::Failed;
            report.message = "the budget of " + fewDigitsOfTime(task_.budget) +
                             " was spent on the reference: no run was made; give it more";
        }
        return report;
    }

private:
    /// Of a film, which takes long, and whose references may part by their grids, they are made where they are asked
    /// for.
    bool wantsEnsembles() const
    {
        const ProvenReference& reference = runs_.reference;
        const bool known = !reference.label.empty() || !reference.problem.empty();
        const bool undetermined =
            known && !runs_.referencesLate && (reference.horizon || !reference.problem.empty() || !reference.endKnown);
        return task_.inTime && (task_.ensembleWanted || (undetermined && task_.start.model == ModelKind::Springs));
    }

    std::vector<Ensemble> plannedEnsembles() const
    {
        std::vector<Ensemble> all{{"reference", task_.ensembleReference.label, task_.ensembleReference.c, {}}};
        for (const SweptMethod& method : task_.methods)
            for (const MethodSetting& setting : method.settings)
                if (setting.inEnsemble) all.push_back({method.name, setting.label, setting.c, {}});
        return all;
    }

    /// All of them at the pace of the timed runs [s].
    double secondsOfEnsembles() const
    {
        double cost = 0.0;
        for (const Ensemble& each : plannedEnsembles()) cost += expectedCost(each.c);
        return runs_.secondsPerCost * cost * task_.ensemble.starts / std::max(jobs_, 1);
    }

    bool performEnsembles()
    {
        ensembles_ = plannedEnsembles();
        const double begin = wallClock(), expected = secondsOfEnsembles();
        const auto poll = [&](std::size_t done, double share) {
            const Ensemble& now =
                ensembles_[std::min(done / static_cast<std::size_t>(task_.ensemble.starts), ensembles_.size() - 1)];
            const double all = share > knownEnsembles ? (wallClock() - begin) / share : expected;
            return tell((1.0 - share) * all, "ensemble: " + now.method + ", " + now.setting);
        };
        return runEnsembles(ensembles_, task_.ensemble, jobs_, poll);
    }

    StudyReport reportNow() const
    {
        return runs_.reference.label.empty() ? StudyReport() : precisionReport(task_, runs_);
    }

    /// Not at every run: springs take a thousandth of a second, and a report is drawn.
    void renew()
    {
        if (wallClock() - reported_ < secondsBetweenReports) return;
        soFar_ = std::make_unique<StudyReport>(reportNow());
        reported_ = wallClock();
    }

    /// `left`: the time to the end, as expected [s].
    bool tell(double left, const std::string& doing)
    {
        const std::unique_ptr<StudyReport> report = std::exchange(soFar_, nullptr);
        const double passed = wallClock() - begin_;
        // More may be left than was expected: the bar waits.
        share_ = std::max(share_, passed > 0.0 ? passed / (passed + left) : 0.0);
        return !callback_ || callback_({share_, doing, report.get()});
    }

    const PrecisionTask& task_;
    int jobs_;
    const StudyCallback& callback_;
    PrecisionRuns runs_;
    std::vector<Ensemble> ensembles_;    // the first one is the reference
    std::unique_ptr<StudyReport> soFar_; // not reported yet
    double reported_ = 0.0;
    double share_ = 0.0; // told
    double begin_ = wallClock();
};

} // namespace

StudyPerformance planWorkPrecision(StudyReader& reader)
{
    return [task = readPrecisionTask(reader)](int jobs, const StudyCallback& callback) {
        return PrecisionStudy(task, jobs, callback).perform();
    };
}

} // namespace touchdown
