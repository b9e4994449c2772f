// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history of one quantity, held so that any part of it can be drawn at any zoom in time proportional to the pixels.
//
// The samples stand in one row; above them stand levels whose entries hold the index of the smallest and the largest
// of 16 entries below. A query over an interval touches at most 2 * 16 entries of each level.
//
// Memory is bounded: when more than `capacity` samples are held, each four neighbours become their smallest and
// largest, in the order of time. So no minimum and no maximum is ever lost, and the times of those that stay are
// true.
//
// One thread only (the GUI's). Queries return values, so that appending never invalidates what they gave.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <QPointF>

namespace touchdown {

struct PlotRange {
    double low = 0.0;
    double high = 1.0;

    double width() const { return high - low; }
    bool contains(double value) const { return value >= low && value <= high; }
    bool operator==(const PlotRange&) const = default;
};

enum class AxisScale : std::uint8_t { Linear, Logarithmic };

class MinMaxPyramid {
public:
    static constexpr std::size_t defaultCapacity = std::size_t(1) << 22; // 16.5 bytes each: at most 70 MB

    /// `expected` samples find room without moving those before them.
    explicit MinMaxPyramid(std::size_t capacity = defaultCapacity, std::size_t expected = 0);

    /// Takes samples in the order of time, evenly spaced or not. A sample that is not finite or lies before the last
    /// one taken is refused: it leaves a gap that the line bridges. Returns how many were taken.
    std::size_t append(std::span<const double> times, std::span<const double> values);

    std::size_t size() const { return times_.size(); } // samples held, <= capacity
    bool empty() const { return times_.empty(); }
    double time(std::size_t index) const { return times_[index]; }
    double value(std::size_t index) const { return values_[index]; }
    double firstTime() const { return times_.front(); } // not when empty
    double lastTime() const { return times_.back(); }   // not when empty

    /// The indices [first, second) of the samples with from <= time <= to.
    std::pair<std::size_t, std::size_t> samplesWithin(double from, double to) const;

    /// The smallest and largest value of the samples with from <= time <= to; nothing when there is none.
    std::optional<PlotRange> extremes(double from, double to) const;

    /// By a straight line between neighbours; nothing before the first and after the last sample.
    std::optional<double> valueAt(double time) const;
    /// The index of the sample nearest to `time`, the earlier of two at equal distance; not when empty.
    std::size_t nearest(double time) const;

    /// Points for a line that shows from <= time <= to on `pixels` columns: at most 4 points a column, plus 4, with the
    /// smallest and the largest sample of each bin, in the order of time, and the neighbours just outside so that the
    /// line reaches the edges. A bin is half a column to one column wide and lies on an absolute grid (multiples of a
    /// power of two; of the logarithm on a logarithmic axis), so that the picture does not shimmer when the window
    /// moves.
    std::vector<QPointF> thinned(double from, double to, int pixels, AxisScale timeScale = AxisScale::Linear) const;

private:
    struct Extremes {
        std::uint32_t smallest; // indices of samples
        std::uint32_t largest;
    };

    void extendLevels();
    void fold();
    Extremes merge(Extremes a, Extremes b) const;
    Extremes extremesOf(std::size_t begin, std::size_t end) const;

    std::size_t capacity_;
    std::vector<double> times_;
    std::vector<double> values_;
    std::vector<std::vector<Extremes>> levels_; // levels_[k][i] covers 16^(k+1) samples; complete ones only
};

} // namespace touchdown
