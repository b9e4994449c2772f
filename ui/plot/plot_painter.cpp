// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_painter.h"

#include <algorithm>

#include <QFontMetricsF>

#include "ui/plot/plot_path.h"

namespace touchdown {

namespace {

constexpr int mostUp = 9;           // numbers of an upright axis
constexpr double paperPixel = 0.25; // to which lines on paper are thinned [px]

/// On paper a plot that stands alone says at its axis what it shows.
PlotAxis namedAxis(PlotAxis axis, const QString& plotTitle)
{
    if (axis.label.title.isEmpty()) axis.label.title = plotTitle;
    return axis;
}

std::vector<PlotCurve> printedOn(const PaperSheet& sheet, const std::vector<PlotCurve>& curves)
{
    std::vector<PaperStyle> styles = sheet.styles;
    return paperCurves(curves, sheet.colours, styles);
}

/// On the screen beside the title, which is cut to `most`.
Legend legendBeside(const std::vector<PlotCurve>& curves, const QString& title, const PlotFrame& frame, double most)
{
    constexpr double gap = PlotFrame::gap;
    const double used = frame.titleWidth(title, most) + 3.0 * gap;
    const QRectF row(frame.area.left() + used, gap, frame.area.width() - used, frame.lineHeight());
    return legendInRow(curves, title, row, frame.textFont);
}

/// The title may take the whole width, unless the legend could then name no curve.
double roomForTitle(const std::vector<PlotCurve>& curves, const QString& title, const PlotFrame& frame)
{
    const double width = frame.area.width();
    const Legend legend = legendBeside(curves, title, frame, width);
    return legend.entries.empty() && legend.more > 0 ? 0.6 * width : width;
}

} // namespace

PlotPainter::PlotPainter(const PlotWidget& plot, const PlotTheme& theme)
    : plot_(plot),
      theme_(theme),
      paper_(false),
      width_(plot.width()),
      curves_(plot.curves()),
      x_(plot.xAxis()),
      y_(plot.yAxis()),
      title_(plot.title()),
      area_(plot.plotArea()),
      frame_(area_, plot.font(), x_, y_, mostUp)
{}

PlotPainter::PlotPainter(const PlotWidget& plot, const PlotTheme& theme, const PaperSheet& sheet)
    : plot_(plot),
      theme_(theme),
      paper_(true),
      width_(sheet.size.width()),
      printed_(printedOn(sheet, plot.curves())),
      curves_(printed_),
      x_(plot.xAxis()),
      y_(namedAxis(plot.yAxis(), plot.title())),
      title_(plot.yAxis().label.title.isEmpty() || !sheet.title ? QString() : plot.title()),
      area_(PlotFrame::curveArea(sheet.size, sheet.font, true,
                                 {std::max(plot.labelRoom(sheet.font).width, sheet.labelWidth), false, true})),
      frame_(area_, sheet.font, x_, y_, mostUp)
{
    constexpr double gap = PlotFrame::gap;
    const double row = frame_.lineHeight();
    const double top = gap + frame_.titleHeight(title_, area_.width());
    if (curves_.size() > 1) // one alone needs no name
        paperLegend_ = legendInRows(curves_, plot.title(), {area_.left(), top}, area_.width(), frame_.textFont);
    const double above = plot.labelRoom(sheet.font).above ? PlotFrame::leader + frame_.numberHeight() : 0.0;
    area_.setTop(std::min(std::max(top + paperLegend_.height, gap + row) + gap + above, area_.bottom() - 1.0));
    frame_ = PlotFrame(area_, sheet.font, x_, y_, mostUp);
    frame_.least = PlotFrame::leastOnPaper;
}

double PlotPainter::heightOfTitle() const
{
    return QFontMetricsF(frame_.textFont).horizontalAdvance(y_.text()) - frame_.lineHeight() + 1.0;
}

std::vector<QPointF> PlotPainter::pathOf(const PlotCurve& curve) const
{
    if (!paper_) return plot_.curvePath(curve);
    const QSizeF fine = area_.size() / paperPixel;
    const std::vector<QPointF> path = plot_.curvePath(curve, fine);
    return curve.xData == nullptr ? withoutStraightPoints(path, fine) : path;
}

void PlotPainter::paintBehind(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    QColor minor = theme_.grid;
    minor.setAlphaF(0.45F);
    // Filled, as smooth lines cost ten times as much.
    for (const AxisTick& tick : frame_.xTicks) {
        const double x = alignedPixel(frame_.across(x_.position(tick.value))) - 0.5;
        painter.fillRect(QRectF(x, area_.top(), 1.0, area_.height()), tick.major ? theme_.grid : minor);
    }
    for (const AxisTick& tick : frame_.yTicks) {
        const double y = alignedPixel(frame_.up(y_.position(tick.value))) - 0.5;
        painter.fillRect(QRectF(area_.left(), y, area_.width(), 1.0), tick.major ? theme_.grid : minor);
    }
    if (plot_.backdrop()) {
        painter.save();
        painter.setClipRect(area_, Qt::IntersectClip);
        plot_.backdrop()->paint(painter, area_, x_, y_);
        painter.restore();
    }
    paintReferenceLines(painter);
    paintShadedAreas(painter);
    if (!plot_.shadedAreas().empty()) paintLabels(painter, true);
}

void PlotPainter::paintAbove(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.axis, 1.0));
    const double left = alignedPixel(area_.left());
    const double bottom = alignedPixel(area_.bottom());
    painter.drawLine(QPointF(left, area_.top()), QPointF(left, bottom));
    painter.drawLine(QPointF(left, bottom), QPointF(area_.right(), bottom));
    frame_.paintNumbers(painter, theme_, width_, (paper_ || plot_.xNumbersVisible()));
    frame_.paintAxisTitles(painter, theme_, (paper_ || plot_.xNumbersVisible()));
    paintHeader(painter);
    paintEventMarks(painter);
    paintArrows(painter);
    paintDots(painter);
    paintPointers(painter);
    paintLabels(painter, false);
}

