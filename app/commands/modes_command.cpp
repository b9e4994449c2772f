// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/modes_command.h"

#include <cmath>
#include <numbers>

#include "app/commands/case_commands.h"
#include "app/commands/steady_command.h"
#include "app/terminal/console.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/refusal.h"
#include "app/terminal/report_text.h"
#include "core/case_files/case_file.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "core/work/large_pages.h"

namespace touchdown {

namespace {

constexpr std::array<const char*, 3> motions{"height", "pitch", "roll"};

Json modeJson(const AirBearingMode& mode)
{
    Json shape = Json::object();
    for (std::size_t i = 0; i < 3; ++i)
        shape[motions[i]] = {jsonNumber(mode.shape[i][0]), jsonNumber(mode.shape[i][1])};
    return {{"frequency", jsonNumber(mode.frequency)},
            {"frequency_error", jsonNumber(mode.frequencyError)},
            {"damping_ratio", jsonNumber(mode.dampingRatio)},
            {"damping_ratio_error", jsonNumber(mode.dampingError)},
            {"kind", mode.kind},
            {"shape", shape}};
}

/// "200.1 kHz +- 0.9 kHz, damping ratio 1.87 % +- 0.2 %": with the errors that the cells leave.
std::string ratesText(const AirBearingMode& mode)
{
    const bool known = !std::isnan(mode.dampingError);
    return displayed(mode.frequency, "kHz", 5) +
           (known ? " +- " + displayed(mode.frequencyError, "kHz", 2) : std::string()) + ", damping ratio " +
           displayed(100.0 * mode.dampingRatio, "", 4) + " %" +
           (known ? " +- " + displayed(100.0 * mode.dampingError, "", 2) + " %" : std::string());
}

/// The displacement of the slider's edge by each motion, relative to the largest one: "height 1, pitch 0.8 at 175 deg".
std::string shapeText(const Case& c, const AirBearingMode& mode)
{
    const std::array<double, 3> arms{1.0, 0.5 * c.slider.length, 0.5 * c.slider.width};
    std::array<double, 3> reach{};
    std::size_t first = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        reach[i] = arms[i] * std::hypot(mode.shape[i][0], mode.shape[i][1]);
        if (reach[i] > reach[first]) first = i;
    }
    const auto phase = [&](std::size_t i) { return std::atan2(mode.shape[i][1], mode.shape[i][0]); };
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
        if (reach[first] <= 0.0 || reach[i] < 5e-4 * reach[first]) continue;
        text += (text.empty() ? "" : ", ") + std::string(motions[i]) + ' ' + displayed(reach[i] / reach[first], "", 3);
        const double turn = std::remainder(phase(i) - phase(first), 2.0 * std::numbers::pi);
        if (i != first) text += " at " + displayed(turn, "deg", 3);
    }
    return text;
}

std::string withLeftOut(const Case& c, const SteadyResult& state, const std::string& message)
{
    const std::string reason = leftOut(c, state);
    return message + (message.empty() || reason.empty() ? "" : "; ") + reason;
}

std::string modesJson(const Case& c, const ModesResult& result)
{
    Json all = Json::array();
    for (const AirBearingMode& mode : result.modes) all.push_back(modeJson(mode));
    Json stiffness = Json::array();
    for (const DynamicStiffness& at : result.stiffness)
        stiffness.push_back({{"frequency", jsonNumber(at.frequency)},
                             {"stiffness", matrixJson(at.stiffness)},
                             {"damping", matrixJson(at.damping)}});
    return jsonText({{"status", name(result.status)},
                     {"message", withLeftOut(c, result.steady, result.message)},
                     {"modes", all},
                     {"dynamic_stiffness", stiffness},
                     {"steady", steadyObject(c, result.steady)}});
}

std::string modesText(const Case& c, const ModesResult& result)
{
    std::string text = c.title + "\n";
    text += reportRow("status", statusText(name(result.status), result.message));
    if (const std::string reason = leftOut(c, result.steady); !reason.empty()) text += reportRow("left out", reason);
    const Attitude& a = result.steady.attitude;
    if (result.steady.grid.x.size() > 1)
        text += reportRow("static attitude", displayed(a.height, "nm", 5) + ", " + displayed(a.pitch, "urad", 5) +
                                                 ", " + displayed(a.roll, "urad", 5) + ", minimum spacing " +
                                                 displayed(result.steady.minimumSpacing, "nm", 5));
    for (const AirBearingMode& mode : result.modes) {
        text += reportRow(mode.kind, ratesText(mode));
        text += reportRow("", shapeText(c, mode) + " (of the slider's edges)");
    }
    if (!result.modes.empty() && !std::isnan(result.modes[0].dampingError))
        text += reportRow("errors", "of the cells, from the modes on grids of half and of a quarter as many");
    return text;
}

} // namespace

int modesCommand(const CommandArguments& arguments)
{
    const CaseDocument document = openFilmCase(arguments);
    if (!document.valid()) return refuse(document.problems, arguments.json);
    ProgressLine line(arguments.progress);
    preferLargePages(filmBytes(document.value));
    const ModesResult result =
        modes(document.value, [&](const SteadyProgress& update) { return line.show(progressOf(update)); });
    line.end();
    print(arguments.json ? modesJson(document.value, result) : modesText(document.value, result));
    if (result.status == SteadyStatus::Converged) return exitDone;
    complain(statusText(name(result.status), result.message));
    return exitNoAnswer;
}

} // namespace touchdown
