// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "app/commands/run_source.h"
#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/refusal.h"
#include "app/terminal/report_text.h"
#include "app/terminal/stop_signals.h"
#include "core/case/disk_setup.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/results/run_output.h"
#include "core/simulation/contact/pad_way.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/work/large_pages.h"

namespace touchdown {

namespace {

// Present in the object of every model: scripts rely on them.
constexpr std::array finalKeys{
    "flying_height",  "minimum_spacing",   "pitch", "roll", "height", "contact_force", "adhesion_force",
    "friction_force", "air_bearing_force", "energy"};
constexpr std::array tailKeys{"flying_height", "minimum_spacing", "pitch", "roll", "contact_force"};

Json statisticsJson(const Statistics& s)
{
    return {{"mean", jsonNumber(s.mean)},
            {"std", jsonNumber(s.std)},
            {"min", jsonNumber(s.min)},
            {"max", jsonNumber(s.max)}};
}

Json finalJson(const Summary& summary)
{
    Json result = Json::object();
    for (const char* key : finalKeys) {
        const double* value = valueIn(summary.final, key);
        result[key] = value ? jsonNumber(*value) : Json(nullptr);
    }
    for (const auto& [key, value] : summary.final) result[key] = jsonNumber(value);
    return result;
}

Json tailJson(const Summary& summary)
{
    Json result = Json::object();
    for (const char* key : tailKeys) {
        const Statistics* value = valueIn(summary.tail, key);
        result[key] = value ? statisticsJson(*value) : Json(nullptr);
    }
    for (const auto& [key, value] : summary.tail) result[key] = statisticsJson(value);
    return result;
}

Json extremesJson(const Summary& summary)
{
    Json result = Json::object();
    for (const auto& [key, value] : summary.extremes)
        result[key] = {{"min", jsonNumber(value.least)}, {"max", jsonNumber(value.most)}};
    return result;
}

Json stepCheckJson(const std::optional<StepCheck>& check)
{
    if (!check) return nullptr;
    return {{"step", jsonNumber(check->step)},
            {"flying_height", jsonNumber(check->flyingHeight)},
            {"pitch", jsonNumber(check->pitch)},
            {"same_end_state", check->sameEndState},
            {"message", check->message}};
}

Json figuresJson(const std::vector<RunFigure>& figures)
{
    Json result = Json::object();
    for (const RunFigure& figure : figures) result[figure.quantity.name] = jsonNumber(figure.value);
    return result;
}

Json fitJson(const std::optional<CharacteristicFit>& fit)
{
    if (!fit) return nullptr;
    const auto errorJson = [](const CharacteristicError& error) -> Json {
        return {{"worst", jsonNumber(error.worst)}, {"rms", jsonNumber(error.rms)}, {"at", jsonNumber(error.at)}};
    };
    const OnoYamane& p = fit->parameters;
    return {{"meniscus_force", jsonNumber(p.meniscusForce)},
            {"contact_stiffness", jsonNumber(p.contactStiffness)},
            {"initial_contact_force", jsonNumber(p.initialContactForce)},
            {"touch_down", jsonNumber(p.touchDown)},
            {"take_off", jsonNumber(p.takeOff)},
            {"take_off_shape", name(p.takeOffShape)},
            {"cycle_work", jsonNumber(OnoYamaneLaw(p).cycleWork())},
            {"contact_error", errorJson(fit->contact)},
            {"adhesion_error", errorJson(fit->adhesion)},
            {"describes", fit->describes},
            {"message", fit->message}};
}

/// The message gives the reason of every null.
std::string jsonMessage(const Summary& summary, const std::vector<Quantity>& quantities)
{
    std::vector<std::string> missing; // in the model
    std::vector<std::string> unknown; // at the end of this run
    std::vector<std::string> doubtful;
    for (const char* key : finalKeys)
        if (!valueIn(summary.final, key)) (findQuantity(quantities, key) < 0 ? missing : unknown).emplace_back(key);
    for (const RunFigure& figure : summary.figures)
        if (std::isnan(figure.value)) doubtful.push_back(figure.quantity.name);
    std::string message = summary.message;
    const auto add = [&](const char* reason, const std::vector<std::string>& keys) {
        if (!keys.empty()) message += (message.empty() ? "" : "; ") + std::string(reason) + joined(keys);
    };
    add("null because this case does not have it: ", missing);
    add("null because the run gave no valid value: ", unknown);
    add("null because it is not known, see the warnings: ", doubtful);
    return message;
}

std::string fitText(const CharacteristicFit& fit)
{
    const OnoYamane& p = fit.parameters;
    std::string text = reportRow("fitted f_m, f_c0", displayed(p.meniscusForce, "mN", 4) + ", " +
                                                         displayed(p.initialContactForce, "mN", 4));
    text += reportRow("fitted k_c", displayed(p.contactStiffness, "N/m", 4));
    text += reportRow("fitted d_s, d_e", displayed(p.touchDown, "nm", 4) + ", " + displayed(p.takeOff, "nm", 4));
    text += reportRow("fitted shape",
                      std::string(name(p.takeOffShape)) + ", W " + displayed(OnoYamaneLaw(p).cycleWork(), "pJ", 4));
    return text + reportRow("fit", fit.message);
}

std::string shown(const std::vector<Quantity>& quantities, const std::string& key, double value)
{
    const int i = findQuantity(quantities, key);
    return i < 0 ? displayed(value, "") : displayedInFull(value, quantities[static_cast<std::size_t>(i)].displayUnit);
}

/// The switches and jumps of a pad, by separation.
std::string eventRows(const Case& c, const std::vector<RunEvent>& events)
{
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(events.size(), most); ++i)
        text += reportRow(events[i].name,
                          "at " + displayed(padSeparation(c, events[i].time), "nm", 5) +
                              (events[i].time > 0.5 * c.run.duration ? ", on the way out" : ", on the way in"));
    if (events.size() > most) text += reportRow("more events", std::to_string(events.size() - most));
    return text;
}

std::string figureRows(const Case& c, const std::vector<RunFigure>& figures)
{
    std::string text;
    for (const RunFigure& figure : figures) {
        const Quantity& quantity = figure.quantity;
        if (c.contact == noContact && quantity.name.starts_with("contact_")) continue;
        std::string label = quantity.name;
        std::ranges::replace(label, '_', ' ');
        const std::string unit = quantity.displayUnit == "1" ? "" : quantity.displayUnit;
        text += reportRow(label, std::isnan(figure.value) ? "not known"
                                 : figure.isCount         ? std::to_string(std::llround(figure.value))
                                                          : displayed(figure.value, unit, 5));
    }
    return text;
}

/// The time of a run that did not complete is written as in its message.
std::string endText(const Summary& summary)
{
    const bool completed = summary.status == RunStatus::Completed;
    return std::string(name(summary.status)) + " at " +
           (completed ? displayed(summary.endTime, "ms") : fewDigitsOfTime(summary.endTime, 4));
}

std::string solverTime(double seconds) { return displayed(seconds, seconds < 1.0 ? "ms" : "s", 3); }

/// Warnings of the case are left out: they were reported before the run.
std::string warningRows(const Case& c, const std::vector<std::string>& warnings)
{
    std::string text;
    std::vector<std::string> told;
    for (const CaseProblem& each : caseWarnings(c)) told.push_back(each.message);
    for (const InputProblem& each : checkDiskFile(c).warnings) told.push_back(each.text());
    for (const std::string& warning : warnings)
        if (std::ranges::find(told, warning) == told.end()) text += reportRow("warning", warning);
    return text;
}

/// Report of a contact run: approach and retraction of a pad.
std::string contactText(const Case& c, const Summary& summary)
{
    std::string text = c.title + "\n";
    text += reportRow("status", endText(summary));
    text += figureRows(c, summary.figures);
    text += eventRows(c, summary.events);
    if (summary.fit) text += fitText(*summary.fit);
    text +=
        reportRow("steps", std::to_string(summary.steps) + ", " + std::to_string(summary.evaluations) + " iterations");
    text += reportRow("solver time", solverTime(summary.solverSeconds));
    if (!c.about.assumed.empty()) text += reportRow("assumed", c.about.assumed);
    text += warningRows(c, summary.warnings);
    return text;
}

/// One object; numbers in SI, quantities that the model does not have as null.
std::string runJson(const Summary& summary, const std::vector<Quantity>& quantities)
{
    Json events = Json::array();
    for (const RunEvent& event : summary.events)
        events.push_back({{"time", jsonNumber(event.time)}, {"name", event.name}});
    Json peaks = Json::array();
    for (const Peak& peak : summary.peaks)
        peaks.push_back({{"frequency", jsonNumber(peak.frequency)}, {"amplitude", jsonNumber(peak.amplitude)}});
    return jsonText({{"status", name(summary.status)},
                     {"message", jsonMessage(summary, quantities)},
                     {"end_time", jsonNumber(summary.endTime)},
                     {"steps", summary.steps},
                     {"rejected_steps", summary.rejectedSteps},
                     {"evaluations", summary.evaluations},
                     {"wall_seconds", jsonNumber(summary.wallSeconds)},
                     {"solver_seconds", jsonNumber(summary.solverSeconds)},
                     {"model", summary.model},
                     {"integrator", summary.integrator},
                     {"final", finalJson(summary)},
                     {"tail", tailJson(summary)},
                     {"extremes", extremesJson(summary)},
                     {"motion", name(summary.verdict.motion)},
                     {"bouncing", summary.bouncing()},
                     {"bouncing_rule", summary.verdict.rule},
                     {"contact", name(summary.verdict.touch)},
                     {"forced", summary.verdict.forced},
                     {"swing", jsonNumber(summary.verdict.swing)},
                     {"rms", jsonNumber(summary.verdict.rms)},
                     {"frequency", jsonNumber(summary.verdict.frequency)},
                     {"spectrum", {{"peaks", peaks}}},
                     {"step_check", stepCheckJson(summary.stepCheck)},
                     {"figures", figuresJson(summary.figures)},
                     {"fit", fitJson(summary.fit)},
                     {"warnings", summary.warnings},
                     {"events", events}});
}

std::string runText(const Case& c, const Summary& summary, const std::vector<Quantity>& quantities)
{
    if (c.model == ModelKind::Contact) return contactText(c, summary);
    std::string text = c.title + "\n";
    text += reportRow("status", endText(summary));
    for (const auto& [key, label] :
         {std::pair{"flying_height", "final flying height"}, std::pair{"pitch", "final pitch"},
          std::pair{"roll", "final roll"}, std::pair{"air_bearing_force", "final bearing force"},
          std::pair{"net_contact_force", "final net contact"}})
        // The bearing force of the springs is relative to their static state.
        if (const double* value = valueIn(summary.final, key);
            value && (c.model == ModelKind::Film || std::string_view(key) != "air_bearing_force"))
            text += reportRow(label, shown(quantities, key, *value));
    // The same over a flat disk.
    const bool flat = findQuantity(quantities, "minimum_gap") < 0;
    const std::string above = flat ? "" : c.model == ModelKind::Film ? " above the mean plane" : " above the disk";
    if (const Statistics* tail = valueIn(summary.tail, "minimum_spacing"))
        text += reportRow("minimum spacing",
                          shown(quantities, "minimum_spacing", tail->min) + above + " at least, over the last 10 %");
    for (const auto& [key, label] :
         {std::pair{"minimum_spacing", "least min. spacing"}, std::pair{"rear_spacing", "least rear spacing"},
          std::pair{"minimum_gap", "least gap"}})
        if (const Extremes* extremes = valueIn(summary.extremes, key))
            text += reportRow(label, shown(quantities, key, extremes->least) +
                                         (key == std::string_view("minimum_gap") ? " above the disk" : above) +
                                         " in the whole run");
    if (!summary.verdict.rule.empty())
        text += reportRow("motion", textOf(summary.verdict) + ": " + summary.verdict.rule);
    for (std::size_t i = 0; i < summary.peaks.size(); ++i)
        text +=
            reportRow(i == 0 ? "spectrum peaks" : "", displayed(summary.peaks[i].frequency, "kHz") + ", amplitude " +
                                                          displayed(summary.peaks[i].amplitude, "nm"));
    text += figureRows(c, summary.figures);
    text += reportRow("events", std::to_string(summary.events.size()));
    text += reportRow("steps", std::to_string(summary.steps) + " (" + std::to_string(summary.rejectedSteps) +
                                   " rejected), " + std::to_string(summary.evaluations) +
                                   (c.model == ModelKind::Film ? " film iterations, " : " evaluations, ") +
                                   summary.integrator);
    text += reportRow("solver time", solverTime(summary.solverSeconds));
    if (summary.stepCheck) text += reportRow("step check", summary.stepCheck->message);
    text += warningRows(c, summary.warnings);
    return text;
}

} // namespace

