// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/modes_report.h"

#include <cmath>
#include <numbers>

#include "app/commands/steady_report.h"
#include "app/terminal/number_text.h"
#include "app/terminal/report_row.h"

namespace touchdown {
namespace {

constexpr std::array<const char*, 3> motions{"height", "pitch", "roll"};

Json matrix(const Matrix3& m)
{
    Json result = Json::array();
    for (int k = 0; k < 3; ++k) result.push_back({jsonNumber(m(k, 0)), jsonNumber(m(k, 1)), jsonNumber(m(k, 2))});
    return result;
}

Json modeJson(const AirBearingMode& mode)
{
    Json shape = Json::object();
    for (std::size_t i = 0; i < 3; ++i)
        shape[motions[i]] = {jsonNumber(mode.shape[i][0]), jsonNumber(mode.shape[i][1])};
    return {{"frequency", jsonNumber(mode.frequency)},
            {"damping_ratio", jsonNumber(mode.dampingRatio)},
            {"kind", mode.kind},
            {"shape", shape}};
}

// How far each motion takes the slider's edge, against the leading one: "height 1, pitch 0.8 at 175 deg".
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

std::string withLeftOut(const Case& c, const std::string& message)
{
    const std::string reason = leftOut(c);
    return message + (message.empty() || reason.empty() ? "" : "; ") + reason;
}

} // namespace

std::string modesJson(const Case& c, const ModesResult& result)
{
    Json all = Json::array();
    for (const AirBearingMode& mode : result.modes) all.push_back(modeJson(mode));
    Json stiffness = Json::array();
    for (const DynamicStiffness& at : result.stiffness)
        stiffness.push_back({{"frequency", jsonNumber(at.frequency)},
                             {"stiffness", matrix(at.stiffness)},
                             {"damping", matrix(at.damping)}});
    return jsonText({{"status", name(result.status)},
                     {"message", withLeftOut(c, result.message)},
                     {"modes", all},
                     {"dynamic_stiffness", stiffness},
                     {"steady", steadyObject(c, result.steady)}});
}

std::string modesText(const Case& c, const ModesResult& result)
{
    std::string text = c.title + "\n";
    text += reportRow("status", statusText(result.status, result.message));
    if (const std::string reason = leftOut(c); !reason.empty()) text += reportRow("left out", reason);
    const Attitude& a = result.steady.attitude;
    if (result.steady.grid.x.size() > 1)
        text += reportRow("static attitude", displayed(a.height, "nm", 5) + ", " + displayed(a.pitch, "urad", 5) +
                                                 ", " + displayed(a.roll, "urad", 5) + ", minimum spacing " +
                                                 displayed(result.steady.minimumSpacing, "nm", 5));
    for (const AirBearingMode& mode : result.modes) {
        text += reportRow(mode.kind, displayed(mode.frequency, "kHz", 5) + ", damping ratio " +
                                         displayed(100.0 * mode.dampingRatio, "", 4) + " %");
        text += reportRow("", shapeText(c, mode) + " (of the slider's edges)");
    }
    return text;
}

} // namespace touchdown
