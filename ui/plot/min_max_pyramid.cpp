// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/min_max_pyramid.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

constexpr std::size_t branching = 16;

/// Bins on a grid that does not depend on where the window stands: edges at multiples of `width` in t, or in log2(t).
struct Grid {
    AxisScale scale;
    double width;

    double coordinate(double time) const { return scale == AxisScale::Linear ? time : std::log2(time); }
    double bin(double time) const { return std::floor(coordinate(time) / width); }
    double edge(double bin) const { return scale == AxisScale::Linear ? bin * width : std::exp2(bin * width); }
};

/// The smallest power of two that is not below `value` > 0. Quotients by it are exact, so that an edge never wanders.
double powerOfTwo(double value)
{
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(1.0, mantissa == 0.5 ? exponent - 1 : exponent);
}

} // namespace

MinMaxPyramid::MinMaxPyramid(std::size_t capacity, std::size_t expected)
    : capacity_(std::clamp<std::size_t>(capacity, 64, UINT32_MAX))
{
    times_.reserve(std::min(expected, capacity_));
    values_.reserve(std::min(expected, capacity_));
}

std::size_t MinMaxPyramid::append(std::span<const double> times, std::span<const double> values)
{
    const std::size_t offered = std::min(times.size(), values.size());
    std::size_t taken = 0;
    for (std::size_t i = 0; i < offered; ++i) {
        const bool finite = std::isfinite(times[i]) && std::isfinite(values[i]);
        if (!finite || (!times_.empty() && times[i] < times_.back())) continue;
        if (times_.size() == capacity_) fold();
        times_.push_back(times[i]);
        values_.push_back(values[i]);
        ++taken;
    }
    extendLevels();
    return taken;
}

void MinMaxPyramid::extendLevels()
{
    std::size_t below = times_.size();
    for (std::size_t level = 0; below >= branching; ++level) {
        if (level == levels_.size()) levels_.emplace_back();
        std::vector<Extremes>& entries = levels_[level];
        const std::size_t complete = below / branching;
        for (std::size_t i = entries.size(); i < complete; ++i) {
            const auto first = static_cast<std::uint32_t>(i * branching);
            Extremes best = level == 0 ? Extremes{first, first} : levels_[level - 1][first];
            for (std::uint32_t k = first + 1; k < first + branching; ++k)
                best = merge(best, level == 0 ? Extremes{k, k} : levels_[level - 1][k]);
            entries.push_back(best);
        }
        below = complete;
    }
}

void MinMaxPyramid::fold()
{
    // The first and the last sample stay, so that the history keeps its ends.
    std::size_t to = 1;
    std::size_t from = 1;
    const auto keep = [&](std::size_t index) {
        times_[to] = times_[index];
        values_[to] = values_[index];
        ++to;
    };
    for (; from + 4 < times_.size(); from += 4) {
        const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(from);
        const auto [low, high] = std::minmax_element(begin, begin + 4);
        auto first = static_cast<std::size_t>(std::min(low, high) - begin);
        auto second = static_cast<std::size_t>(std::max(low, high) - begin);
        if (first == second) second = 3; // all equal
        keep(from + first);
        keep(from + second);
    }
    for (; from < times_.size(); ++from) keep(from);
    times_.resize(to);
    values_.resize(to);
    levels_.clear();
    extendLevels();
}

MinMaxPyramid::Extremes MinMaxPyramid::merge(Extremes a, Extremes b) const
{
    return {values_[b.smallest] < values_[a.smallest] ? b.smallest : a.smallest,
            values_[b.largest] > values_[a.largest] ? b.largest : a.largest};
}

