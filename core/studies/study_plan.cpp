// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study_plan.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"
#include "core/formats/toml_document.h"
#include "core/formats/words.h"
#include "core/studies/advice/advisor.h"
#include "core/studies/convergence/convergence.h"
#include "core/studies/cycles/cycles.h"
#include "core/studies/design/design_study.h"
#include "core/studies/design/design_task.h"
#include "core/studies/hysteresis/hysteresis.h"
#include "core/studies/precision/precision_task.h"
#include "core/studies/precision/work_precision.h"
#include "core/studies/response/response.h"
#include "core/studies/stability/stability.h"
#include "core/studies/statements/statements.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study/study_file_reader.h"
#include "core/studies/study/study_head.h"
#include "core/studies/study/study_reader.h"
#include "core/studies/sweep/sweep.h"
#include "core/studies/sweep/sweep_form.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

const StudyKind* findStudy(const std::string& kind)
{
    const auto found = std::ranges::find(studyKinds(), kind, &StudyKind::name);
    return found == studyKinds().end() ? nullptr : &*found;
}

/// What may stand where a study is wanted.
struct Source {
    std::string text; // of a study's file; "" for a case
    std::string name;
    std::filesystem::path folder;
    std::optional<CaseDocument> given; // where the text names none
    bool instead = false;              // the given case stands for the one that the text names, with its changes
};

StudyPlan refuse(StudyPlan plan, std::string key, std::string message)
{
    plan.problems.push_back({plan.name, 0, std::move(key), std::move(message)});
    return plan;
}

void appendTo(std::vector<InputProblem>& all, const std::vector<InputProblem>& some)
{
    all.insert(all.end(), some.begin(), some.end());
}

/// What is wrong with the given case as it stands.
void checkGiven(CaseDocument& given)
{
    for (const CaseProblem& problem : checkCombinations(given.value)) given.problems.push_back(problem.in(given.name));
}

StudyPlan planStudy(const std::string& kind, Source source, const std::vector<std::string>& settings,
                    const std::vector<std::string>& options, OutsidePaths outside)
{
    StudyPlan plan;
    plan.kind = kind;
    plan.name = source.name;
    plan.text = source.text;
    plan.options = options;
    const StudyKind* study = findStudy(kind);
    if (study == nullptr) {
        std::vector<std::string> names;
        for (const StudyKind& each : studyKinds()) names.push_back(each.name);
        return refuse(std::move(plan), "",
                      inQuotes(kind) + " is no kind of study" + didYouMean(nearestName(kind, names)));
    }
    plan.openEnd = study->openEnd;
    TomlDocument toml = readStudyText(source.text);
    if (!toml.problem.empty()) {
        plan.problems.push_back({plan.name, toml.problemLine, "", toml.problem});
        return plan;
    }
    appendTo(plan.problems, applyOptions(toml, options));

    StudyReader reader(toml, plan.name, plan.start.value, plan.problems);
    reader.setPlace(source.folder, settings, outside);
    const std::string title = reader.text("title").value_or("");
    if (!isOfKind(reader, kind)) return plan;
    const bool takesGiven = source.given && !namesCase(reader);
    if (source.instead) {
        reader.settings("set"); // they are in the case
        plan.start = std::move(*source.given);
        applySettings(plan.start, settings, outside);
    } else if (takesGiven) {
        plan.start = changedStudyCase(reader, std::move(*source.given));
    } else if (auto start = openStudyCase(reader)) {
        plan.start = std::move(*start);
    } else {
        return plan;
    }
    plan.title = title.empty() ? plan.start.value.title : title;
    appendTo(plan.problems, plan.start.problems);
    if (!plan.start.valid()) return plan; // what the study's keys may be depends on the case
    const auto before = static_cast<std::ptrdiff_t>(plan.problems.size());
    reader.setKeys(study->form(plan.start.value).keys);
    StudyWork work = study->plan(reader);
    const auto isOfCase = [](const InputProblem& problem) { return problem.key == "case"; };
    // What a study misses beside a case that it cannot take follows from that, unless it was written.
    if (std::any_of(plan.problems.begin() + before, plan.problems.end(), isOfCase)) {
        const auto follows = [&](const InputProblem& problem) {
            return !isOfCase(problem) && problem.line == 0 && problem.file == plan.name;
        };
        plan.problems.erase(std::remove_if(plan.problems.begin() + before, plan.problems.end(), follows),
                            plan.problems.end());
    }
    reader.finish();
    plan.inputs = reader.inputs();
    for (const std::filesystem::path& file : plan.start.inputs()) plan.inputs.push_back(file);
    plan.inputs.emplace_back(plan.name);
    std::ranges::stable_sort(plan.problems, {}, &InputProblem::line);
    if (!plan.valid()) return plan;
    const bool named = !title.empty();
    const auto finished = [kind, named, title = plan.title](const auto& perform) {
        const double begin = wallClock();
        StudyReport report = perform();
        report.wallSeconds = wallClock() - begin;
        report.kind = kind;
        if (named || report.title.empty()) report.title = title;
        if (report.status == StudyStatus::Cancelled && report.message.empty())
            report.message = "stopped before it was done";
        return report;
    };
    if (auto* perform = std::get_if<StudyPerformance>(&work)) {
        plan.perform = [perform = std::move(*perform), finished](int jobs, const StudyCallback& callback) {
            return finished([&] { return perform(jobs, callback); });
        };
        return plan;
    }
    const auto list = std::make_shared<const ItemStudy>(std::move(std::get<ItemStudy>(work)));
    plan.items = list->count;
    plan.keepsFiles = list->keepsFiles;
    plan.caseOf = list->caseOf;
    plan.performList = [list, finished](const ItemOptions& parts, const StudyCallback& callback) {
        return finished([&] { return performItems(*list, parts, callback); });
    };
    plan.perform = [performList = plan.performList](int jobs, const StudyCallback& callback) {
        return performList({.jobs = jobs}, callback);
    };
    return plan;
}