Legend PlotPainter::legend() const
{
    if (paper_) return paperLegend_;
    return legendBeside(curves_, title_, frame_, roomForTitle(curves_, title_, frame_));
}

void PlotPainter::paintHeader(QPainter& painter) const
{
    constexpr double gap = PlotFrame::gap;
    if (plot_.backdrop()) {
        const double height = frame_.numberHeight();
        plot_.backdrop()->paintKey(painter, {area_.left(), area_.top() - gap - height, area_.width(), height},
                                   frame_.numberFont, theme_);
        frame_.paintTitle(painter, theme_, title_, width_ - area_.left() - gap, paper_);
        return;
    }
    const Legend legend = this->legend();
    const double room = paper_ ? area_.width() : roomForTitle(curves_, title_, frame_);
    frame_.paintTitle(painter, theme_, title_, room, paper_);
    painter.setFont(frame_.textFont);
    const double line = frame_.lineHeight();
    const bool wide = !paper_ && plot_.hasPaleCurves();
    for (const auto& [curve, text, box] : legend.entries) {
        const double y = alignedPixel(box.top() + 0.5 * line); // a pale line of one pixel keeps its colour
        painter.setPen(pathPen(*curve, {}, area_.size(), theme_, wide));
        painter.drawLine(QPointF(box.left(), y), QPointF(box.left() + Legend::sample, y));
        painter.setPen(curve->pale || !wide ? theme_.mutedText : theme_.text);
        painter.drawText(box.adjusted(Legend::sample + gap, 0.0, 0.0, 0.0),
                         Qt::AlignLeft | Qt::AlignTop | (box.height() > line ? Qt::TextWrapAnywhere : 0), text);
    }
    if (legend.more == 0 || curves_.empty()) return;
    const double left = legend.entries.empty() ? area_.left() : legend.entries.back().box.right();
    painter.setPen(theme_.mutedText);
    painter.drawText(QRectF(left, gap, area_.right() - left, line), Qt::AlignRight | Qt::AlignVCenter,
                     QStringLiteral("+%1").arg(legend.more));
}

void PlotPainter::paintCurves(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const bool wide = !paper_ && plot_.hasPaleCurves();
    const bool arrows = !paper_ && PhasePicture::isFor(plot_); // which are a part of its picture on the screen
    for (const PlotCurve& curve : curves_) {
        const std::vector<QPointF> path = pathOf(curve);
        if (path.empty()) continue;
        painter.setPen(pathPen(curve, path, area_.size(), theme_, wide));
        drawPath(painter, path, area_);
        if (arrows && curve.arrows && !curve.pale) drawArrows(painter, path, area_, theme_.colour(curve.style));
    }
}

