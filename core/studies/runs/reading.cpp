// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/reading.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <system_error>
#include <utility>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/words.h"
#include "core/numerics/moments.h"
#include "core/results/run_output.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/studies/runs/measured_run.h"
#include "core/studies/runs/sampled_values.h"

namespace touchdown {

namespace {

constexpr std::size_t mostModes = 3;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct ReadAtRow {
    std::string_view name, meaning;
};
constexpr std::array<ReadAtRow, readAtCount> readAtRows{{{"", "one number"},
                                                         {"end", "the last sample"},
                                                         {"tail", "mean over the last tenth of the run"},
                                                         {"swing", "peak to peak over the last tenth"},
                                                         {"rms", "standard deviation over the last tenth"},
                                                         {"mean", "mean over the whole run"},
                                                         {"least", "the least value in the whole run"},
                                                         {"most", "the largest value in the whole run"}}};

/// A single number or text of a run.
struct RunReading {
    Quantity quantity;
    bool isText = false;
    StudyValue (*value)(const Case& c, const Summary& summary) = nullptr;
};

double figureOf(const Summary& summary, std::string_view name)
{
    const auto found =
        std::ranges::find(summary.figures, name, [](const RunFigure& figure) { return figure.quantity.name; });
    return found == summary.figures.end() ? unknown : found->value;
}

bool endsIn(const Summary& summary, Touch touch)
{
    return summary.verdict.touch == touch && summary.verdict.motion != Motion::Bounces;
}

StudyValue eventTime(const Summary& summary, std::string_view name, bool last)
{
    double time = unknown;
    for (const RunEvent& event : summary.events)
        if (event.name == name && (last || std::isnan(time))) time = event.time;
    return ifFinite(time);
}

const std::vector<RunReading>& runReadings()
{
    static const std::vector<RunReading> rows{
        {{"motion", "", "", "How the motion ends"},
         true,
         [](const Case&, const Summary& s) { return StudyValue(std::string(name(s.verdict.motion))); }},
        {{"contact", "", "", "Contact at the end"},
         true,
         [](const Case&, const Summary& s) { return StudyValue(std::string(name(s.verdict.touch))); }},
        {{"flies", "1", "1", "Flies at the end"},
         false,
         [](const Case&, const Summary& s) { return StudyValue(double(endsIn(s, Touch::Never))); }},
        {{"caught", "1", "1", "In contact at the end, at rest or vibrating"},
         false,
         [](const Case&, const Summary& s) { return StudyValue(double(endsIn(s, Touch::Always))); }},
        {{"bounces", "1", "1", "Bounces to the end"},
         false,
         [](const Case&, const Summary& s) { return StudyValue(double(s.bouncing())); }},
        {{"motion_frequency", "Hz", "kHz", "Frequency of the motion at the end"},
         false,
         [](const Case&, const Summary& s) { return known(s.verdict.frequency > 0.0, s.verdict.frequency); }},
        {{"peak_frequency", "Hz", "kHz", "Frequency of the largest peak in the spectrum of the minimum spacing"},
         false,
         [](const Case&, const Summary& s) { return s.peaks.empty() ? StudyValue() : ifFinite(s.peaks[0].frequency); }},
        {{"peak_amplitude", "m", "nm", "Amplitude of that peak"},
         false,
         [](const Case&, const Summary& s) { return s.peaks.empty() ? StudyValue() : ifFinite(s.peaks[0].amplitude); }},
        {{"first_touch_down", "s", "us", "Time of the first touch-down"},
         false,
         [](const Case&, const Summary& s) { return eventTime(s, "touch-down", false); }},
        {{"last_touch_down", "s", "us", "Time of the last touch-down"},
         false,
         [](const Case&, const Summary& s) { return eventTime(s, "touch-down", true); }},
        {{"last_take_off", "s", "us", "Time of the last take-off"},
         false,
         [](const Case&, const Summary& s) { return eventTime(s, "take-off", true); }},
        {{"end_time", "s", "us", "Time that the run reached"},
         false,
         [](const Case&, const Summary& s) { return ifFinite(s.endTime); }},
        {{"steps", "1", "1", "Accepted steps"},
         false,
         [](const Case&, const Summary& s) { return StudyValue(double(s.steps)); }},
        {{"evaluations", "1", "1", "Evaluations of the right-hand side, or films solved"},
         false,
         [](const Case&, const Summary& s) { return StudyValue(double(s.evaluations)); }},
        {{"law_work", "J", "pJ", "W, which one loop of the contact law takes out of the slider"},
         false,
         [](const Case& c, const Summary&) { return known(cycleWork(c)); }},
    };
    return rows;
}

/// Figures that runs state beside their samples (core/simulation/recording/run_summary.h), where they have them.
const std::vector<Quantity>& figureQuantities()
{
    static const std::vector<Quantity> list{
        {"touch_downs", "1", "1", "Touch-downs"},
        {"flying_height_modulation", "m", "nm", "Flying height modulation over the last tenth, peak to peak"},
        {"flying_height_modulation_rms", "m", "nm", "Flying height modulation over the last tenth, RMS"},
        {"largest_contact_force", "N", "mN", "Largest contact force"},
        {"largest_contact_force_error", "N", "mN", "Error of its grid"},
        {"closest_contact_area", "m^2", "um^2", "Area of contact at the closest approach"},
        {"closest_contact_area_error", "m^2", "um^2", "Error of its grid"},
        {"pull_off_force", "N", "mN", "Pull-off force"},
        {"pull_off_force_error", "N", "mN", "Error of its grid"},
        {"pull_off_separation", "m", "nm", "Separation of the strongest pull on the way out"},
        {"pull_off_separation_error", "m", "nm", "Error of its grid"},
        {"snap_in_separation", "m", "nm", "Separation of the first jump on the way in"},
        {"release_separation", "m", "nm", "Separation of the first jump on the way out"},
    };
    return list;
}

bool hasFigure(const Case& c, const Quantity& figure)
{
    const bool ofPad = c.model == ModelKind::Contact;
    if (figure.name == "touch_downs") return characteristic(c).has_value();
    return figure.name.starts_with("flying_height") ? !ofPad && c.diskSurface.kind != DiskSurfaceKind::Flat : ofPad;
}

std::string modeName(std::size_t mode, const char* what) { return "mode_" + std::to_string(mode + 1) + what; }

/// What can be read off each mode.
struct ModeReading {
    const char *name, *unit, *displayUnit, *longName;
    double AirBearingMode::*value;
};
constexpr std::array<ModeReading, 4> modeReadings{{
    {"_frequency", "Hz", "kHz", "Frequency", &AirBearingMode::frequency},
    {"_frequency_error", "Hz", "kHz", "Estimated error of the grid in the frequency", &AirBearingMode::frequencyError},
    {"_damping_ratio", "1", "1", "Damping ratio", &AirBearingMode::dampingRatio},
    {"_damping_ratio_error", "1", "1", "Estimated error of the grid in the damping ratio",
     &AirBearingMode::dampingError},
}};

bool needsSamples(ReadAt at)
{
    return at == ReadAt::Tail || at == ReadAt::Swing || at == ReadAt::Rms || at == ReadAt::Mean;
}

MeasuredRun recordedRun(const Case& c, const std::vector<std::string>& sampled, ItemCall& call)
{
    std::error_code error; // what cannot be written is told below
    std::filesystem::create_directories(call.file.parent_path(), error);
    CaseDocument document;
    document.value = c;
    document.text = formatCase(c);
    RunOutput output(document, {.results = call.file.string(), .whole = true}, call.goOn);
    MeasuredRun run;
    if (output.problem().empty()) run = recordRun(c, sampled, call.goOn, call.tell, output);
    call.problem = output.problem();
    call.wrote = call.problem.empty() && run.summary.status != RunStatus::Cancelled;
    return run;
}

std::optional<CaseReadings> readRun(const Case& c, const std::vector<Reading>& readings, ItemCall& call)
{
    CaseReadings result;
    result.values.resize(readings.size());
    if (std::string reason = reasonNotToRun(c); !reason.empty()) {
        result.problem = std::move(reason);
        return result;
    }
    std::vector<std::string> sampled;
    for (const Reading& each : readings)
        if (needsSamples(each.at) && std::ranges::find(sampled, each.quantity.name) == sampled.end())
            sampled.push_back(each.quantity.name);
    const MeasuredRun run =
        call.file.empty() ? measureRun(c, sampled, call.goOn, {}, call.tell) : recordedRun(c, sampled, call);
    if (!call.problem.empty()) return {};
    if (run.summary.status == RunStatus::Cancelled) return {};
    if (!run.valid()) {
        result.problem = run.summary.message;
        return result;
    }
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const Reading& reading = readings[i];
        const std::string& quantity = reading.quantity.name;
        if (reading.at != ReadAt::Single) {
            const auto column = std::size_t(std::ranges::find(sampled, quantity) - sampled.begin());
            const std::span<const double> samples =
                column < sampled.size() ? std::span<const double>(run.columns[column]) : std::span<const double>();
            result.values[i] = ifFinite(valueAt(reading.at, c, run, quantity, samples));
            continue;
        }
        const auto row =
            std::ranges::find(runReadings(), quantity, [](const RunReading& each) { return each.quantity.name; });
        result.values[i] =
            row != runReadings().end() ? row->value(c, run.summary) : ifFinite(figureOf(run.summary, quantity));
    }
    return result;
}

StudyValue steadyValue(const SteadyResult& state, const std::string& quantity)
{
    if (quantity == "contact") return state.contact.state.empty() ? StudyValue() : StudyValue(state.contact.state);
    for (const SteadyQuantity& each : steadyQuantities(state))
        if (each.quantity.name == quantity) return ifFinite(each.value);
    return {};
}

std::optional<CaseReadings> readState(const Case& c, Calculation calculation, const std::vector<Reading>& readings,
                                      const GoOn& goOn)
{
    const auto callback = [&](const SteadyProgress&) { return !goOn || goOn(); };
    ModesResult found;
    if (calculation == Calculation::Modes) {
        found = modes(c, callback);
    } else {
        found.steady = steady(c, callback);
        found.status = found.steady.status;
        found.message = found.steady.message;
    }
    if (found.status == SteadyStatus::Cancelled) return {};
    CaseReadings result;
    result.values.resize(readings.size());
    if (found.status != SteadyStatus::Converged) {
        result.problem = found.message.empty() ? std::string(name(found.status)) : found.message;
        return result;
    }
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const std::string& quantity = readings[i].quantity.name;
        result.values[i] = steadyValue(found.steady, quantity);
        for (std::size_t mode = 0; mode < found.modes.size(); ++mode) {
            if (quantity == modeName(mode, "_kind")) result.values[i] = found.modes[mode].kind;
            for (const ModeReading& each : modeReadings)
                if (quantity == modeName(mode, each.name)) result.values[i] = ifFinite(found.modes[mode].*each.value);
        }
    }
    return result;
}

} // namespace

