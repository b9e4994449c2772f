// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/validate_command.h"

#include <algorithm>

#include "app/commands/case_commands.h"
#include "app/commands/study_command.h"
#include "app/terminal/json_text.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

Json jsonList(const std::vector<InputProblem>& problems)
{
    Json list = Json::array();
    for (const InputProblem& problem : problems)
        list.push_back({{"file", problem.file},
                        {"line", problem.line > 0 ? Json(problem.line) : Json(nullptr)},
                        {"key", problem.key},
                        {"message", problem.message}});
    return list;
}

Json validation(const char* what, const CaseDocument& document, const std::string& title,
                const std::vector<InputProblem>& problems)
{
    return {{what, document.name},
            {"title", title},
            {"valid", problems.empty()},
            {"problems", jsonList(problems)},
            {"warnings", jsonList(document.warnings)},
            {"unused", jsonList(document.unused)}};
}

/// What is wrong with the kind that a study names.
std::optional<InputProblem> kindProblem(const std::string& name, const StudySource& study)
{
    std::vector<std::string> kinds;
    for (const StudyKind& each : studyKinds()) kinds.push_back(each.name);
    if (std::ranges::find(kinds, study.kind) != kinds.end()) return {};
    std::string list;
    for (const std::string& each : kinds) list += (list.empty() ? "" : ", ") + each;
    const std::string said = study.kind.empty() ? "is missing: it is one of "
                                                : inQuotes(study.kind) + " is no kind of study: allowed is one of ";
    return InputProblem{name, study.kindLine, "kind", said + list + didYouMean(nearestName(study.kind, kinds))};
}

int validateStudy(const CaseArguments& arguments, const StudySource& study, bool json)
{
    StudyPlan plan;
    if (const auto problem = kindProblem(arguments.name, study))
        plan.problems.push_back(*problem);
    else
        plan = openStudy(study.kind, arguments.name, arguments.settings);
    CaseDocument& start = plan.start;
    start.name = arguments.name;
    complainOf(plan);
    if (json) {
        Json object = validation("study", start, plan.title, plan.problems);
        object["kind"] = study.kind;
        print(jsonText(object));
    } else if (plan.valid()) {
        print(arguments.name + ": valid, a study of kind " + study.kind + "\n");
    }
    return plan.valid() ? exitDone : exitWrongInput;
}

} // namespace

int validateCommand(const CaseArguments& arguments, bool json)
{
    if (const auto study = findStudySource(arguments.name)) return validateStudy(arguments, *study, json);
    const CaseDocument document = openCaseOrComplain(arguments);
    if (json)
        print(jsonText(validation("case", document, document.value.title, document.problems)));
    else if (document.valid())
        print(document.name + ": valid\n");
    return document.valid() ? exitDone : exitWrongInput;
}

} // namespace touchdown