/// A text that says what only a study says.
std::optional<StudySource> studyIn(std::string text)
{
    const TomlDocument toml = readStudyText(text);
    const auto find = [&](const char* key) { return std::ranges::find(toml.entries, key, &TomlEntry::key); };
    const auto kind = find("kind");
    if (kind == toml.entries.end() && find("case") == toml.entries.end()) return {};
    if (kind == toml.entries.end()) return StudySource{"", 0, std::move(text)};
    const auto* name = std::get_if<std::string>(&kind->value);
    return StudySource{name == nullptr ? "" : *name, kind->line, std::move(text)};
}

/// The text of a study in a file.
std::optional<StudySource> studyInFile(const std::filesystem::path& file)
{
    if (isCmlPath(file)) return {};
    auto content = readTextFile(file, maximumStudyFileSize);
    auto* text = std::get_if<std::string>(&content);
    return text == nullptr ? std::nullopt : studyIn(std::move(*text));
}

bool isFile(const std::string& name)
{
    std::error_code error;
    return std::filesystem::is_regular_file(name, error);
}

/// What a study wrote, with the case as it was studied.
std::optional<StoredStudy> storedIn(const std::string& file)
{
    if (lowerCase(std::filesystem::path(file).extension().string()) != ".h5" || !isFile(file)) return {};
    return readStudy(file);
}

/// With the case that the file holds in place of the one that its text names.
StudyPlan planStored(const std::string& kind, const StoredStudy& stored, const std::string& name,
                     const std::vector<std::string>& settings, const std::vector<std::string>& options,
                     OutsidePaths outside)
{
    Source source{stored.studyText, name, {}, parseCase(stored.caseText, name)};
    source.instead = true;
    std::vector<std::string> all = stored.options;
    all.insert(all.end(), options.begin(), options.end());
    return planStudy(kind, std::move(source), settings, all, outside);
}

CaseDocument openSample(const std::string& kind, const std::string& name, OutsidePaths outside)
{
    CaseDocument document = openCase(name, outside);
    if (document.valid() || document.problems.front().kind != ProblemKind::NotFound) return document;
    std::vector<std::string> names = sampleStudyNames(kind);
    for (const SampleCase& each : sampleCases()) names.push_back(each.name);
    std::string& message = document.problems.front().message;
    message = "is neither a file, a sample case nor a sample study of this kind";
    for (const SampleStudy& each : sampleStudies())
        if (each.name == name) message += "; it is one of kind " + inQuotes(each.kind);
    message += didYouMean(nearestName(name, names));
    return document;
}

} // namespace

std::span<const StudyKind> studyKinds()
{
    static const std::vector<StudyKind> kinds{
        {"sweep", "Any values of a case, varied",
         "Runs a case, or solves its static state or modes, over lists of values, grids or samples of any keys: one "
         "table, curves, maps, correlations",
         planSweep, sweepForm},
        {"work-precision", "Accuracy against speed",
         "Runs a case by several methods with several settings: the error of each against a proven reference, and its "
         "time",
         planWorkPrecision, workPrecisionForm},
        {"stability", "Stability where methods fail",
         "Shows where methods are stable, with the eigenvalues of the case, and how runs end over step and one "
         "parameter",
         planStability, stabilityForm},
        {"hysteresis", "Touch-down and take-off",
         "Moves a value of a case slowly there and back: where the slider touches down and takes off, beside the "
         "equilibria",
         planHysteresis, hysteresisForm},
        {"cycles", "Sustained bouncing",
         "Finds cycles on which a slider on springs, or on a linear film, bounces for ever, follows them over a "
         "parameter, and shows where they end",
         planCycles, cyclesForm},
        {"response", "Forced motion over the frequency",
         "Drives a slider on springs, or on a linear film, by waves of the disk, with the frequency going up and down: "
         "amplitude, phase, "
         "jumps, contact and period of the motion",
         planResponse, responseForm},
        {"advise", "No more model than the scene needs",
         "Tries a hierarchy of models on a film case, from small motions to the whole film, and advises the cheapest "
         "that is good enough",
         planAdvisor, advisorForm, true},
        {"design", "Values for a wanted flying attitude",
         "Searches for values of a film case with which its static state has the wanted flying height, attitude or "
         "forces",
         planDesign, designForm, true, "the search ends when its targets are reached"},
        {"convergence", "Convergence over the grid",
         "Solves the static state of films, or the closest approach of a contact case, on finer and finer grids: "
         "observed order and error",
         planConvergence, convergenceForm},
        {"statements", "What a text says, against what is found",
         "Runs what a text reports and checks its sentences and numbers one by one, with shares of starts where one "
         "run proves little",
         planStatements, statementsForm},
    };
    return kinds;
}