double valueAt(ReadAt at, const Case& c, const MeasuredRun& run, const std::string& quantity,
               std::span<const double> samples)
{
    const Summary& summary = run.summary;
    if (at == ReadAt::End) return valueOr(summary.final, quantity, unknown);
    const Extremes extremes = valueOr(summary.extremes, quantity, {unknown, unknown});
    if (at == ReadAt::Least) return extremes.least;
    if (at == ReadAt::Most) return extremes.most;
    if (samples.empty() || run.time.empty()) return unknown;
    if (at == ReadAt::Swing) return tailSwing(c, run, quantity, samples);
    if (at == ReadAt::Mean) return momentsOf(evenSamples(c, run, samples, 0.0)).mean;
    const Moments tail = momentsOf(tailSamples(c, run, samples));
    return at == ReadAt::Rms ? tail.deviation : tail.mean;
}

std::string_view name(ReadAt taken) { return readAtRows[static_cast<std::size_t>(taken)].name; }
std::string_view meaning(ReadAt taken) { return readAtRows[static_cast<std::size_t>(taken)].meaning; }

std::vector<ReadableQuantity> readableQuantities(Calculation calculation, const Case& c)
{
    std::vector<ReadableQuantity> list;
    if (calculation == Calculation::Run) {
        for (const Quantity& each : recordedQuantities(c)) list.push_back({each, true});
        if (c.model != ModelKind::Contact)
            for (const RunReading& each : runReadings()) list.push_back({each.quantity, false, each.isText});
        for (const Quantity& each : figureQuantities())
            if (hasFigure(c, each)) list.push_back({each});
        return list;
    }
    if (calculation == Calculation::Modes)
        for (std::size_t mode = 0; mode < mostModes; ++mode) {
            list.push_back({{modeName(mode, "_kind"), "", "", "Motion that leads in mode " + std::to_string(mode + 1)},
                            false,
                            true});
            for (const ModeReading& each : modeReadings)
                list.push_back({{modeName(mode, each.name), each.unit, each.displayUnit,
                                 std::string(each.longName) + " of mode " + std::to_string(mode + 1)}});
        }
    SteadyResult state;
    if (c.contact != noContact) state.contact.state = "flying"; // its numbers are quantities, too
    for (SteadyQuantity& each : steadyQuantities(state)) list.push_back({std::move(each.quantity)});
    if (c.contact != noContact) list.push_back({{"contact", "", "", "Contact at rest"}, false, true});
    return list;
}

