// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/min_max_pyramid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace touchdown {

namespace {

constexpr std::size_t branching = SampleTimes::blockSize;
constexpr std::size_t manyBlocks = 4; // in a bin: a shift by half a block does not show

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

MinMaxPyramid::MinMaxPyramid(std::shared_ptr<SampleTimes> times) : times_(std::move(times)) {}

std::size_t MinMaxPyramid::append(std::span<const double> times, std::span<const double> values)
{
    const std::size_t offered = std::min(times.size(), values.size());
    const std::size_t before = size();
    for (std::size_t i = 0; i < offered; ++i) {
        const bool finite = std::isfinite(times[i]) && std::isfinite(values[i]);
        if (!finite || (!empty() && times[i] < lastTime_)) continue;
        // Where another quantity took a sample that this one refused, or the other way round, they part.
        if (size() < times_->size() && (*times_)[size()] != times[i])
            times_ = std::make_shared<SampleTimes>(*times_, size());
        if (size() == times_->size()) times_->push_back(times[i]);
        values_.push_back(values[i]);
        lastTime_ = times[i];
        lastValue_ = values[i];
    }
    extendLevels();
    return size() - before;
}

std::shared_ptr<const MinMaxPyramid> MinMaxPyramid::twin(std::shared_ptr<SampleTimes> times) const
{
    auto same = std::make_shared<MinMaxPyramid>(std::move(times));
    same->values_ = values_.twin();
    same->lastTime_ = lastTime_;
    same->lastValue_ = lastValue_;
    return same;
}

void MinMaxPyramid::shareTimes(std::shared_ptr<SampleTimes> same)
{
    assert(same->size() >= size() && (empty() || ((*same)[0] == time(0) && (*same)[size() - 1] == lastTime_)));
    times_ = std::move(same);
}

void MinMaxPyramid::extendLevels()
{
    std::size_t below = size();
    for (std::size_t level = 0; below >= branching; ++level) {
        if (level == levels_.size()) levels_.emplace_back();
        std::vector<Extremes>& entries = levels_[level];
        const std::size_t complete = below / branching;
        for (std::size_t i = entries.size(); i < complete; ++i) {
            const std::size_t first = i * branching;
            if (level == 0) {
                entries.push_back(extremesOfSamples(first, first + branching));
                continue;
            }
            Extremes best = levels_[level - 1][first];
            for (std::size_t k = first + 1; k < first + branching; ++k) best = merge(best, levels_[level - 1][k]);
            entries.push_back(best);
        }
        below = complete;
    }
}

void MinMaxPyramid::shrink()
{
    values_.shrink();
    for (std::vector<Extremes>& level : levels_) level.shrink_to_fit();
}

std::size_t MinMaxPyramid::bytesInMemory() const
{
    std::size_t bytes = sizeof(MinMaxPyramid) + values_.bytesInMemory();
    for (const std::vector<Extremes>& level : levels_) bytes += level.capacity() * sizeof(Extremes);
    return bytes;
}

/// `a` is before `b`.
MinMaxPyramid::Extremes MinMaxPyramid::merge(const Extremes& a, const Extremes& b)
{
    const bool lower = b.smallest().value < a.smallest().value;
    const bool higher = b.largest().value > a.largest().value;
    if (lower == higher) return lower ? b : a;
    return lower ? Extremes{a.largest(), b.smallest()} : Extremes{a.smallest(), b.largest()};
}

MinMaxPyramid::Extremes MinMaxPyramid::extremesOfSamples(std::size_t begin, std::size_t end) const
{
    std::size_t smallest = begin, largest = begin;
    double low = values_[begin], high = low;
    for (std::size_t i = begin + 1; i < end; ++i) {
        const double value = values_[i];
        if (value < low) {
            low = value;
            smallest = i;
        }
        if (value > high) {
            high = value;
            largest = i;
        }
    }
    const Point lowest{time(smallest), low}, highest{time(largest), high};
    return smallest < largest ? Extremes{lowest, highest} : Extremes{highest, lowest};
}

MinMaxPyramid::Extremes MinMaxPyramid::extremesOf(std::size_t begin, std::size_t end) const
{
    // The levels rise from both ends, so that parts come in the order of time on the left and backwards on the right.
    std::optional<Extremes> left, right;
    const auto addLeft = [&](const Extremes& part) { left = left ? merge(*left, part) : part; };
    const auto addRight = [&](const Extremes& part) { right = right ? merge(part, *right) : part; };
    for (std::size_t level = 0; begin < end; ++level) {
        if (level == levels_.size() || end - begin < 2 * branching) {
            if (level == 0)
                addLeft(extremesOfSamples(begin, end));
            else
                for (std::size_t i = begin; i < end; ++i) addLeft(levels_[level - 1][i]);
            break;
        }
        const std::size_t first = (begin + branching - 1) / branching, last = end / branching;
        if (level == 0) {
            if (begin < first * branching) addLeft(extremesOfSamples(begin, first * branching));
            if (last * branching < end) addRight(extremesOfSamples(last * branching, end));
        } else {
            for (std::size_t i = begin; i < first * branching; ++i) addLeft(levels_[level - 1][i]);
            for (std::size_t i = end; i > last * branching; --i) addRight(levels_[level - 1][i - 1]);
        }
        begin = first;
        end = last;
    }
    if (!left) return *right;
    return right ? merge(*left, *right) : *left;
}

std::pair<std::size_t, std::size_t> MinMaxPyramid::samplesWithin(double from, double to) const
{
    const std::size_t first = std::min(times_->lowerBound(from), size());
    return {first, std::max(first, std::min(times_->upperBound(to), size()))};
}

std::optional<PlotRange> MinMaxPyramid::extremes(double from, double to) const
{
    const auto [begin, end] = samplesWithin(from, to);
    if (begin == end) return std::nullopt;
    const Extremes found = extremesOf(begin, end);
    return PlotRange{found.smallest().value, found.largest().value};
}

std::size_t MinMaxPyramid::nearest(double time) const
{
    const std::size_t after = std::min(times_->lowerBound(time), size());
    if (after == 0) return 0;
    if (after == size()) return after - 1;
    return time - this->time(after - 1) <= this->time(after) - time ? after - 1 : after;
}

std::optional<double> MinMaxPyramid::valueAt(double time) const
{
    if (empty() || !(time >= firstTime() && time <= lastTime())) return std::nullopt;
    if (time == lastTime_) return lastValue_;
    const std::size_t right = times_->upperBound(time);
    const std::size_t left = right - 1; // time(left) <= time < time(right)
    const double part = (time - this->time(left)) / (this->time(right) - this->time(left));
    return std::lerp(values_[left], values_[right], part);
}

std::vector<QPointF> MinMaxPyramid::thinned(double from, double to, int pixels, AxisScale timeScale, bool* waits) const
{
    std::vector<QPointF> points;
    const bool logarithmic = timeScale == AxisScale::Logarithmic;
    if (empty() || pixels < 1 || !(to > from) || (logarithmic && from <= 0.0)) return points;

    Grid grid{timeScale, 1.0};
    grid.width = powerOfTwo((grid.coordinate(to) - grid.coordinate(from)) / (2.0 * pixels));

    // Whole bins, also at the edges: else the first would change with every move of the window.
    const double firstBin = grid.bin(from);
    const double firstEdge = grid.edge(firstBin), lastEdge = grid.edge(grid.bin(to) + 1.0);
    const std::size_t firstBlock = times_->blockFrom(firstEdge);
    std::size_t begin = std::min((std::max<std::size_t>(firstBlock, 1) - 1) * branching, size());
    std::size_t end = std::min(times_->blockFrom(lastEdge, firstBlock) * branching, size());
    const std::size_t bins = 2 * static_cast<std::size_t>(pixels);
    bool single = logarithmic || (end - begin) / branching < 2 * manyBlocks * bins; // whether it takes samples
    if (single && waits != nullptr) {
        const std::size_t before = begin - std::min<std::size_t>(begin, 1);
        const bool values = values_.atHand(before, end + 1), times = times_->column().atHand(before, end + 1);
        single = values && times;
        *waits = *waits || !single;
    }
    const bool onlyBlocks = waits != nullptr && *waits && !single;
    points.reserve(std::min(end - begin, static_cast<std::size_t>(pixels) * 4) + 4);
    const auto show = [&](std::size_t i) { points.emplace_back(time(i), values_[i]); };
    if (single) {
        begin = std::min(times_->lowerBound(firstEdge), size());
        end = std::max(begin, std::min(times_->lowerBound(lastEdge), size()));
        if (begin > 0 && (!logarithmic || time(begin - 1) > 0.0)) show(begin - 1);
    }
    for (std::size_t i = begin; i < end;) {
        const double edge = grid.edge(std::max(grid.bin(time(i)), firstBin) + 1.0);
        const std::size_t block = i / branching;
        const std::size_t nextBlock = times_->blockFrom(edge, block + 1);
        std::size_t next = nextBlock * branching;
        if (nextBlock - block < manyBlocks && edge < lastEdge && !onlyBlocks)
            next = times_->lowerBoundBefore(nextBlock, edge);
        next = edge < lastEdge ? std::clamp(next, i + 1, end) : end;
        const Extremes found = extremesOf(i, next);
        points.emplace_back(found.first.time, found.first.value);
        if (found.first.value != found.second.value) points.emplace_back(found.second.time, found.second.value);
        i = next;
    }
    if (single && end < size()) show(end);
    return points;
}

} // namespace touchdown
