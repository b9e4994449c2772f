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

/// Curves that come are often followed at once by their data, and a short run by its end: one refresh shows it all.
constexpr int laterRefresh = 50; // [ms]

} // namespace

PlotWidget::PlotWidget(QWidget* parent)
    : QWidget(parent),
      theme_(plotTheme(palette())),
      phasePicture_(*this, [this] { canvas_->repaintAll(); }),
      canvas_(new PlotCanvas(this))
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
    updateGeometry();
    moveArea();
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
    stillPicture_.forget();
    phasePicture_.forget();
    dataChanged();
}

void PlotWidget::setCurves(std::vector<PlotCurve> curves)
{
    curves_ = std::move(curves);
    refreshWithin(laterRefresh);
}

void PlotWidget::updateCurves(const std::function<void(PlotCurve&)>& change)
{
    std::ranges::for_each(curves_, change);
    refreshWithin(laterRefresh);
}

bool PlotWidget::hasPaleCurves() const
{
    return std::ranges::any_of(curves_, [](const PlotCurve& curve) { return curve.visible && curve.pale; });
}

void PlotWidget::setCurveVisible(const QString& id, bool visible)
{
    for (PlotCurve& curve : curves_)
        if (curve.id == id) curve.visible = visible;
    dataChanged();
}

void PlotWidget::setReferenceLines(std::vector<ReferenceLine> lines)
{
    if (lines == referenceLines_) return;
    referenceLines_ = std::move(lines);
    moveArea();
    emit labelsChanged();
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

void PlotWidget::setBackdrop(std::optional<PlotBackdrop> backdrop)
{
    backdrop_ = std::move(backdrop);
    moveArea();
}

void PlotWidget::dataChanged()
{
    refreshWithin(16); // 60 Hz at most
}

void PlotWidget::refreshWithin(int milliseconds)
{
    stale_ = true;
    if (!isVisible() || refreshTimer_.isActive()) return;
    // Not more than half of the time of this thread.
    refreshTimer_.start(std::max(milliseconds, static_cast<int>(2000.0 * refreshSeconds_)));
}

void PlotWidget::refreshNow()
{
    QElapsedTimer clock;
    clock.start();
    refreshTimer_.stop();
    stale_ = false;
    waits_ = false;
    refreshRanges();
    if (PhasePicture::isFor(*this)) {
        stillPicture_.forget();
        phasePaths_.clear();
        canvas_->setLines({});
        phasePicture_.update();
    } else {
        phasePicture_.forget();
        refreshLines();
    }
    canvas_->repaintAll();
    ++refreshes_;
    refreshSeconds_ = 1e-9 * static_cast<double>(clock.nsecsElapsed());
    if (!waits_) return;
    stillPicture_.expire();
    refreshWithin(laterRefresh);
}

void PlotWidget::refreshLines()
{
    stillPicture_.update(*this);
    phasePaths_.clear();
    if (isPhasePortrait()) phasePaths_.resize(curves_.size());
    // On the screen the curves to look at are above the pale ones.
    std::vector<PlotCanvas::Line> lines;
    for (const bool pale : {true, false})
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            const PlotCurve& curve = curves_[i];
            if (!curve.visible || curve.pale != pale || (pale && CurvePicture::holds(curve))) continue;
            lines.push_back({&curve, drawnPath(curve)});
            if (curve.xData != nullptr) phasePaths_[i] = lines.back().path;
        }
    canvas_->setLines(lines);
}

bool PlotWidget::isPhasePortrait() const
{
    return phase_ || std::ranges::any_of(curves_, [](const PlotCurve& curve) { return curve.xData != nullptr; });
}

void PlotWidget::setPhasePortrait(bool phase)
{
    phase_ = phase;
    timeWindow_.reset();
    setView({});
}

std::vector<std::vector<QPointF>> PlotWidget::curvePaths() const
{
    std::vector<std::vector<QPointF>> paths;
    for (const PlotCurve& curve : curves_) paths.push_back(curvePath(curve));
    return paths;
}

std::vector<QPointF> PlotWidget::curvePath(const PlotCurve& curve, bool* waits) const
{
    return curvePath(curve, plotArea().size(), waits);
}

std::vector<QPointF> PlotWidget::curvePath(const PlotCurve& curve, const QSizeF& size, bool* waits) const
{
    if (!curve.visible || curve.data == nullptr) return {};
    if (curve.xData == nullptr) return timePath(*curve.data, x_, y_, static_cast<int>(size.width()), waits);
    return phasePath(*curve.xData, *curve.data, timeWindow_.value_or(PlotRange{-HUGE_VAL, HUGE_VAL}), x_, y_, size,
                     waits);
}

std::vector<QPointF> PlotWidget::drawnPath(const PlotCurve& curve) const
{
    return curve.xData == nullptr ? withoutStraightPoints(curvePath(curve, &waits_), plotArea().size())
                                  : curvePath(curve, &waits_);
}

void PlotWidget::hoverLegend(const QPointF& pixel)
{
    QString now;
    const PlotPainter painter(*this, theme_);
    for (const LegendEntry& entry : painter.legend().entries)
        if (entry.box.contains(pixel)) now = entry.curve->id;
    if (now == hovered_) return;
    hovered_ = now;
    emit legendHovered(now);
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

std::function<void(QIODevice&)> PlotWidget::dataWriter() const
{
    return [this](QIODevice& device) { backdrop() ? backdrop()->writeData(device) : writeCsv(*this, device); };
}

double PlotWidget::heightOnPaper(double width, const QFont& font) const
{
    constexpr double shape = 0.55; // of the area of the curves
    const PlotPainter painter(*this, theme_, {{width, 1e3}, font});
    return 1e3 - painter.area().height() + std::max(shape * painter.area().width(), painter.heightOfTitle());
}

void PlotWidget::paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours)
{
    paintOnSheet(painter, {size, font, colours});
}

void PlotWidget::paintOnSheet(QPainter& painter, const PaperSheet& sheet)
{
    if (stale_) refreshNow();
    const PlotTheme theme = paperTheme(sheet.colours);
    painter.fillRect(QRectF(QPointF(), sheet.size), theme.background);
    const PlotPainter plot(*this, theme, sheet);
    plot.paintBehind(painter);
    plot.paintCurves(painter);
    plot.paintAbove(painter);
}

bool PlotWidget::event(QEvent* event)
{
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) emit labelsChanged();
    return QWidget::event(event);
}

void PlotWidget::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        theme_ = plotTheme(palette());
        moveArea();
        emit labelsChanged();
    }
}

void PlotWidget::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    canvas_->setGeometry(rect());
    moveArea();
}

void PlotWidget::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (stale_) refreshNow();
}

} // namespace touchdown