std::vector<ReadingRow> allReadings()
{
    std::vector<ReadingRow> rows;
    const auto add = [&](Calculation calculation, Case c, const char* where) {
        if (c.model != ModelKind::Contact) c.diskSurface.kind = DiskSurfaceKind::Waves;
        for (ReadableQuantity& each : readableQuantities(calculation, c)) {
            auto row = std::ranges::find(rows, each.quantity.name,
                                         [](const ReadingRow& other) { return other.what.quantity.name; });
            // A name that is a value over time here may be a single number there.
            while (row != rows.end() && row->what.overTime != each.overTime)
                row = std::find_if(row + 1, rows.end(), [&](const ReadingRow& other) {
                    return other.what.quantity.name == each.quantity.name;
                });
            if (row == rows.end()) row = rows.insert(rows.end(), {std::move(each)});
            if (std::ranges::find(row->where, where) == row->where.end()) row->where.emplace_back(where);
        }
    };
    constexpr std::array<std::pair<ModelKind, const char*>, 3> models{{{ModelKind::Springs, "run of springs"},
                                                                       {ModelKind::Film, "run of a film"},
                                                                       {ModelKind::Contact, "run of a pad"}}};
    for (const auto& [model, where] : models)
        for (std::size_t law = 0; law < contactLaws().size(); ++law) {
            Case c = defaultsOf(model);
            c.contact = static_cast<ContactKind>(law);
            if (contactActs(c)) add(Calculation::Run, c, where);
        }
    Case film = defaultsOf(ModelKind::Film);
    film.contact = usualContact;
    add(Calculation::Steady, film, "steady");
    add(Calculation::Modes, film, "modes");
    return rows;
}

