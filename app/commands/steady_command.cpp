// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/steady_command.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "app/commands/case_commands.h"
#include "app/terminal/console.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/refusal.h"
#include "app/terminal/report_text.h"
#include "app/terminal/stop_signals.h"
#include "app/terminal/text_table.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/formats/units.h"
#include "core/results/steady_writer.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/work/large_pages.h"

namespace touchdown {

namespace {

/// A state of a series with its result; the fields may have been dropped.
struct SteadyState {
    SteadySeriesPoint point;
    SteadyResult result;
};

bool isKnown(const SteadyResult& r) { return r.grid.x.size() > 1; }

Json place(const SurfacePoint& point, bool known)
{
    return known ? Json{jsonNumber(point.x), jsonNumber(point.y)} : Json(nullptr);
}

Json attitudeJson(const Attitude& a)
{
    return {{"nominal_trailing_edge_height", jsonNumber(a.height)},
            {"pitch", jsonNumber(a.pitch)},
            {"roll", jsonNumber(a.roll)}};
}

Json otherStateJson(const RestingState& other)
{
    Json json = attitudeJson(other.attitude);
    json["contact_state"] = other.contact.state;
    json["unstable"] = other.contact.diverges;
    json["minimum_spacing"] = jsonNumber(other.minimumSpacing);
    json["contact_force"] = jsonNumber(other.contact.contact);
    json["intermolecular_force"] = jsonNumber(other.contact.adhesion);
    json["friction_force"] = jsonNumber(other.contact.friction);
    return json;
}

Json sensitivitiesJson(const std::vector<Sensitivity>& sensitivities)
{
    Json result = Json::array();
    for (const Sensitivity& each : sensitivities)
        result.push_back({{"parameter", each.parameter},
                          {"unit", each.unit.empty() ? "1" : each.unit},
                          {"nominal_trailing_edge_height", jsonNumber(each.height)},
                          {"pitch", jsonNumber(each.pitch)},
                          {"roll", jsonNumber(each.roll)},
                          {"minimum_spacing", jsonNumber(each.minimumSpacing)}});
    return result;
}

Json interestJson(const Case& c, const SteadyResult& r)
{
    Json result = Json::array();
    const auto& points = c.surface.pointsOfInterest;
    for (std::size_t i = 0; i < points.size(); ++i)
        result.push_back(
            {{"x", points[i].x},
             {"y", points[i].y},
             {"spacing", i < r.interestSpacing.size() ? jsonNumber(r.interestSpacing[i]) : Json(nullptr)}});
    return result;
}

/// The message gives the reason of every null.
std::string jsonMessage(const Case& c, const SteadyResult& r)
{
    std::string message = r.message;
    const auto add = [&](const std::string& reason) { message += (message.empty() ? "" : "; ") + reason; };
    if (const std::string reason = leftOut(c, r); !reason.empty()) add(reason);
    if (!isKnown(r))
        add("null because there is no solution");
    else if (r.contact.state.empty())
        add("null because no law of contact has a part in it: contact_force, intermolecular_force");
    if (isKnown(r) && std::isnan(r.discretisationError.minimumSpacing))
        add("null because no coarser grid has a solution to compare with: discretisation_error");
    return message;
}

std::string matrixText(const std::string& title, const Matrix3& matrix)
{
    std::string text = reportRow(title, "        height         pitch          roll   (SI)");
    const std::array<const char*, 3> rows{"  force", "  pitch torque", "  roll torque"};
    for (std::size_t i = 0; i < rows.size(); ++i)
        text += reportRow(rows[i], numberColumn(matrix(i, 0), 5) + numberColumn(matrix(i, 1), 5) +
                                       numberColumn(matrix(i, 2), 5));
    return text;
}

std::string placeText(const SurfacePoint& point)
{
    return "x = " + displayed(point.x, "mm", 5) + ", y = " + displayed(point.y, "mm", 5);
}

std::string withError(double value, double error, const std::string& unit)
{
    if (std::isnan(error)) return displayedInFull(value, unit) + " (grid error not known)";
    return displayedInFull(value, unit) + (error > 0.0 ? " (grid error about " + displayed(error, unit, 2) + ")" : "");
}

/// A value within the round-off of the other one is written as zero.
std::string pairText(const std::string& first, double a, const std::string& second, double b, const std::string& unit)
{
    const double noise = 1e-9 * std::max(std::abs(a), std::abs(b));
    const auto clean = [&](double value) { return std::abs(value) < noise ? 0.0 : value; };
    return first + ' ' + displayedInFull(clean(a), unit) + ", " + second + ' ' + displayedInFull(clean(b), unit);
}

/// "2107.3 kPa above ambient", as the maps of the window show it.
std::string pressureText(double absolute, double ambient)
{
    const double above = absolute - ambient;
    return displayedInFull(std::abs(above), "kPa") + (above < 0.0 ? " below ambient" : " above ambient");
}

std::string forcesText(const Case& c, const SteadyResult& r)
{
    const FilmForces& f = r.forces;
    const double ambient = airOf(c.air).pressure;
    std::string text = reportRow("net force", withError(f.net, r.discretisationError.load, "gf"));
    text += reportRow("  above ambient", displayedInFull(f.positive, "gf") + " at " + placeText(f.centreOfPositive));
    if (f.negative < 0.0)
        text +=
            reportRow("  below ambient", displayedInFull(f.negative, "gf") + " at " + placeText(f.centreOfNegative));
    text += reportRow("pressure torques", pairText("pitch", f.pitchTorque, "roll", f.rollTorque, "uN m"));
    text += reportRow("shear force", pairText("x", f.shearX, "y", f.shearY, "mN"));
    text += reportRow("shear torques", pairText("pitch", r.shearPitchTorque, "roll", r.shearRollTorque, "uN m"));
    text += reportRow("highest pressure", pressureText(f.maximumPressure, ambient) + " at " + placeText(f.maximumAt));
    text += reportRow("lowest pressure", pressureText(f.minimumPressure, ambient) + " at " + placeText(f.minimumAt));
    return text;
}

/// The state's contact, and the other states.
std::string contactText(const SteadyResult& r)
{
    if (r.contact.state.empty()) return {};
    const auto forces = [](const ContactAtRest& at) {
        if (!at.acts()) return std::string();
        return ": contact " + displayedInFull(at.contact, "mN") + ", adhesion " + displayedInFull(at.adhesion, "mN") +
               ", friction " + displayedInFull(at.friction, "mN");
    };
    std::string text = reportRow("contact", r.contact.state + forces(r.contact));
    if (r.contact.area > 0.0) text += reportRow("  real area", displayedInFull(r.contact.area, "um^2"));
    for (const RestingState& other : r.contactStates)
        text += reportRow("other state", other.contact.state + (other.contact.diverges ? " (unstable)" : "") + " at " +
                                             displayedInFull(other.minimumSpacing, "nm") + forces(other.contact));
    return text;
}

/// Changes per display unit of each parameter.
std::string sensitivitiesText(const std::vector<Sensitivity>& sensitivities)
{
    if (sensitivities.empty()) return {};
    std::string text = reportRow("sensitivity to", "   height [nm]  pitch [urad]   roll [urad]  spacing [nm]   per");
    for (const Sensitivity& s : sensitivities) {
        const Parameter* parameter = findParameter(s.parameter);
        const std::string unit = parameter ? parameter->displayUnit : s.unit == "m" ? "nm" : s.unit;
        const double one = unit.empty() ? 1.0 : unitFactor(unit);
        const double nm = unitFactor("nm"), urad = unitFactor("urad");
        std::string name = "  " + s.parameter;
        if (name.size() > 21) name = "  " + s.parameter.substr(s.parameter.find('.') + 1); // without its group
        text += reportRow(name, numberColumn(s.height * one / nm, 4) + numberColumn(s.pitch * one / urad, 4) +
                                    numberColumn(s.roll * one / urad, 4) +
                                    numberColumn(s.minimumSpacing * one / nm, 4) + "   1 " + unit);
    }
    return text;
}

std::string oneText(const Case& c, const SteadyResult& r)
{
    std::string text = reportRow("status", statusText(name(r.status), r.message));
    if (!isKnown(r)) return text;
    if (const std::string reason = leftOut(c, r); !reason.empty()) text += reportRow("left out", reason);
    text += reportRow("solution", std::to_string(r.iterations) + " iterations on " + std::to_string(r.grid.x.size()) +
                                      " x " + std::to_string(r.grid.y.size()) + " nodes, " +
                                      displayed(r.wallSeconds, "s", 3));
    text += reportRow("trailing edge height", displayedInFull(r.attitude.height, "nm"));
    text += reportRow("pitch", withError(r.attitude.pitch, r.discretisationError.pitch, "urad"));
    text += reportRow("roll", withError(r.attitude.roll, r.discretisationError.roll, "urad"));
    text += reportRow("minimum spacing", withError(r.minimumSpacing, r.discretisationError.minimumSpacing, "nm"));
    text += reportRow("", "at " + placeText(r.minimumAt));
    text += contactText(r);
    text += forcesText(c, r);
    const auto& points = c.surface.pointsOfInterest;
    for (std::size_t i = 0; i < std::min(points.size(), r.interestSpacing.size()); ++i)
        text += reportRow("spacing of point " + std::to_string(i + 1),
                          displayedInFull(r.interestSpacing[i], "nm") + " at " + placeText(points[i]));
    if (r.stiffness) text += matrixText("film's stiffness", *r.stiffness);
    if (r.contactStiffness) text += matrixText("contact's stiffness", *r.contactStiffness);
    for (std::size_t i = 0; i < r.otherEquilibria.size(); ++i) {
        const Attitude& a = r.otherEquilibria[i];
        text += reportRow(i == 0 ? "other equilibria" : "", displayedInFull(a.height, "nm") + ", " +
                                                                displayedInFull(a.pitch, "urad") + ", " +
                                                                displayedInFull(a.roll, "urad"));
    }
    text += sensitivitiesText(r.sensitivities);
    return text;
}

std::string seriesText(const std::vector<SteadyState>& states)
{
    std::vector<std::vector<std::string>> rows;
    for (const SteadyState& state : states) {
        std::vector<std::string> head, row;
        const auto add = [&](const Quantity& quantity, double value, bool known) {
            head.push_back(quantity.name + " [" + quantity.displayUnit + "]");
            row.push_back(known ? displayed(value / unitFactor(quantity.displayUnit), "", 6) : "-");
        };
        for (const auto& [quantity, value] : seriesQuantities(state.point)) add(quantity, value, true);
        const bool known = isKnown(state.result);
        for (const auto& [quantity, value] : steadyQuantities(state.result))
            for (const char* wanted : {"nominal_trailing_edge_height", "pitch", "roll", "minimum_spacing", "net_force",
                                       "contact_force", "intermolecular_force"})
                if (quantity.name == wanted) add(quantity, value, known && std::isfinite(value));
        head.push_back("status");
        row.emplace_back(name(state.result.status));
        if (rows.empty()) rows.push_back(head);
        rows.push_back(row);
    }
    std::vector<bool> left(rows.front().size());
    left.back() = true;
    return alignedTable(rows, left);
}

/// The keys of a single state; for a series its status, and "series" with the keys of each state.
std::string steadyJson(const Case& c, const std::vector<SteadyState>& states, SteadyStatus status,
                       const std::string& message)
{
    if (seriesOf(c).size() == 1) return jsonText(steadyObject(c, states.front().result));
    Json series = Json::array();
    double seconds = 0.0;
    for (const SteadyState& state : states) {
        Json each = Json::object();
        for (const auto& [quantity, value] : seriesQuantities(state.point)) each[quantity.name] = jsonNumber(value);
        each.update(steadyObject(c, state.result));
        series.push_back(std::move(each));
        seconds += state.result.wallSeconds;
    }
    return jsonText(
        {{"status", name(status)}, {"message", message}, {"wall_seconds", jsonNumber(seconds)}, {"series", series}});
}

std::string steadyText(const Case& c, const std::vector<SteadyState>& states)
{
    const std::string title = c.title + "\n";
    return title + (seriesOf(c).size() == 1 ? oneText(c, states.front().result) : seriesText(states));
}

} // namespace

std::string leftOut(const Case& c, const SteadyResult& state)
{
    const bool touches = c.contact != noContact && c.steady.fixedAttitude;
    const bool flat = c.diskSurface.kind == DiskSurfaceKind::Flat || (state.contact.acts() && seesStillDisk(c));
    if (!touches && flat) return {};
    const std::string what = !touches ? "disk.surface has" : flat ? "contact has" : "contact and disk.surface have";
    return (touches ? "of the film alone, over a flat disk: " : "over a flat disk: ") + what + " no part in it";
}

Json matrixJson(const Matrix3& m)
{
    Json result = Json::array();
    for (int k = 0; k < 3; ++k) result.push_back({jsonNumber(m(k, 0)), jsonNumber(m(k, 1)), jsonNumber(m(k, 2))});
    return result;
}

Json steadyObject(const Case& c, const SteadyResult& r)
{
    const bool known = isKnown(r);
    const FilmForces& f = r.forces;
    Json json{{"status", name(r.status)},
              {"message", jsonMessage(c, r)},
              {"iterations", r.iterations},
              {"solves", r.solves},
              {"wall_seconds", jsonNumber(r.wallSeconds)},
              {"grid", known ? Json{r.grid.x.size(), r.grid.y.size()} : Json(nullptr)}};
    for (const auto& [quantity, value] : steadyQuantities(r))
        if (!quantity.name.ends_with("_error")) json[quantity.name] = known ? jsonNumber(value) : Json(nullptr);
    json["minimum_spacing_at"] = place(r.minimumAt, known);
    const bool touches = known && !r.contact.state.empty();
    json["contact_state"] = touches ? Json(r.contact.state) : Json(nullptr);
    for (const char* name : {"contact_force", "intermolecular_force", "friction_force"})
        if (!touches) json[name] = nullptr;
    json["contact_stiffness"] = r.contactStiffness ? matrixJson(*r.contactStiffness) : Json(nullptr);
    json["other_states"] = Json::array();
    for (const RestingState& other : r.contactStates) json["other_states"].push_back(otherStateJson(other));
    json["centre_of_positive_pressure"] = place(f.centreOfPositive, known && f.positive > 0.0);
    json["centre_of_negative_pressure"] = place(f.centreOfNegative, known && f.negative < 0.0);
    json["maximum_pressure_at"] = place(f.maximumAt, known);
    json["minimum_pressure_at"] = place(f.minimumAt, known);
    json["points_of_interest"] = interestJson(c, r);
    json["stiffness"] = r.stiffness ? matrixJson(*r.stiffness) : Json(nullptr);
    const auto error = [&](double value) { return known ? jsonNumber(value) : Json(nullptr); };
    json["discretisation_error"] = {{"minimum_spacing", error(r.discretisationError.minimumSpacing)},
                                    {"pitch", error(r.discretisationError.pitch)},
                                    {"roll", error(r.discretisationError.roll)},
                                    {"load", error(r.discretisationError.load)}};
    json["sensitivities"] = sensitivitiesJson(r.sensitivities);
    json["other_equilibria"] = Json::array();
    for (const Attitude& attitude : r.otherEquilibria) json["other_equilibria"].push_back(attitudeJson(attitude));
    json["residual"] = known ? jsonNumber(r.residual) : Json(nullptr);
    json["load_error"] = known ? jsonNumber(r.loadError) : Json(nullptr);
    return json;
}

int steadyCommand(CommandArguments arguments)
{
    if (arguments.fixedAttitude) arguments.settings.emplace_back("steady.fixed_attitude=true");
    const CaseDocument document = openFilmCase(arguments);
    std::vector<InputProblem> problems = document.problems;
    std::ranges::move(targetProblems({{"--out", arguments.out}}, document.inputs()), std::back_inserter(problems));
    if (!problems.empty()) return refuse(problems, arguments.json);
    const Case& c = document.value;

    ProgressLine line(arguments.progress);
    std::optional<SteadyWriter> file;
    std::string problem;
    if (!arguments.out.empty()) problem = file.emplace().open(arguments.out, c, updateCaseText(document.text, c));
    if (!problem.empty()) return refuse({{"", 0, "", problem}}, arguments.json);

    const std::vector<SteadySeriesPoint> series = seriesOf(c);
    std::vector<SteadyState> states;
    preferLargePages(filmBytes(c));
    for (const SteadySeriesPoint& point : series) {
        SteadyResult result = steadyWithContact(caseAt(c, point), [&](const SteadyProgress& update) {
            Progress progress = progressOf(update);
            if (series.size() > 1)
                progress.activity = "state " + std::to_string(states.size() + 1) + " of " +
                                    std::to_string(series.size()) + ", " + progress.activity;
            return line.show(std::move(progress));
        });
        if (file) problem = file->add(point, result);
        result.dropFields(); // only the file needs them
        states.push_back({point, std::move(result)});
        if (!problem.empty() || states.back().result.status == SteadyStatus::Cancelled || stopRequested()) break;
    }
    line.end();

    const auto statusOf = [](const SteadyState& state) { return state.result.status; };
    const SteadyResult& worst = std::ranges::max_element(states, {}, statusOf)->result;
    SteadyStatus status = worst.status;
    std::string message = worst.message;
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
    complain(statusText(name(status), message));
    return exitNoAnswer;
}

} // namespace touchdown
