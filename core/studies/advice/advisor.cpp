// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/advisor.h"

#include <algorithm>
#include <optional>

#include "core/formats/quotation.h"
#include "core/simulation/run.h"
#include "core/studies/advice/advisor_report.h"
#include "core/studies/advice/advisor_study.h"
#include "core/studies/study/growing_report.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

const std::vector<std::string> models{"static",  "contact-rest", "wave-answer", "small-motion",
                                      "springs", "parts",        "sums"};

constexpr double longestBudget = 1e6; // [s]

StudyReport performAdvice(const AdvisorTask& task, int jobs, const StudyCallback& callback)
{
    const auto reportOf = [&](const AdvisorResult& result) {
        StudyReport report;
        report.kind = "advise";
        report.title = "No more model than the scene needs" + (task.start.title.empty() ? "" : ": " + task.start.title);
        reportAdvice(task, result, report);
        return report;
    };
    const auto tell = [&](double share, const std::string& doing, const AdvisorResult* more) {
        return tellProgress(callback, {share, doing}, more != nullptr, [&] { return reportOf(*more); });
    };
    return reportOf(advise(task, jobs, tell));
}

} // namespace

StudyPerformance planAdvisor(StudyReader& reader)
{
    AdvisorTask task;
    task.start = reader.start();
    if (task.start.model != ModelKind::Film)
        reader.add("case", "must be of model \"film\": the simpler models are made from a film");
    else if (const std::string reason = reasonNotToRun(task.start); !reason.empty())
        reader.add("case", "cannot be run in time: " + reason);
    else if (task.start.steady.fixedAttitude)
        reader.add("case",
                   "holds the slider at one attitude (steady.fixed_attitude = true); advice needs a slider that "
                   "flies");
    task.tolerance = reader.number("tolerance");
    task.spreadTolerance = reader.number("spread_tolerance");
    task.pilot = reader.number("pilot");
    task.confirm = reader.flag("confirm");
    task.all = reader.flag("all");
    task.budget = reader.number("budget");
    if (const auto chosen = reader.texts("models")) {
        for (const std::string& model : *chosen)
            if (std::ranges::find(models, model) == models.end())
                reader.add("models", inQuotes(model) + " is not known: allowed is " + choiceText(models));
        task.models = *chosen;
    }
    return [task](int jobs, const StudyCallback& callback) { return performAdvice(task, jobs, callback); };
}

StudyForm advisorForm(const Case&)
{
    const AdvisorTask task;
    StudyForm form;
    form.keys = {
        numberKey("tolerance", task.tolerance, "", "", 1e-5, 0.5,
                  "error of the mean spacing over the last tenth of the run that the advice may have"),
        numberKey("spread_tolerance", task.spreadTolerance, "", "", 1e-5, 2.0,
                  "the same for the standard deviation, or for tolerance times the mean where that is more"),
        numberKey("pilot", task.pilot, "", "", 0.05, 1.0,
                  "smallest part of the run that the full model computes; more where its end is not known by then"),
        booleanKey("confirm", task.confirm, "true: also run the full model and the advice to the end, and compare"),
        booleanKey("all", task.all, "true: also measure models that take too long to be advised"),
        numberKey("budget", task.budget, "s", "s", 0.01, longestBudget,
                  "wall time after which the study ends with the results it has"),
        listKey("models", models,
                "models to try: the static state; the state at rest in contact; the response to the waves of the disk; "
                "that response with the air bearing modes; two springs fitted to the film; the film without one part "
                "each; the film without several parts (which tries the single parts, too)"),
    };
    form.keys[0].shown = "1%";
    form.keys[1].shown = "10%";
    return form;
}

} // namespace touchdown
