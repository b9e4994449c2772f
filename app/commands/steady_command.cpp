// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/steady_command.h"

#include <optional>
#include <utility>
#include <vector>

#include "app/commands/case_commands.h"
#include "app/commands/steady_report.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/stop_signal.h"
#include "core/case_files/case_text.h"
#include "core/formats/output_file.h"
#include "core/results/steady_writer.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {
namespace {

// The fields of many states would take much memory, and only the file needs them.
SteadyResult withoutFields(SteadyResult result)
{
    result.pressure = {};
    result.gap = {};
    result.recess = {};
    return result;
}

} // namespace

int steadyCommand(SteadyArguments arguments)
{
    if (arguments.fixedAttitude) arguments.caseArguments.settings.emplace_back("steady.fixed_attitude=true");
    const CaseDocument document = openFilmCaseOrComplain(arguments.caseArguments);
    const bool good =
        targetIsGood("--out", arguments.out, checkOutputFile(arguments.out), arguments.caseArguments.name);
    if (!document.valid() || !good) return exitWrongInput;
    const Case& c = document.value;

    const StopSignal stop;
    std::optional<SteadyWriter> file;
    std::string problem;
    if (!arguments.out.empty()) problem = file.emplace().open(arguments.out, c, updateCaseText(document.text, c));
    if (!problem.empty()) {
        complain(problem);
        return exitWrongInput;
    }

    const std::vector<SteadySeriesPoint> series = seriesOf(c);
    ProgressLine line(arguments.progress);
    std::vector<SteadyState> states;
    for (const SteadySeriesPoint& point : series) {
        SteadyResult result = steady(caseAt(c, point), [&](const SteadyProgress& update) {
            Progress progress = progressOf(update);
            if (series.size() > 1)
                progress.activity = "state " + std::to_string(states.size() + 1) + " of " +
                                    std::to_string(series.size()) + ", " + progress.activity;
            line.show(std::move(progress));
            return !stop.requested();
        });
        if (file) problem = file->add(point, result);
        states.push_back({point, withoutFields(std::move(result))});
        if (!problem.empty() || states.back().result.status == SteadyStatus::Cancelled || stop.requested()) break;
    }
    line.end();

    SteadyStatus status = worstStatus(states);
    std::string message = worstMessage(states);
    if (states.size() < series.size() && problem.empty()) {
        status = SteadyStatus::Cancelled;
        message = "stopped after " + std::to_string(states.size()) + " of " + std::to_string(series.size()) + " states";
    }
    if (file && problem.empty()) problem = file->finish(status, message);
    print(arguments.json ? steadyJson(c, states, status, message) : steadyText(c, states));
    if (!problem.empty()) {
        complain("failed: " + problem);
        return exitNoAnswer;
    }
    if (status == SteadyStatus::Converged) return exitDone;
    complain(statusText(status, message));
    return exitNoAnswer;
}

} // namespace touchdown