std::string studyKindIn(const std::string& fileOrName)
{
    if (const auto stored = storedIn(fileOrName)) return stored->report.kind;
    const auto source = findStudySource(fileOrName);
    return source ? source->kind : std::string();
}

std::optional<StudySource> findStudySource(const std::string& fileOrName)
{
    if (isFile(fileOrName)) return studyInFile(fileOrName);
    const auto named = [&](const auto& each) { return each.name == fileOrName; };
    if (std::ranges::any_of(sampleCases(), named)) return {};
    const auto sample = std::ranges::find_if(sampleStudies(), named);
    if (sample == sampleStudies().end()) return {};
    return studyIn(sample->text);
}

StudyPlan openStudy(const std::string& kind, const std::string& fileOrName, const std::vector<std::string>& settings,
                    const std::vector<std::string>& options, OutsidePaths outside)
{
    if (const auto stored = storedIn(fileOrName); stored && stored->problem.empty())
        return planStored(kind, *stored, fileOrName, settings, options, outside);
    if (isFile(fileOrName)) {
        const std::filesystem::path folder = std::filesystem::path(fileOrName).parent_path();
        if (auto study = studyInFile(fileOrName))
            return planStudy(kind, {std::move(study->text), fileOrName, folder.empty() ? "." : folder, {}}, settings,
                             options, outside);
    } else if (const SampleStudy* sample = findSampleStudy(kind, fileOrName)) {
        return planStudy(kind, {sample->text, sample->name, {}, {}}, settings, options, outside);
    }
    return planStudy(kind, {"", fileOrName, {}, openSample(kind, fileOrName, outside)}, settings, options, outside);
}

StudyPlan reopenStudy(const StoredStudy& stored)
{
    return planStored(stored.report.kind, stored, stored.report.title, {}, {}, OutsidePaths::Refused);
}

StudyPlan parseStudy(const std::string& kind, const std::string& text, const std::string& name,
                     const std::filesystem::path& folder, const Case* given, const std::vector<std::string>& settings,
                     const std::vector<std::string>& options)
{
    Source source{text, name, folder, {}};
    if (given != nullptr) {
        source.given.emplace();
        source.given->value = *given;
        source.given->name = "the case";
        source.given->text = formatCase(*given);
        source.given->folder = given->folder;
        checkGiven(*source.given);
    }
    return planStudy(kind, std::move(source), settings, options, OutsidePaths::Refused);
}

StudyForm studyForm(const std::string& kind, const Case& c)
{
    const StudyKind* study = findStudy(kind);
    if (study == nullptr) return {};
    StudyForm form = study->form(c);
    const std::vector<StudyKey> head = headKeys();
    form.keys.insert(form.keys.begin(), head.begin(), head.end());
    return form;
}

std::string studyTemplate(const std::string& kind, const Case& c)
{
    const StudyForm form = studyForm(kind, c);
    return form.keys.empty() ? std::string() : "kind = " + tomlString(kind) + "\n" + templateText(form);
}

std::string sweepTemplate(const Case& c, const std::string& key)
{
    StudyForm form = studyForm("sweep", c);
    form.lists = sweepLists(c, key);
    return "kind = " + tomlString("sweep") + "\n" + templateText(form);
}

std::vector<DescribedKey> studyKeys(const std::string& kind)
{
    std::vector<DescribedKey> keys;
    for (const ModelKind model : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact}) {
        const Case c = defaultsOf(model);
        const StudyPlan plan = parseStudy(kind, "", kind, {}, &c);
        const bool refused = std::ranges::find(plan.problems, "case", &InputProblem::key) != plan.problems.end();
        // A study that refuses all default cases, as it needs more than a model, is described with the last one.
        if (refused && (model != ModelKind::Contact || !keys.empty())) continue;
        for (const StudyKey& row : studyForm(kind, c).keys) {
            if (row.kind == StudyKeyKind::Table) continue;
            auto described =
                std::ranges::find_if(keys, [&](const DescribedKey& each) { return each.key.key == row.key; });
            if (described == keys.end()) {
                // A key of the root that another model has stands before all tables.
                const auto isOfTable = [](const DescribedKey& each) { return !tableOf(each.key.key).empty(); };
                if (tableOf(row.key).empty()) described = std::ranges::find_if(keys, isOfTable);
                described = keys.insert(described, {row, allowedText(row), {}});
            }
            described->varies = described->varies || described->allowed != allowedText(row);
            if (const std::string standard = defaultText(row); !standard.empty())
                described->standards.emplace_back(toText(c, *findParameter("model")), standard);
        }
    }
    return keys;
}

} // namespace touchdown
