// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/value_ranges.h"

#include <algorithm>
#include <numeric>

namespace touchdown {

namespace {

constexpr std::size_t mostTold = 3; // ranges in a sentence
constexpr double meeting = 1e-6;    // of all that there is: ranges no farther apart meet [-]

} // namespace

std::vector<ValueRange> merged(std::vector<ValueRange> ranges)
{
    std::ranges::sort(ranges, {}, &ValueRange::lower);
    double upper = ranges.empty() ? 0.0 : ranges.front().upper;
    for (const ValueRange& each : ranges) upper = std::max(upper, each.upper);
    const double near = ranges.empty() ? 0.0 : meeting * (upper - ranges.front().lower);
    std::vector<ValueRange> result;
    for (const ValueRange& each : ranges) {
        if (!result.empty() && each.lower <= result.back().upper + near)
            result.back().upper = std::max(result.back().upper, each.upper);
        else
            result.push_back(each);
    }
    return result;
}

std::vector<ValueRange> rangesAmong(std::vector<double> all, std::vector<double> chosen)
{
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<ValueRange> result;
    bool before = false;
    for (const double value : all) {
        const bool is = std::ranges::find(chosen, value) != chosen.end();
        if (is && before)
            result.back().upper = value;
        else if (is)
            result.push_back({value, value});
        before = is;
    }
    return result;
}

std::vector<ValueRange> rangesAlong(const std::vector<EquilibriumLine>& lines,
                                    const std::function<bool(const StudiedEquilibrium&)>& isSo)
{
    const auto is = [&](const StudiedEquilibrium& at) { return !at.edge && isSo(at); };
    std::vector<ValueRange> ranges;
    for (const EquilibriumLine& line : lines) {
        if (line.outside) continue;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (!is(line.points[i])) continue;
            const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, line.points.size() - 1);
            ValueRange range{line.points[i].value, line.points[i].value};
            for (const std::size_t k : {before, after}) {
                const StudiedEquilibrium& next = line.points[k];
                if (!is(next) && !next.edge) continue;
                range = {std::min(range.lower, next.value), std::max(range.upper, next.value)};
            }
            ranges.push_back(range);
        }
    }
    return merged(std::move(ranges));
}

std::vector<ValueRange> coexistence(const std::vector<EquilibriumLine>& lines)
{
    std::vector<double> ends;
    for (const EquilibriumLine& line : lines)
        for (const StudiedEquilibrium& at : line.points) ends.push_back(at.value);
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto rests = [](const EquilibriumAt& at) {
        return !at.outside && !at.incomplete &&
               (at.stability == Stability::Stable || at.stability == Stability::Neutral);
    };
    std::vector<ValueRange> ranges;
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (std::ranges::count_if(equilibriaAt(lines, std::midpoint(ends[i - 1], ends[i])), rests) > 1)
            ranges.push_back({ends[i - 1], ends[i]});
    ranges = merged(std::move(ranges));
    // Where one line ends and the next begins they may overlap by rounding.
    std::erase_if(ranges, [&](const ValueRange& range) {
        return range.upper - range.lower <= meeting * (ends.back() - ends.front());
    });
    return ranges;
}

std::string text(const std::vector<ValueRange>& ranges, const ParameterText& parameter)
{
    const auto one = [&](const ValueRange& range) {
        const std::string lower = parameter.of(range.lower), upper = parameter.of(range.upper);
        return lower == upper ? "at " + lower : "from " + lower + " to " + upper;
    };
    if (ranges.empty()) return {};
    if (ranges.size() > mostTold)
        return "in " + std::to_string(ranges.size()) + " places from " + parameter.of(ranges.front().lower) + " to " +
               parameter.of(ranges.back().upper);
    std::string sentence = one(ranges.front());
    for (std::size_t i = 1; i < ranges.size(); ++i)
        sentence += (i + 1 < ranges.size() ? ", " : " and ") + one(ranges[i]);
    return sentence;
}

} // namespace touchdown