void PlotPainter::paintCursors(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(frame_.numberFont);
    for (int which = 0; which < 2; ++which) {
        const auto at = plot_.plotCursor(which);
        if (!at) continue;
        if (!plot_.isPhasePortrait()) {
            if (!x_.range().contains(*at)) continue;
            const double x = alignedPixel(frame_.across(x_.position(*at)));
            QPen pen(theme_.cursor, 1.0);
            if (which == 1) pen.setDashPattern({3.0, 3.0});
            painter.setPen(pen);
            painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
            // 1 left and 2 right of the line, so that close cursors hide neither each other's number nor the title.
            const double side = QFontMetricsF(frame_.numberFont).height();
            paintCursorTag(painter, which, {which == 0 ? x - side - 2.0 : x + 2.0, area_.top() + 8.0 + side});
        }
        for (const PlotCurve& curve : curves_) {
            // Without a line at the cursor, the dot alone shows where a pale curve is.
            if (!curve.visible || (curve.pale && !plot_.isPhasePortrait()) || curve.data == nullptr) continue;
            const auto y = curve.data->valueAt(*at);
            const auto x = curve.xData != nullptr ? curve.xData->valueAt(*at) : at;
            if (!x || !y) continue;
            const QPointF centre(frame_.across(x_.position(*x)), frame_.up(y_.position(*y)));
            if (!area_.contains(centre)) continue;
            painter.setPen(QPen(theme_.background, 1.5));
            painter.setBrush(curve.pale ? theme_.paleColour(curve.style) : theme_.colour(curve.style));
            painter.drawEllipse(centre, 4.0, 4.0);
            if (plot_.isPhasePortrait() && !curve.pale) paintCursorTag(painter, which, centre + QPointF(6.0, -6.0));
        }
        painter.setBrush(Qt::NoBrush);
    }
}

void PlotPainter::paintCursorTag(QPainter& painter, int which, const QPointF& bottomLeft) const
{
    const double side = QFontMetricsF(frame_.numberFont).height();
    const QRectF tag(bottomLeft - QPointF(0.0, side), QSizeF(side, side));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.cursor);
    painter.drawRoundedRect(tag, 3.0, 3.0);
    painter.setPen(theme_.background);
    painter.drawText(tag, Qt::AlignCenter, QString::number(which + 1));
}

void PlotPainter::paintSelection(QPainter& painter, const QRectF& box) const
{
    QColor fill = theme_.selection;
    fill.setAlphaF(0.15F);
    painter.setPen(QPen(theme_.selection, 1.0));
    painter.setBrush(fill);
    painter.drawRect(box.intersected(area_));
    painter.setBrush(Qt::NoBrush);
}

QPolygonF PlotPainter::outlineOf(const ShadedArea& shaded) const
{
    QPolygonF outline;
    for (const auto& [x, y] : shaded.outline)
        outline << QPointF(frame_.across(x_.position(x)), frame_.up(y_.position(y)));
    return outline;
}

void PlotPainter::paintShadedAreas(QPainter& painter) const
{
    painter.save();
    painter.setClipRect(area_);
    painter.setPen(Qt::NoPen);
    for (const ShadedArea& shaded : plot_.shadedAreas()) {
        QColor fill = theme_.colour(shaded.style);
        fill.setAlphaF(0.18F);
        painter.setBrush(fill);
        painter.drawPolygon(outlineOf(shaded));
    }
    painter.restore();
}

void PlotPainter::paintEventMarks(QPainter& painter) const
{
    painter.setPen(QPen(theme_.referenceLine, 1.0));
    double last = -1e9;
    for (const EventMark& mark : plot_.eventMarks()) {
        if (plot_.isPhasePortrait() || !x_.range().contains(mark.time)) continue;
        const double x = alignedPixel(frame_.across(x_.position(mark.time)));
        if (x == last) continue; // thousands of bounces fall onto one column
        last = x;
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.top() + 6.0));
    }
}

void PlotPainter::paintArrows(QPainter& painter) const
{
    const std::vector<std::vector<QPointF>>& drawn = plot_.phasePaths(); // on the screen
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const PlotCurve& curve = curves_[i];
        if (!curve.arrows || curve.pale || curve.xData == nullptr || (!paper_ && i >= drawn.size())) continue;
        drawArrows(painter, paper_ ? pathOf(curve) : drawn[i], area_, theme_.colour(curve.style));
    }
}

void PlotPainter::paintDots(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (const PlotCurve& curve : curves_) {
        if (!curve.dots || !curve.visible || curve.data == nullptr) continue;
        painter.setBrush(theme_.colour(curve.style));
        const PlotRange& seen = x_.range();
        const auto [begin, end] = curve.data->samplesWithin(seen.low, seen.high);
        for (std::size_t i = begin; i < end; ++i) {
            const QPointF at(frame_.across(x_.position(curve.data->time(i))),
                             frame_.up(y_.position(curve.data->value(i))));
            if (at.y() >= area_.top() && at.y() <= area_.bottom()) painter.drawEllipse(at, 3.0, 3.0);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace touchdown