int runCommand(const CommandArguments& arguments)
{
    RunSource source = openRunSource(arguments);
    const CaseDocument& document = source.document;
    std::vector<InputProblem> problems = document.problems;
    std::vector<std::filesystem::path> inputs = document.inputs();
    // A run that continues may take the place of its own file.
    if (source.isStored && !(source.resumes && source.out == arguments.name)) inputs.emplace_back(arguments.name);
    std::ranges::move(targetProblems({{"--out", source.out}, {"--csv", arguments.csv, true}}, inputs),
                      std::back_inserter(problems));
    if (arguments.checkpointEach && !(*arguments.checkpointEach >= 0.0 && *arguments.checkpointEach <= 1e6))
        problems.push_back({"", 0, "--checkpoint", "must be from 0 to 1e6 seconds"});
    else if (arguments.checkpointEach && source.out.empty())
        problems.push_back({"", 0, "--checkpoint", "needs --out FILE.h5: the states stand there"});
    if (problems.empty())
        if (const std::string reason = reasonNotToRun(document.value); !reason.empty())
            problems.push_back({document.name, 0, "", reason});
    if (!problems.empty()) return refuse(problems, arguments.json);

    ProgressLine line(arguments.progress);
    RunOutput output(
        document, {source.out, arguments.csv}, [] { return !stopRequested(); }, source.continued, source.heldUntil);
    if (!output.problem().empty()) return refuse({{"", 0, "", output.problem()}}, arguments.json);
    if (source.continued.from) {
        output.addBefore(source.samples, source.fields, source.continued);
        source.samples = {};
        source.fields = {};
    }
    const int spacing = findQuantity(output.quantities(), "minimum_spacing");
    std::optional<double> least; // of all samples so far [m]
    Summary summary;
    const auto receive = [&](const RunUpdate& update) {
        output.add(update);
        if (spacing >= 0)
            for (const double each : update.samples.columns[static_cast<std::size_t>(spacing)])
                least = std::min(least.value_or(each), each);
        summary.endTime = update.time;
        return line.show(runProgress(update.time, update.duration, least)) && output.problem().empty();
    };
    RunOptions options;
    if (!source.out.empty()) options.checkpointEach = arguments.checkpointEach.value_or(1.0);
    if (const auto& from = source.continued.from) options.from = {from, &from->at};
    preferLargePages(filmBytes(document.value));
    if (!fitsInMemory([&] { summary = run(document.value, receive, options); })) {
        summary.status = RunStatus::Failed;
        summary.message = outOfMemory(document.name);
    }
    line.end();
    if (!source.continued.remark.empty()) summary.warnings.push_back(source.continued.remark);

    output.finish(summary);
    if (!output.problem().empty()) {
        summary.status = RunStatus::Failed;
        summary.message = output.problem();
    }
    print(arguments.json ? runJson(summary, output.quantities())
                         : runText(document.value, summary, output.quantities()));
    if (summary.status == RunStatus::Completed) return exitDone;
    complain(statusText(name(summary.status), summary.message));
    return exitNoAnswer;
}

} // namespace touchdown
