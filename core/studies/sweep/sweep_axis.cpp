// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/studies/sweep/sample_points.h"

namespace touchdown {

namespace {

double normalShare(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

} // namespace

SweepValue SweepAxis::at(double share) const
{
    if (!values.empty()) return values[std::min(std::size_t(share * double(values.size())), values.size() - 1)];
    double value = logarithmic ? from * std::pow(to / from, share) : std::lerp(from, to, share);
    if (deviation > 0.0) {
        const double low = normalShare((from - mean) / deviation), high = normalShare((to - mean) / deviation);
        constexpr double least = 1e-300;
        value = std::clamp(mean + deviation * normalQuantile(std::max(std::lerp(low, high, share), least)), from, to);
    }
    return {key.kind == ParameterKind::Integer ? std::round(value) : value};
}

std::string SweepAxis::nameOf(const SweepValue& value) const { return isNumber ? text.of(value.number) : value.text; }

std::string SweepAxis::columnName() const
{
    std::string name;
    for (const char c : key.key) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (letter || (!name.empty() && name.back() != '_')) name += letter ? c : '_';
    }
    return name.ends_with('_') ? name.substr(0, name.size() - 1) : name;
}

} // namespace touchdown
