// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_place.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "core/numerics/spectrum.h"

namespace touchdown {

namespace {

const MinMaxPyramid* leadingData(const PlotWidget& plot)
{
    for (const PlotCurve& curve : plot.curves() | std::views::reverse)
        if (curve.visible && curve.leads && curve.data && !curve.xData && !curve.data->empty()) return curve.data;
    return nullptr;
}

/// Nothing where the sample is no local maximum.
std::optional<double> placeOfPeak(const MinMaxPyramid& data, std::size_t i)
{
    if (i == 0 || i + 1 >= data.size()) return std::nullopt;
    const double left = data.value(i - 1);
    const double middle = data.value(i);
    const double right = data.value(i + 1);
    if (!(left > 0.0) || !(right > 0.0) || !(middle > left) || !(middle >= right)) return std::nullopt;
    const double before = data.time(i) - data.time(i - 1);
    const double after = data.time(i + 1) - data.time(i);
    const bool even = std::abs(after - before) < 1e-3 * after; // else a sample without power was left out
    return data.time(i) + (even ? topBetween(left, middle, right).offset * after : 0.0);
}

/// The point of curves that is nearest to a pixel.
class NearestPoint {
public:
    NearestPoint(const PlotWidget& plot, const QPointF& pixel)
        : x_(plot.xAxis()),
          y_(plot.yAxis()),
          window_(plot.timeWindow().value_or(PlotRange{-HUGE_VAL, HUGE_VAL})),
          size_(plot.plotArea().size()),
          aim_(pixel.x() - plot.plotArea().left(), plot.plotArea().bottom() - pixel.y())
    {}

    void search(const PlotCurve& curve)
    {
        constexpr std::size_t block = SampleTimes::blockSize;
        const MinMaxPyramid &up = *curve.data, &across = *curve.xData;
        const bool together = up.times() == across.times();
        const std::size_t blocks = together ? std::min(up.blocks(), across.blocks()) : 0;
        const auto [begin, end] = up.samplesWithin(window_.low, window_.high);
        for (std::size_t i = begin; i < end && !found();) {
            const std::size_t next = (i / block + 1) * block;
            // The line to the next block lies within the box about both.
            if (i / block + 1 < blocks && distanceTo(boxOf(across, up, i / block)) >= nearest_) {
                last_.reset();
                i = next;
                continue;
            }
            if (!last_ && i > begin) take(across, up, i - 1);
            for (; i < std::min(end, next) && !found(); ++i) take(across, up, i);
        }
        last_.reset();
    }
    bool found() const { return nearest_ <= near; }
    std::optional<double> time() const { return time_; }

private:
    static constexpr double near = 0.5; // [px]
    struct Point {
        double time;
        QPointF at; // [px]
    };

    QPointF toPixel(double x, double y) const
    {
        return {x_.position(x) * size_.width(), y_.position(y) * size_.height()};
    }

    QRectF boxOf(const MinMaxPyramid& across, const MinMaxPyramid& up, std::size_t block) const
    {
        QRectF box;
        for (const std::size_t each : {block, block + 1}) {
            const PlotRange x = across.extremesOfBlock(each), y = up.extremesOfBlock(each);
            const QPointF low = toPixel(x.low, y.low), high = toPixel(x.high, y.high);
            box = each == block ? QRectF(low, high)
                                : QRectF(QPointF(std::min(box.left(), low.x()), std::min(box.top(), low.y())),
                                         QPointF(std::max(box.right(), high.x()), std::max(box.bottom(), high.y())));
        }
        return box;
    }

    double distanceTo(const QRectF& box) const
    {
        const double dx = std::max({box.left() - aim_.x(), 0.0, aim_.x() - box.right()});
        const double dy = std::max({box.top() - aim_.y(), 0.0, aim_.y() - box.bottom()});
        return std::hypot(dx, dy);
    }

    /// A sample, and the line to it from the one before.
    void take(const MinMaxPyramid& across, const MinMaxPyramid& up, std::size_t i)
    {
        const double time = up.time(i);
        const bool together = i < across.size() && across.time(i) == time;
        const std::optional<double> x = together ? across.value(i) : across.valueAt(time);
        if (!x) return last_.reset();
        const Point point{time, toPixel(*x, up.value(i))};
        const Point from = last_.value_or(point);
        const QPointF step = point.at - from.at;
        const double square = QPointF::dotProduct(step, step);
        const double part =
            square > 0.0 ? std::clamp(QPointF::dotProduct(aim_ - from.at, step) / square, 0.0, 1.0) : 1.0;
        const QPointF apart = from.at + part * step - aim_;
        if (const double distance = std::hypot(apart.x(), apart.y()); distance < nearest_) {
            nearest_ = distance;
            time_ = std::lerp(from.time, time, part);
        }
        last_ = point;
    }

    const PlotAxis &x_, &y_;
    PlotRange window_;
    QSizeF size_;
    QPointF aim_; // from the lower left corner of the plot area, upwards
    std::optional<Point> last_;
    double nearest_ = HUGE_VAL; // [px]
    std::optional<double> time_;
};

} // namespace

std::optional<double> phaseTimeNear(const PlotWidget& plot, const QPointF& pixel)
{
    NearestPoint nearest(plot, pixel);
    for (const PlotCurve& curve : plot.curves())
        if (curve.visible && curve.data && curve.xData && !nearest.found()) nearest.search(curve);
    return nearest.time();
}

std::optional<double> peakNear(const PlotWidget& plot, double x, double reach)
{
    const MinMaxPyramid* data = leadingData(plot);
    if (!data) return std::nullopt;
    const PlotAxis& axis = plot.xAxis();
    const double part = reach / plot.plotArea().width();
    const auto around = [&](double at) { return axis.part(axis.position(at) - part, axis.position(at) + part); };
    const PlotRange seen = around(x);
    const auto [within, beyond] = data->samplesWithin(seen.low, seen.high);
    // The top may lie between two samples, of which the higher one is out of reach.
    const std::size_t begin = within > 0 ? within - 1 : 0;
    const std::size_t end = std::min(beyond + 1, data->size());
    std::optional<double> nearest;
    for (std::size_t i = begin; i < end; ++i) {
        const std::optional<double> place = placeOfPeak(*data, i);
        if (!place || !seen.contains(*place)) continue;
        if (nearest &&
            std::abs(axis.position(*place) - axis.position(x)) >= std::abs(axis.position(*nearest) - axis.position(x)))
            continue;
        const PlotRange beside = around(data->time(i));
        const auto extremes = data->extremes(beside.low, beside.high);
        if (extremes && extremes->high <= data->value(i)) nearest = place;
    }
    return nearest;
}

bool isAtPeak(const PlotWidget& plot, double x)
{
    const MinMaxPyramid* data = leadingData(plot);
    return data && placeOfPeak(*data, data->nearest(x)) == x;
}

} // namespace touchdown
