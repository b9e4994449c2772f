// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/motion_verdict.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/formats/units.h"

namespace touchdown {

namespace {

/// Changes of the signal from below `low` to above `high` and back.
int changes(std::span<const double> signal, double low, double high)
{
    int side = 0, count = 0;
    for (const double value : signal) {
        const int now = value < low ? -1 : value > high ? 1 : side;
        if (side != 0 && now != side) ++count;
        side = now;
    }
    return count;
}

} // namespace

double periodsOf(std::span<const double> signal)
{
    if (signal.empty()) return 0.0;
    const auto [least, most] = std::ranges::minmax(signal);
    if (!(most > least)) return 0.0;
    const double quarter = 0.25 * (most - least);
    return 0.5 * changes(signal, least + quarter, most - quarter);
}

bool movesOn(std::span<const double> lastHalf)
{
    if (lastHalf.empty()) return false;
    const auto [least, most] = std::ranges::minmax(lastHalf);
    if (most - least < 3.0 * smallestSwing) return false;
    const std::span<const double> window = lastHalf.last(std::max<std::size_t>(1, lastHalf.size() / 5));
    const double mean = std::accumulate(window.begin(), window.end(), 0.0) / static_cast<double>(window.size());
    return changes(lastHalf, mean - 0.5 * smallestSwing, mean + 0.5 * smallestSwing) < 2;
}

Motion motionOf(const MotionEvidence& evidence)
{
    if (evidence.samples < fewestSamples) return Motion::TooShort;
    if (evidence.swing <= smallestSwing) return evidence.movesOn ? Motion::TooShort : Motion::AtRest;
    if (evidence.periods < fewestPeriods) return Motion::TooShort;
    if (evidence.swing < smallestDecay * evidence.swingBefore) return Motion::Settles;
    return evidence.touches ? Motion::Bounces : Motion::Swings;
}

std::string motionRule(const MotionEvidence& evidence)
{
    const auto nm = [](double x) { return formatNumber(std::round(x * 1e13) / 1e13, "nm") + " nm"; };
    const bool small = evidence.swing <= smallestSwing;
    const std::string window = evidence.third ? "third" : "tenth";
    std::string figures = "over the last " + window + " of the run the minimum spacing swings by " + nm(evidence.swing);
    if (!small) figures += " in " + formatNumber(evidence.periods) + " periods";
    figures += ", after " + nm(evidence.swingBefore) + " over the " + window + " before";
    if (!small) figures += evidence.touches ? ", and the slider touches the disk" : ", without contact";
    switch (motionOf(evidence)) {
    case Motion::NotJudged: break;
    case Motion::AtRest: return figures + "; up to " + nm(smallestSwing) + " counts as rest";
    case Motion::TooShort:
        if (evidence.samples < fewestSamples)
            return figures + "; it holds " + std::to_string(evidence.samples) + " samples, and " +
                   std::to_string(fewestSamples) + " are needed to tell";
        if (small) return figures + ", but it was still moving on: a longer run can tell";
        return figures + "; " + formatNumber(fewestPeriods) + " periods are needed to tell";
    case Motion::Settles: return figures + "; less than 90 % of the swing before counts as decay";
    case Motion::Swings:
    case Motion::Bounces: return figures + "; at least 90 % of the swing before counts as sustained";
    }
    return figures;
}

} // namespace touchdown
