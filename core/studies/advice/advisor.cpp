// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/advisor.h"

#include "core/numerics/wall_clock.h"
#include "core/simulation/run.h"
#include "core/studies/advice/advisor_report.h"

namespace touchdown {

namespace {

const std::vector<std::string> models{"static",  "contact-rest", "wave-answer", "small-motion",
                                      "springs", "parts",        "sums"};

constexpr double longestBudget = 1e6; // [s]

StudyReport performAdvice(const AdvisorTask& task, int jobs, const StudyCallback& callback)
{
    const double begin = wallClock();
    const auto reportOf = [&](const AdvisorResult& result) {
        StudyReport report;
        report.kind = "advise";
        report.title = "No more model than the scene needs" + (task.start.title.empty() ? "" : ": " + task.start.title);
        reportAdvice(task, result, report);
        report.wallSeconds = wallClock() - begin;
        return report;
    };
    const auto tell = [&](double share, const std::string& doing, const AdvisorResult* more) {
        if (!callback) return true;
        if (more == nullptr) return callback({.share = share, .doing = doing, .soFar = nullptr});
        const StudyReport soFar = reportOf(*more);
        return callback({.share = share, .doing = doing, .soFar = &soFar});
    };
    return reportOf(advise(task, jobs, tell));
}

} // namespace

StudyPerformance planAdvisor(StudyReader& reader)
{
    AdvisorTask task;
    task.start = reader.start();
    if (task.start.model != ModelKind::Film)
        reader.add("case",
                   "must be of model \"film\": the ladder leaves out what a film has; springs are its last step");
    else if (const std::string reason = reasonNotToRun(task.start); !reason.empty())
        reader.add("case", "cannot be run in time: " + reason);
    else if (task.start.steady.fixedAttitude)
        reader.add("case", "is meant for one attitude alone (steady.fixed_attitude = true): nothing says what carries "
                           "its load; advice is of one that flies");
    task.tolerance = reader.number("tolerance", "", "", 1e-5, 0.5).value_or(task.tolerance);
    task.spreadTolerance = reader.number("spread_tolerance", "", "", 1e-5, 2.0).value_or(task.spreadTolerance);
    task.pilot = reader.number("pilot", "", "", 0.05, 1.0).value_or(task.pilot);
    task.confirm = reader.boolean("confirm").value_or(task.confirm);
    task.all = reader.boolean("all").value_or(task.all);
    task.budget = reader.number("budget", "s", "s", 0.01, longestBudget).value_or(task.budget);
    if (const auto chosen = reader.texts("models")) {
        for (const std::string& model : *chosen)
            if (std::ranges::find(models, model) == models.end())
                reader.add("models",
                           "\"" + model +
                               "\" is none of static, contact-rest, wave-answer, small-motion, springs, parts, sums");
        task.models = *chosen;
    }
    return [task](int jobs, const StudyCallback& callback) { return performAdvice(task, jobs, callback); };
}

std::string advisorTemplate(const Case&)
{
    return R"(tolerance = "1%"          # of the mean spacing over the last tenth of the run, from 0.001% to 50%
spread_tolerance = "10%"  # of its standard deviation there, or of tolerance times the mean where that is more; from 0.001% to 200%
pilot = 0.3               # least part of the run that the full model is given, from 0.05 to 1; more where the end is not known by then
confirm = false           # true: also take the full model and the advice to the end, and say what was claimed rightly
all = false               # true: also measure models that take too long to be the advice
budget = "3600 s"         # after which the study ends with what it knows by then
models = ["static", "contact-rest", "wave-answer", "small-motion", "springs", "parts", "sums"] # the ladder, any of: the static state; where it rests in contact; what it answers to waves of the disk; that and its modes; two springs fitted to the film; the film without one part each; without several, and those
)";
}

} // namespace touchdown
