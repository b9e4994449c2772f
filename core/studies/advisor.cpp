// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advisor.h"

#include "core/numerics/wall_clock.h"
#include "core/studies/advisor_report.h"

namespace touchdown {

namespace {

const std::vector<std::string> models{"static", "contact-rest", "wave-answer", "small-motion", "springs", "parts", "sums"};

StudyReport performAdvice(const AdvisorTask& task, int jobs, const StudyCallback& callback)
{
    const double begin = wallClock();
    const auto tell = [&](double share, const std::string& doing) {
        return !callback || callback({.share = share, .doing = doing, .soFar = nullptr});
    };
    const AdvisorResult result = advise(task, jobs, tell);
    StudyReport report;
    report.kind = "advise";
    report.title = "No more model than the scene needs";
    reportAdvice(task, result, report);
    report.wallSeconds = wallClock() - begin;
    return report;
}

} // namespace

StudyPerformance planAdvisor(StudyReader& reader)
{
    AdvisorTask task;
    task.start = reader.start();
    if (task.start.model != ModelKind::Film)
        reader.add("case", "must be of model \"film\": the ladder leaves out what a film has; springs are its last step");
    else if (const std::string reason = reasonNotToRun(task.start); !reason.empty())
        reader.add("case", "cannot be run in time: " + reason);
    task.tolerance = reader.number("tolerance", "", "", 1e-5, 0.5).value_or(task.tolerance);
    task.spreadTolerance = reader.number("spread_tolerance", "", "", 1e-5, 2.0).value_or(task.spreadTolerance);
    task.pilot = reader.number("pilot", "", "", 0.05, 1.0).value_or(task.pilot);
    task.confirm = reader.boolean("confirm").value_or(task.confirm);
    if (const auto chosen = reader.texts("models")) {
        for (const std::string& model : *chosen)
            if (std::ranges::find(models, model) == models.end())
                reader.add("models", "\"" + model + "\" is none of static, contact-rest, wave-answer, small-motion, springs, parts, sums");
        task.models = *chosen;
    }
    return [task](int jobs, const StudyCallback& callback) { return performAdvice(task, jobs, callback); };
}

std::string advisorTemplate(const Case&)
{
    return R"(tolerance = "1%"          # of the mean spacing over the last tenth of the run
spread_tolerance = "10%"  # of its standard deviation there, or of tolerance times the mean where that is more
pilot = 0.3               # least part of the run that the full model is given; more where the end is not known by then
confirm = false           # also take the full model and the advice to the end, and say what was claimed rightly
models = ["static", "contact-rest", "wave-answer", "small-motion", "springs", "parts", "sums"] # the ladder
)";
}

} // namespace touchdown
