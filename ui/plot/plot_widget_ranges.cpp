// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ranges of a plot's axes: the view of the user, or automatic ones; and the area in which they are shown.
#include "ui/plot/plot_widget.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "ui/plot/plot_canvas.h"
#include "ui/plot/plot_painter.h"

namespace touchdown {

namespace {

std::optional<PlotRange> united(const std::optional<PlotRange>& a, const std::optional<PlotRange>& b)
{
    if (!a || !b) return a ? a : b;
    return PlotRange{std::min(a->low, b->low), std::max(a->high, b->high)};
}

/// Where the range of x ends for a curve: while it grows, at a half, a quarter, ... of its way to the end.
double endOf(const PlotCurve& curve, double first)
{
    const double last = curve.data->lastTime();
    if (!curve.end || !(*curve.end > last)) return last;
    double width = *curve.end - first;
    const double least = 1e-3 * width;
    while (first + 0.5 * width >= last && 0.5 * width > least) width *= 0.5;
    return first + width;
}

} // namespace

void PlotWidget::setView(const PlotView& view)
{
    if (view_.y && !view.y) tightY_ = true;
    view_ = view;
    refreshRanges(); // the next gesture begins from here; the curves follow
    dataChanged();
}

void PlotWidget::setMostX(std::optional<double> most)
{
    mostX_ = most;
    dataChanged();
}

void PlotWidget::setTimeWindow(std::optional<PlotRange> window)
{
    if (timeWindow_ == window) return;
    timeWindow_ = window;
    dataChanged();
}

void PlotWidget::refreshRanges()
{
    if (view_.x) {
        x_.setRange(*view_.x);
        view_.x = x_.range();
    } else if (const auto whole = dataRangeX()) {
        if (isPhasePortrait()) {
            const bool cut = mostX_ && whole->low < *mostX_ && whole->high > *mostX_;
            x_.setRange(
                autoscaled(cut ? PlotRange{whole->low, *mostX_} : *whole, x_.range(), x_.label.scale, x_.label.factor));
        } else
            x_.setRange(whole->width() > 0.0 ? *whole : PlotRange{whole->low, whole->low + x_.label.factor});
    } else if (!hasData()) { // else the curve that leads has no sample yet: the range of the one before it stays
        x_.setRange({x_.logarithmic() ? x_.label.factor : 0.0, 10.0 * x_.label.factor});
    }
    if (view_.y) {
        y_.setRange(*view_.y);
        view_.y = y_.range();
    } else if (const auto seen = dataRangeY()) {
        y_.setRange(autoscaled(*seen, tightY_ ? PlotRange{0.0, 0.0} : y_.range(), y_.label.scale, y_.label.factor));
        tightY_ = false;
    } else if (!hasData()) {
        y_.setRange({y_.logarithmic() ? y_.label.factor : 0.0, 10.0 * y_.label.factor});
        tightY_ = true;
    }
}

bool PlotWidget::anyLeads() const
{
    return std::ranges::any_of(curves_, [](const PlotCurve& curve) { return curve.visible && curve.leads; });
}

/// Whether the automatic ranges follow this curve.
bool PlotWidget::decides(const PlotCurve& curve, bool anyLeads) const
{
    return curve.visible && curve.data != nullptr && (everything_ || allDecide_ || curve.leads || !anyLeads);
}

bool PlotWidget::hasData() const
{
    return backdrop_ || std::ranges::any_of(curves_, [](const PlotCurve& curve) {
               return curve.visible && curve.data != nullptr && !curve.data->empty();
           });
}

void PlotWidget::setEverything(bool everything)
{
    if (everything_ == everything) return;
    everything_ = everything;
    tightY_ = true;
    dataChanged();
}

void PlotWidget::setAllDecide(bool all)
{
    if (allDecide_ == all) return;
    allDecide_ = all;
    tightY_ = true;
    dataChanged();
}

std::optional<PlotRange> PlotWidget::dataRangeX() const
{
    const bool led = anyLeads();
    std::optional<PlotRange> range = backdrop_ ? std::optional(backdrop_->x) : std::nullopt;
    const PlotRange window = timeWindow_.value_or(PlotRange{-HUGE_VAL, HUGE_VAL});
    for (const PlotCurve& curve : curves_) {
        if (!decides(curve, led) || curve.data->empty()) continue;
        if (curve.xData != nullptr) {
            range = united(range, curve.xData->extremes(window.low, window.high));
            continue;
        }
        double first = curve.data->firstTime();
        if (x_.logarithmic()) { // zero has no place there: from the first sample after it
            const std::size_t after = curve.data->samplesWithin(-HUGE_VAL, 0.0).second;
            if (after == curve.data->size()) continue;
            first = curve.data->time(after);
        }
        range = united(range, PlotRange{first, endOf(curve, first)});
    }
    return range;
}

std::optional<PlotRange> PlotWidget::dataRangeY() const
{
    const bool led = anyLeads();
    std::optional<PlotRange> range = backdrop_ ? std::optional(backdrop_->y) : std::nullopt;
    for (const PlotCurve& curve : curves_) {
        if (!decides(curve, led)) continue;
        const PlotRange within =
            curve.xData == nullptr ? x_.range() : timeWindow_.value_or(PlotRange{-HUGE_VAL, HUGE_VAL});
        auto seen = curve.data->extremes(within.low, within.high);
        if (curve.xData == nullptr) // where the line enters and leaves, and what shows between two samples
            for (const double edge : {within.low, within.high})
                if (const auto value = curve.data->valueAt(edge)) seen = united(seen, PlotRange{*value, *value});
        range = united(range, seen);
    }
    return range;
}

LabelRoom PlotWidget::labelRoom(const QFont& font) const
{
    LabelRoom room{0.0, backdrop_.has_value()};
    if (referenceLines_.empty()) return room;
    const QFontMetricsF metrics(plotNumberFont(font));
    for (const ReferenceLine& line : referenceLines_) {
        if (line.label.isEmpty()) continue;
        if (line.upright)
            room.above = true;
        else
            room.width =
                std::max(room.width, std::ceil(metrics.horizontalAdvance(line.label)) + PlotPainter::aroundLabel);
    }
    return room;
}

void PlotWidget::setLeastLabelWidth(double width)
{
    if (width == leastLabelWidth_) return;
    leastLabelWidth_ = width;
    moveArea();
}

void PlotWidget::moveArea()
{
    canvas_->setPlotArea(plotArea());
    dataChanged();
}

QRectF PlotWidget::plotArea() const
{
    LabelRoom labels = labelRoom(font());
    labels.width = std::max(labels.width, leastLabelWidth_);
    return PlotFrame::curveArea(size(), font(), xNumbersVisible_, labels);
}

QSize PlotWidget::minimumSizeHint() const { return {240, PlotFrame::leastHeight(font(), xNumbersVisible_)}; }

QPointF PlotWidget::toPixel(double x, double y) const
{
    const QRectF area = plotArea();
    return {area.left() + x_.position(x) * area.width(), area.bottom() - y_.position(y) * area.height()};
}

} // namespace touchdown
