// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history of one quantity, held so that any part of it can be drawn at any zoom in time proportional to the pixels.
//
// The samples stand in one row; above them stand levels whose entries are the smallest and the largest of 64 entries
// below, with their times. A query over an interval touches at most 2 * 64 entries of each level.
//
// A sample takes 8 bytes, and 0.5 bytes of the levels; its time takes 8 bytes more, which quantities of a run share.
// The samples may be on the disk (SampleColumn). A view of many samples a pixel is drawn from the levels alone.
//
// One thread only (the GUI's); another one reads a twin. Queries return values, so that appending never invalidates
// what they gave.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <QPointF>

#include "ui/plot/sample_times.h"

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
    /// `times`: of the samples of other quantities, to be shared as long as they are the same.
    explicit MinMaxPyramid(std::shared_ptr<SampleTimes> times = std::make_shared<SampleTimes>());

    /// Takes samples in the order of time, evenly spaced or not. A sample that is not finite or lies before the last
    /// one taken is refused: it leaves a gap that the line bridges. Returns how many were taken.
    std::size_t append(std::span<const double> times, std::span<const double> values);

    std::size_t size() const { return values_.size(); }
    bool empty() const { return values_.empty(); }
    double time(std::size_t index) const { return (*times_)[index]; }
    double value(std::size_t index) const { return values_[index]; }
    double firstTime() const { return time(0); }  // not when empty
    double lastTime() const { return lastTime_; } // not when empty
    double lastValue() const { return lastValue_; }

    /// The indices [first, second) of the samples with from <= time <= to.
    std::pair<std::size_t, std::size_t> samplesWithin(double from, double to) const;

    /// The smallest and largest value of the samples with from <= time <= to; nothing when there is none.
    std::optional<PlotRange> extremes(double from, double to) const;

    /// Blocks of samples that are complete, and the smallest and largest value of one: read without the disk.
    std::size_t blocks() const { return levels_.empty() ? 0 : levels_.front().size(); }
    PlotRange extremesOfBlock(std::size_t block) const
    {
        return {levels_.front()[block].smallest().value, levels_.front()[block].largest().value};
    }

    /// By a straight line between neighbours; nothing before the first and after the last sample.
    std::optional<double> valueAt(double time) const;
    /// The index of the sample nearest to `time`, the earlier of two at equal distance; not when empty.
    std::size_t nearest(double time) const;

    /// Points for a line that shows from <= time <= to on `pixels` columns: at most 4 points a column, plus 4, with the
    /// smallest and the largest sample of each bin, in the order of time, and the neighbours just outside so that the
    /// line reaches the edges. A bin is half a column to one column wide and lies on an absolute grid (multiples of a
    /// power of two; of the logarithm on a logarithmic axis), so that the picture does not shimmer when the window
    /// moves. A bin of four blocks of samples or more begins and ends with a block, which adds up to a quarter to it.
    /// `waits`, if not nullptr: where samples would have to be read from the disk first, the bins are of whole blocks,
    /// the reading begins, and `waits` becomes true. Else the call waits for the disk.
    std::vector<QPointF> thinned(double from, double to, int pixels, AxisScale timeScale = AxisScale::Linear,
                                 bool* waits = nullptr) const;

    /// The same samples for another thread: they stay as they are whatever happens here. `times`: a twin of times().
    /// Without the levels: extremes() and thinned() look at every sample.
    std::shared_ptr<const MinMaxPyramid> twin(std::shared_ptr<SampleTimes> times) const;
    std::shared_ptr<const MinMaxPyramid> twin() const { return twin(times_->twin()); }

    const std::shared_ptr<SampleTimes>& times() const { return times_; }
    /// These begin with the same times, which are held only once then.
    void shareTimes(std::shared_ptr<SampleTimes> same);
    SampleColumn& values() { return values_; }
    const SampleColumn& values() const { return values_; }
    /// Nothing more arrives.
    void shrink();
    /// Without the times.
    std::size_t bytesInMemory() const;

private:
    struct Point {
        double time;
        double value;
    };
    /// In the order of time: the smallest and the largest or the largest and the smallest.
    struct Extremes {
        Point first;
        Point second;

        const Point& smallest() const { return second.value < first.value ? second : first; }
        const Point& largest() const { return second.value > first.value ? second : first; }
    };

    void extendLevels();
    static Extremes merge(const Extremes& a, const Extremes& b);
    Extremes extremesOfSamples(std::size_t begin, std::size_t end) const;
    Extremes extremesOf(std::size_t begin, std::size_t end) const;

    std::shared_ptr<SampleTimes> times_; // may have more than there are values
    SampleColumn values_;
    double lastTime_ = 0.0;
    double lastValue_ = 0.0;
    std::vector<std::vector<Extremes>> levels_; // levels_[k][i] covers 64^(k+1) samples; complete ones only
};

} // namespace touchdown