StudyColumn Reading::column() const
{
    const auto unitOf = [](const std::string& unit) { return unit == "1" ? std::string() : unit; };
    StudyColumn column{quantity.name, unitOf(quantity.unit), unitOf(quantity.displayUnit), quantity.longName, isError};
    if (at == ReadAt::Single) return column;
    column.name += "_" + std::string(name(at));
    column.longName += ": " + std::string(meaning(at));
    return column;
}

std::variant<Reading, std::string> findReading(Calculation calculation, const Case& c, const std::string& quantity,
                                               const std::string& at)
{
    const std::vector<ReadableQuantity> all = readableQuantities(calculation, c);
    const auto row = std::ranges::find(all, quantity, [](const ReadableQuantity& each) { return each.quantity.name; });
    if (row == all.end()) {
        std::vector<std::string> names;
        for (const ReadableQuantity& each : all) names.push_back(each.quantity.name);
        return inQuotes(quantity) + " is nothing that calculate = " + inQuotes(std::string(name(calculation))) +
               " gives for this case" + didYouMean(nearestName(quantity, names)) +
               "; `touchdown describe study.sweep.readings` lists all";
    }
    if (!row->overTime) {
        if (!at.empty()) return inQuotes(quantity) + " is one number, so that `at` has no meaning";
        return Reading{row->quantity, ReadAt::Single, row->isText};
    }
    std::vector<std::string> names;
    for (std::size_t i = 1; i < readAtCount; ++i) {
        names.emplace_back(readAtRows[i].name);
        if (at == names.back() || (at.empty() && i == 1)) return Reading{row->quantity, static_cast<ReadAt>(i)};
    }
    return "at = " + inQuotes(at) + " is none of " + joined(names);
}

std::vector<Reading> withErrors(Calculation calculation, const Case& c, const std::vector<Reading>& readings)
{
    std::vector<Reading> all;
    for (const Reading& each : readings) {
        all.push_back(each);
        const std::string error = each.quantity.name + "_error";
        const auto isIt = [&](const Reading& other) { return other.quantity.name == error; };
        if (each.at != ReadAt::Single || std::ranges::any_of(readings, isIt)) continue;
        auto found = findReading(calculation, c, error, "");
        if (auto* reading = std::get_if<Reading>(&found)) {
            reading->isError = true;
            all.push_back(std::move(*reading));
        }
    }
    return all;
}

std::optional<CaseReadings> readCase(const Case& c, Calculation calculation, const std::vector<Reading>& readings,
                                     ItemCall& call)
{
    for (const CaseProblem& wrong : checkCombinations(c)) {
        CaseReadings refused;
        refused.values.resize(readings.size());
        refused.problem = wrong.key + ": " + wrong.message;
        return refused;
    }
    auto found =
        calculation == Calculation::Run ? readRun(c, readings, call) : readState(c, calculation, readings, call.goOn);
    if (!found || !found->problem.empty()) return found;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        if (!std::holds_alternative<std::monostate>(found->values[i])) continue;
        const std::string& quantity = readings[i].quantity.name;
        const std::vector<ReadableQuantity> all = readableQuantities(calculation, c);
        if (std::ranges::find(all, quantity, [](const auto& each) { return each.quantity.name; }) == all.end())
            found->problem = "this case has no " + inQuotes(quantity);
    }
    return found;
}

} // namespace touchdown
