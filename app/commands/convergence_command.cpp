// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/convergence_command.h"

#include "app/commands/case_commands.h"
#include "app/commands/convergence_report.h"
#include "app/terminal/output_target.h"
#include "app/terminal/stop_signal.h"
#include "core/case_files/case_text.h"
#include "core/studies/convergence/convergence_file.h"

namespace touchdown {

int convergenceCommand(const ConvergenceArguments& arguments)
{
    const CaseDocument document = openCaseOrComplain(arguments.caseArguments);
    const bool good =
        targetsAreGood({{"--out", arguments.out}, {"--csv", arguments.csv}}, arguments.caseArguments.name);
    if (!document.valid() || !good) return exitWrongInput;
    if (const std::string reason = reasonNotToConverge(document.value, arguments.options); !reason.empty()) {
        complain(document.name + ": " + reason);
        return exitWrongInput;
    }

    const StopSignal stop;
    ConvergenceStudy study =
        studyConvergence(document.value, arguments.options, [&](int) { return !stop.requested(); });
    std::string problem;
    if (study.status == StudyStatus::Completed && !arguments.out.empty())
        problem = writeConvergence(arguments.out, document.value, updateCaseText(document.text, document.value), study);
    if (study.status == StudyStatus::Completed && !arguments.csv.empty() && problem.empty())
        problem = writeConvergenceCsv(arguments.csv, study);
    if (!problem.empty()) {
        study.status = StudyStatus::Failed;
        study.message = problem;
    }
    print(arguments.json ? convergenceJson(study) : convergenceText(document.value, study));
    if (study.status == StudyStatus::Completed) return exitDone;
    complain(std::string(name(study.status)) + ": " + study.message);
    return exitNoAnswer;
}

} // namespace touchdown
