// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_widget.h"

#include "ui/plot/plot_canvas.h"
#include "ui/plot/plot_navigation.h"
#include "ui/plot/plot_painter.h"
#include "ui/plot/plot_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QElapsedTimer>
#include <QEvent>
#include <QPainter>

namespace touchdown {

namespace {

std::optional<PlotRange> united(const std::optional<PlotRange>& a, const std::optional<PlotRange>& b)
{
    if (!a || !b) return a ? a : b;
    return PlotRange{std::min(a->low, b->low), std::max(a->high, b->high)};
}

} // namespace

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent), theme_(plotTheme(palette())), canvas_(new PlotCanvas(this))
{
    setXLabel({tr("Time"), QStringLiteral("s"), 1.0, AxisScale::Linear});
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleDescription(tr("Arrow keys move, plus and minus zoom, Home shows everything, Backspace goes back."));
    refreshTimer_.setSingleShot(true);
    refreshTimer_.setTimerType(Qt::PreciseTimer);
    connect(&refreshTimer_, &QTimer::timeout, this, &PlotWidget::refreshNow);
    new PlotNavigation(this);
    canvas_->setPlotArea(plotArea());
}

void PlotWidget::setTitle(const QString& title)
{
    title_ = title;
    setAccessibleName(tr("Plot: %1").arg(title));
    canvas_->repaintAll();
}

void PlotWidget::setXLabel(const AxisLabel& label)
{
    x_.label = label;
    dataChanged();
}

void PlotWidget::setYLabel(const AxisLabel& label)
{
    y_.label = label;
    y_.setRange(y_.range()); // a logarithm needs another one at once: the cursors are drawn before the next refresh
    tightY_ = true;
    dataChanged();
}

void PlotWidget::setYScale(AxisScale scale)
{
    if (y_.label.scale == scale) return;
    y_.label.scale = scale;
    y_.setRange(y_.range());
    tightY_ = true;
    dataChanged();
}

void PlotWidget::setXNumbersVisible(bool visible)
{
    xNumbersVisible_ = visible;
    canvas_->setPlotArea(plotArea());
    dataChanged();
}

void PlotWidget::addCurve(const PlotCurve& curve)
{
    const auto same = std::ranges::find(curves_, curve.id, &PlotCurve::id);
    if (same != curves_.end())
        *same = curve;
    else
        curves_.push_back(curve);
    dataChanged();
}

void PlotWidget::removeCurve(const QString& id)
{
    std::erase_if(curves_, [&](const PlotCurve& curve) { return curve.id == id; });
    dataChanged();
}

void PlotWidget::clearCurves()
{
    curves_.clear();
    dataChanged();
}

void PlotWidget::setCurveVisible(const QString& id, bool visible)
{
    for (PlotCurve& curve : curves_)
        if (curve.id == id) curve.visible = visible;
    dataChanged();
}

void PlotWidget::setReferenceLines(std::vector<ReferenceLine> lines)
{
    referenceLines_ = std::move(lines);
    canvas_->repaintAll();
}

void PlotWidget::setEventMarks(std::vector<EventMark> marks)
{
    eventMarks_ = std::move(marks);
    canvas_->repaintAll();
}

void PlotWidget::setPointMarks(std::vector<PointMark> marks)
{
    pointMarks_ = std::move(marks);
    canvas_->repaintAll();
}

void PlotWidget::setShadedAreas(std::vector<ShadedArea> areas)
{
    shadedAreas_ = std::move(areas);
    canvas_->repaintAll();
}

void PlotWidget::dataChanged()
{
    stale_ = true;
    if (!isVisible() || refreshTimer_.isActive()) return;
    // 60 Hz at most, and not more than half of the time of this thread.
    refreshTimer_.start(static_cast<int>(std::max(16.0, 2000.0 * refreshSeconds_)));
}

void PlotWidget::refreshNow()
{
    QElapsedTimer clock;
    clock.start();
    refreshTimer_.stop();
    stale_ = false;
    refreshRanges();
    std::vector<std::vector<QPointF>> paths = curvePaths();
    canvas_->setPaths(paths);
    phasePaths_.clear();
    if (isPhasePortrait()) phasePaths_ = std::move(paths);
    canvas_->repaintAll();
    ++refreshes_;
    refreshSeconds_ = 1e-9 * static_cast<double>(clock.nsecsElapsed());
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
    } else {
        x_.setRange({x_.logarithmic() ? x_.label.factor : 0.0, 10.0 * x_.label.factor});
    }
    if (view_.y) {
        y_.setRange(*view_.y);
        view_.y = y_.range();
    } else if (const auto seen = dataRangeY()) {
        y_.setRange(autoscaled(*seen, tightY_ ? PlotRange{0.0, 0.0} : y_.range(), y_.label.scale, y_.label.factor));
        tightY_ = false;
    } else {
        y_.setRange({y_.logarithmic() ? y_.label.factor : 0.0, 10.0 * y_.label.factor});
        tightY_ = true;
    }
}

