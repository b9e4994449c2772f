// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/value_ranges.h"

#include <algorithm>

#include "core/case/case_key.h"
#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::size_t mostNamed = 3; // ranges in a sentence

} // namespace

std::string ParameterText::of(double value) const { return fewDigits(value, displayUnit, 4); }

ParameterText parameterText(const Parameter& key)
{
    ParameterText text{key.key, key.unit, key.displayUnit};
    if (findParameter(key.key) == nullptr) return text;
    text.label = capitalized(key.label);
    if (!key.symbol.empty()) text.label += " " + key.symbol;
    return text;
}

std::vector<ValueRange> merged(std::vector<ValueRange> ranges)
{
    std::ranges::sort(ranges, {}, &ValueRange::lower);
    double upper = ranges.empty() ? 0.0 : ranges.front().upper;
    for (const ValueRange& each : ranges) upper = std::max(upper, each.upper);
    const double near = ranges.empty() ? 0.0 : rangesMeet * (upper - ranges.front().lower);
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

std::string text(const std::vector<ValueRange>& ranges, const ParameterText& parameter)
{
    const auto one = [&](const ValueRange& range) {
        const std::string lower = parameter.of(range.lower), upper = parameter.of(range.upper);
        return lower == upper ? "at " + lower : "from " + lower + " to " + upper;
    };
    if (ranges.empty()) return {};
    if (ranges.size() > mostNamed)
        return "in " + std::to_string(ranges.size()) + " places from " + parameter.of(ranges.front().lower) + " to " +
               parameter.of(ranges.back().upper);
    std::string sentence = one(ranges.front());
    for (std::size_t i = 1; i < ranges.size(); ++i)
        sentence += (i + 1 < ranges.size() ? ", " : " and ") + one(ranges[i]);
    return sentence;
}

} // namespace touchdown