MinMaxPyramid::Extremes MinMaxPyramid::extremesOf(std::size_t begin, std::size_t end) const
{
    Extremes best{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin)};
    for (std::size_t level = 0;; ++level) {
        const auto take = [&](std::size_t i) {
            const auto sample = static_cast<std::uint32_t>(i);
            best = merge(best, level == 0 ? Extremes{sample, sample} : levels_[level - 1][i]);
        };
        if (level == levels_.size() || end - begin < 2 * branching) {
            for (std::size_t i = begin; i < end; ++i) take(i);
            return best;
        }
        for (; begin % branching != 0; ++begin) take(begin);
        for (; end % branching != 0;) take(--end);
        begin /= branching;
        end /= branching;
    }
}

std::pair<std::size_t, std::size_t> MinMaxPyramid::samplesWithin(double from, double to) const
{
    const auto first = std::lower_bound(times_.begin(), times_.end(), from);
    const auto last = std::upper_bound(first, times_.end(), to);
    return {static_cast<std::size_t>(first - times_.begin()), static_cast<std::size_t>(last - times_.begin())};
}

std::optional<PlotRange> MinMaxPyramid::extremes(double from, double to) const
{
    const auto [begin, end] = samplesWithin(from, to);
    if (begin == end) return std::nullopt;
    const Extremes found = extremesOf(begin, end);
    return PlotRange{values_[found.smallest], values_[found.largest]};
}

std::size_t MinMaxPyramid::nearest(double time) const
{
    const auto after = static_cast<std::size_t>(std::ranges::lower_bound(times_, time) - times_.begin());
    if (after == 0) return 0;
    if (after == times_.size()) return after - 1;
    return time - times_[after - 1] <= times_[after] - time ? after - 1 : after;
}

std::optional<double> MinMaxPyramid::valueAt(double time) const
{
    if (empty() || !(time >= firstTime() && time <= lastTime())) return std::nullopt;
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    if (after == times_.end()) return values_.back();
    const auto right = static_cast<std::size_t>(after - times_.begin());
    const std::size_t left = right - 1; // times_[left] <= time < times_[right]
    const double part = (time - times_[left]) / (times_[right] - times_[left]);
    return std::lerp(values_[left], values_[right], part);
}

std::vector<QPointF> MinMaxPyramid::thinned(double from, double to, int pixels, AxisScale timeScale) const
{
    std::vector<QPointF> points;
    const bool logarithmic = timeScale == AxisScale::Logarithmic;
    if (empty() || pixels < 1 || !(to > from) || (logarithmic && from <= 0.0)) return points;

    Grid grid{timeScale, 1.0};
    grid.width = powerOfTwo((grid.coordinate(to) - grid.coordinate(from)) / (2.0 * pixels));

    // Whole bins, also at the edges: else the first would change with every move of the window.
    const auto indexOf = [this](double time) {
        return static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), time) - times_.begin());
    };
    const std::size_t begin = indexOf(grid.edge(grid.bin(from)));
    const std::size_t end = std::max(begin, indexOf(grid.edge(grid.bin(to) + 1.0)));

    points.reserve(std::min(end - begin, static_cast<std::size_t>(pixels) * 4) + 4);
    const auto show = [&](std::size_t i) { points.emplace_back(times_[i], values_[i]); };
    if (begin > 0 && (!logarithmic || times_[begin - 1] > 0.0)) show(begin - 1);
    for (std::size_t i = begin; i < end;) {
        const double edge = grid.edge(grid.bin(times_[i]) + 1.0);
        std::size_t reach = 1; // gallop: the next edge is near when samples are few
        while (i + reach < end && times_[i + reach] < edge) reach *= 2;
        const auto last = times_.begin() + static_cast<std::ptrdiff_t>(std::min(i + reach, end));
        const auto next = std::max(
            i + 1, static_cast<std::size_t>(
                       std::lower_bound(times_.begin() + static_cast<std::ptrdiff_t>(i), last, edge) - times_.begin()));
        const Extremes found = extremesOf(i, next);
        show(std::min(found.smallest, found.largest));
        if (found.smallest != found.largest) show(std::max(found.smallest, found.largest));
        i = next;
    }
    if (end < times_.size()) show(end);
    return points;
}

} // namespace touchdown
