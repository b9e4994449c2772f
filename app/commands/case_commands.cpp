// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/case_commands.h"

#include "app/terminal/aligned_table.h"
#include "app/terminal/json_text.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"

namespace touchdown {

void complainOf(const CaseDocument& document)
{
    for (const InputProblem& warning : document.warnings) complain("warning: " + warning.text());
    for (const InputProblem& problem : document.problems) complain(problem.text());
}

CaseDocument openCaseToKeep(const std::string& name, const std::vector<std::string>& settings)
{
    CaseDocument document = openCase(name);
    if (const auto study = document.valid() ? std::nullopt : findStudySource(name)) {
        const std::string kind = study->kind.empty() ? "KIND" : study->kind;
        document.problems = {{document.name, 0, "",
                              "is a study, not a case; did you mean `touchdown study " + kind + ' ' + name + "`?"}};
    } else if (!settings.empty()) {
        applySettings(document, settings);
    }
    complainOf(document);
    return document;
}

CaseDocument openCaseOrComplain(const CaseArguments& arguments)
{
    CaseDocument document = openCaseToKeep(arguments.name, arguments.settings);
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

int listCommand(bool json)
{
    Json cases = Json::array(), studies = Json::array();
    std::vector<std::vector<std::string>> rows, studyRows;
    for (const SampleCase& sample : sampleCases()) {
        const Case c = parseCase(sample.text, sample.name).value;
        rows.push_back({sample.name, c.title});
        cases.push_back({{"name", sample.name},
                         {"title", c.title},
                         {"paper", c.about.paper},
                         {"watch", c.about.watch},
                         {"assumed", c.about.assumed}});
    }
    for (const SampleStudy& study : sampleStudies()) {
        studyRows.push_back({study.kind, study.name, study.title});
        studies.push_back({{"kind", study.kind}, {"name", study.name}, {"title", study.title}});
    }
    const std::vector<bool> left(3, true);
    print(json ? jsonText({{"cases", cases}, {"studies", studies}})
               : alignedTable(rows, left) + "\nStudies: touchdown study KIND NAME\n" + alignedTable(studyRows, left));
    return exitDone;
}

} // namespace touchdown