std::optional<PlotRange> PlotWidget::dataRangeX() const
{
    std::optional<PlotRange> range;
    const PlotRange window = timeWindow_.value_or(PlotRange{-HUGE_VAL, HUGE_VAL});
    for (const PlotCurve& curve : curves_) {
        if (!curve.visible || curve.data == nullptr || curve.data->empty()) continue;
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
        range = united(range, PlotRange{first, curve.data->lastTime()});
    }
    return range;
}

std::optional<PlotRange> PlotWidget::dataRangeY() const
{
    std::optional<PlotRange> range;
    for (const PlotCurve& curve : curves_) {
        if (!curve.visible || curve.data == nullptr) continue;
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

bool PlotWidget::isPhasePortrait() const
{
    return std::ranges::any_of(curves_, [](const PlotCurve& curve) { return curve.xData != nullptr; });
}

std::vector<std::vector<QPointF>> PlotWidget::curvePaths() const
{
    std::vector<std::vector<QPointF>> paths;
    const QSizeF size = plotArea().size();
    for (const PlotCurve& curve : curves_) {
        if (!curve.visible || curve.data == nullptr)
            paths.emplace_back();
        else if (curve.xData == nullptr)
            paths.push_back(timePath(*curve.data, x_, y_, static_cast<int>(size.width())));
        else
            paths.push_back(phasePath(*curve.xData, *curve.data, timeWindow_.value_or(PlotRange{-HUGE_VAL, HUGE_VAL}),
                                      x_, y_, size));
    }
    return paths;
}

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

void PlotWidget::userView(const PlotView& view, Gesture gesture)
{
    setView(view);
    emit viewChanged(view_, gesture);
}

void PlotWidget::repaintCursor(int which)
{
    const auto at = plotCursor(which);
    if (isPhasePortrait())
        canvas_->repaintAll();
    else if (at && x_.range().contains(*at))
        canvas_->repaintCursor(toPixel(*at, 0.0).x());
}

void PlotWidget::setPlotCursor(int which, std::optional<double> x)
{
    auto& cursor = cursors_[static_cast<std::size_t>(which)];
    if (cursor == x) return;
    repaintCursor(which);
    cursor = x;
    repaintCursor(which);
}

void PlotWidget::userCursor(int which, std::optional<double> x)
{
    setPlotCursor(which, x);
    emit cursorMoved(which, x.has_value(), x.value_or(0.0));
}

void PlotWidget::userPin(bool pinned)
{
    cursorPinned_ = pinned;
    emit cursorPinnedChanged(pinned);
}

void PlotWidget::showSelection(std::optional<QRectF> box) { canvas_->setSelection(box); }

QRectF PlotWidget::plotArea() const
{
    const double lastNumber = QFontMetricsF(plotNumberFont(font())).horizontalAdvance(QStringLiteral("00.0"));
    return PlotFrame::areaWithin(size(), font(), QStringLiteral("\u2212000.000"), lastNumber / 2.0 + PlotFrame::gap,
                                 xNumbersVisible_);
}

QPointF PlotWidget::toPixel(double x, double y) const
{
    const QRectF area = plotArea();
    return {area.left() + x_.position(x) * area.width(), area.bottom() - y_.position(y) * area.height()};
}

void PlotWidget::paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme)
{
    if (stale_) refreshNow();
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.width() / width());
    painter.fillRect(rect(), theme.background);
    const PlotPainter plot(*this, theme);
    plot.paintBehind(painter);
    plot.paintCurves(painter);
    plot.paintAbove(painter);
    painter.restore();
}

void PlotWidget::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        theme_ = plotTheme(palette());
        canvas_->setPlotArea(plotArea());
        dataChanged();
    }
}

void PlotWidget::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    canvas_->setGeometry(rect());
    canvas_->setPlotArea(plotArea());
    dataChanged();
}

void PlotWidget::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (stale_) refreshNow();
}

} // namespace touchdown
