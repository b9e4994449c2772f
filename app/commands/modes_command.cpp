// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/modes_command.h"

#include "app/commands/case_commands.h"
#include "app/commands/modes_report.h"
#include "app/commands/steady_report.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/stop_signal.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {

int modesCommand(const ModesArguments& arguments)
{
    const CaseDocument document = openFilmCaseOrComplain(arguments.caseArguments);
    if (!document.valid()) return exitWrongInput;
    const StopSignal stop;
    ProgressLine line(arguments.progress);
    const ModesResult result = modes(document.value, [&](const SteadyProgress& update) {
        line.show(progressOf(update));
        return !stop.requested();
    });
    line.end();
    print(arguments.json ? modesJson(document.value, result) : modesText(document.value, result));
    if (result.status == SteadyStatus::Converged) return exitDone;
    complain(statusText(result.status, result.message));
    return exitNoAnswer;
}

} // namespace touchdown
