// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/case_commands.h"

#include <algorithm>

#include "app/json_text.h"

namespace touchdown {

void complainOf(const CaseDocument& document)
{
    for (const InputProblem& warning : document.warnings) complain("warning: " + warning.text());
    for (const InputProblem& problem : document.problems) complain(problem.text());
}

CaseDocument openCaseOrComplain(const CaseArguments& arguments)
{
    CaseDocument document = openCase(arguments.name);
    if (!arguments.settings.empty()) applySettings(document, arguments.settings);
    complainOf(document);
    for (const InputProblem& unused : document.unused) complain("warning: " + unused.text());
    return document;
}

CaseDocument openFilmCaseOrComplain(const CaseArguments& arguments)
{
    CaseDocument document = openCaseOrComplain(arguments);
    if (!document.valid() || document.value.model == ModelKind::Film) return document;
    document.problems.push_back({document.name, 0, "model", "must be \"film\" for a static state on an air film"});
    complain(document.problems.back().text());
    return document;
}

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

} // namespace

int validateCommand(const CaseArguments& arguments, bool json)
{
    const CaseDocument document = openCaseOrComplain(arguments);
    if (json) {
        print(jsonText({{"case", document.name},
                        {"title", document.value.title},
                        {"valid", document.valid()},
                        {"problems", jsonList(document.problems)},
                        {"warnings", jsonList(document.warnings)},
                        {"unused", jsonList(document.unused)}}));
    } else if (document.valid()) {
        print(document.name + ": valid\n");
    }
    return document.valid() ? exitDone : exitWrongInput;
}

int listCommand(bool json)
{
    Json all = Json::array();
    std::string table;
    std::size_t width = 0;
    for (const SampleCase& sample : sampleCases()) width = std::max(width, sample.name.size());
    for (const SampleCase& sample : sampleCases()) {
        const Case c = parseCase(sample.text, sample.name).value;
        table += sample.name + std::string(width + 2 - sample.name.size(), ' ') + c.title + "\n";
        all.push_back({{"name", sample.name},
                       {"title", c.title},
                       {"paper", c.about.paper},
                       {"watch", c.about.watch},
                       {"assumed", c.about.assumed}});
    }
    print(json ? jsonText({{"cases", all}}) : table);
    return exitDone;
}

} // namespace touchdown
