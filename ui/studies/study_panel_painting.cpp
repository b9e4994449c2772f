// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a panel is painted, from the back to the front.
#include "ui/studies/study_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QFontMetricsF>
#include <QPainterPath>

#include "core/studies/study/study.h"
#include "ui/studies/study_labels.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr double halo = 3.0;            // of paper about a label [px]
constexpr std::size_t mostLabels = 250; // more are not readable

QPen gridPen(const AxisTick& tick, const PlotTheme& theme)
{
    QColor minor = theme.grid;
    minor.setAlphaF(0.45F);
    return {tick.major ? theme.grid : minor, 1.0};
}

/// Text on a rim of paper, so that it can be read on any line.
void paintHaloed(QPainter& painter, const QRectF& box, const QString& text, const QColor& ink, const QColor& paper)
{
    QPainterPath path;
    const QFontMetricsF metrics(painter.font());
    path.addText(box.left(), box.top() + metrics.ascent(), painter.font(), text);
    QColor rim = paper;
    rim.setAlphaF(0.85F);
    QPen pen(rim, halo);
    pen.setJoinStyle(Qt::RoundJoin);
    painter.strokePath(path, pen);
    painter.setPen(ink);
    painter.drawText(box.adjusted(0.0, 0.0, 2.0, 0.0), Qt::AlignLeft | Qt::AlignTop, text);
}

} // namespace

void StudyPanel::paint(QPainter& painter) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    painter.fillRect(area_, theme_.plotArea);
    const PlotFrame frame = this->frame();
    paintGrid(painter, frame);
    painter.save();
    painter.setClipRect(area_, Qt::IntersectClip);
    if (panel_.map) paintMap(painter);
    paintBands(painter);
    paintLines(painter);
    paintErrors(painter);
    painter.restore();
    paintMarkers(painter);
    paintLabels(painter);
    paintAxes(painter, frame);
    painter.restore();
}

void StudyPanel::paintGrid(QPainter& painter, const PlotFrame& frame) const
{
    for (const AxisTick& tick : frame.xTicks) {
        const double x = alignedPixel(across(tick.value));
        painter.setPen(gridPen(tick, theme_));
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
    }
    for (const AxisTick& tick : frame.yTicks) {
        const double y = alignedPixel(up(tick.value));
        painter.setPen(gridPen(tick, theme_));
        painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
}

void StudyPanel::paintMap(QPainter& painter) const
{
    const std::vector<ClassStyle> styles = classStyles(panel_.map->classes, theme_);
    painter.setFont(numberFont_);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t c = 0; c < panel_.map->cells.size(); ++c) {
        const int which = panel_.map->cells[c];
        // Whole pixels, so that neighbours meet, and a line of paper between cells that are large enough for it.
        const QRectF exact = cellBox(static_cast<int>(c));
        QRectF box(QPointF(std::round(exact.left()), std::round(exact.top())),
                   QPointF(std::round(exact.right()), std::round(exact.bottom())));
        if (std::min(box.width(), box.height()) >= 7.0) box.adjust(1.0, 1.0, 0.0, 0.0);
        if (which < 0)
            paintUnknownCell(painter, box, theme_);
        else
            paintCell(painter, box, styles[static_cast<std::size_t>(which)], true);
    }
    painter.restore();
}

void StudyPanel::paintBands(QPainter& painter) const
{
    for (const ChartBand& band : panel_.bands) {
        const QRectF box = bandBox(band);
        QColor edge = panel_.map ? theme_.text : theme_.referenceLine, fill = edge;
        fill.setAlphaF(0.16F);
        if (box.width() > 1.0 && box.height() > 1.0) painter.fillRect(box, fill);
        QPen pen(edge, 1.0);
        pen.setDashPattern({4.0, 3.0});
        painter.setPen(pen);
        for (const double end : {band.lower, band.upper}) {
            if (!std::isfinite(end)) continue;
            const double at = alignedPixel(band.alongX ? across(end) : up(end));
            if (band.alongX && at > area_.left() && at < area_.right())
                painter.drawLine(QPointF(at, area_.top()), QPointF(at, area_.bottom()));
            if (!band.alongX && at > area_.top() && at < area_.bottom())
                painter.drawLine(QPointF(area_.left(), at), QPointF(area_.right(), at));
        }
    }
}

QString StudyPanel::withArrow(const ChartBand& band) const
{
    const QString text = readable(band.label);
    const PlotRange& range = band.alongX ? axes_.x.range() : axes_.y.range();
    if (band.upper < range.low) return (band.alongX ? QStringLiteral("← ") : QStringLiteral("↓ ")) + text;
    if (band.lower > range.high) return band.alongX ? text + QStringLiteral(" →") : QStringLiteral("↑ ") + text;
    return text;
}

void StudyPanel::paintBandLabels(QPainter& painter, std::vector<QRectF>& taken) const
{
    painter.setFont(numberFont_);
    const QFontMetricsF metrics(numberFont_);
    for (const ChartBand& band : panel_.bands) {
        const QRectF box = bandBox(band);
        const QString text = withArrow(band);
        const QSizeF size(metrics.horizontalAdvance(text), metrics.height());
        // Inside first, then beside it; at the right of a horizontal band, at the top of a vertical one.
        std::vector<QPointF> corners;
        if (band.alongX) {
            for (double y = area_.top() + 3.0; y < area_.bottom() - size.height(); y += 1.2 * size.height())
                for (const double x : {box.left() + 4.0, box.right() + 4.0, box.left() - size.width() - 4.0})
                    corners.emplace_back(x, y);
        } else {
            for (const double x :
                 {area_.right() - size.width() - 5.0, area_.left() + 5.0, area_.center().x() - 0.5 * size.width()})
                for (const double y : {box.top() + 2.0, box.top() - size.height() - 1.0, box.bottom() + 1.0})
                    if (y != box.top() + 2.0 || box.height() >= size.height() + 3.0) corners.emplace_back(x, y);
        }
        for (const QPointF& corner : corners) {
            const QRectF place(corner, size);
            if (!area_.contains(place) ||
                std::ranges::any_of(taken, [&place](const QRectF& other) { return other.intersects(place); }))
                continue;
            taken.push_back(place);
            paintHaloed(painter, place, text, panel_.map ? theme_.text : theme_.mutedText, theme_.plotArea);
            break;
        }
    }
}

void StudyPanel::paintLines(QPainter& painter) const
{
    painter.setBrush(Qt::NoBrush);
    // Quiet series are drawn behind the others.
    for (const bool quiet : {true, false})
        for (const ChartSeries& series : panel_.series) {
            if (series.line == ChartLine::None || series.quiet != quiet) continue;
            painter.setPen(seriesPen(styles_.of(series.name), series, theme_));
            for (const QPolygonF& line : polylines(series)) painter.drawPolyline(line);
        }
}

void StudyPanel::paintErrors(QPainter& painter) const
{
    const double cap = 0.7 * radius_;
    for (const ChartSeries& series : panel_.series) {
        painter.setPen(QPen(seriesColour(styles_.of(series.name), theme_), 1.2));
        for (const ChartPoint& point : series.points) {
            const QPointF at = toPixel(point.x, point.y);
            if (!inside(at)) continue;
            if (point.yError > 0.0)
                for (const double end : {up(point.y - point.yError), up(point.y + point.yError)}) {
                    painter.drawLine(at, QPointF(at.x(), end));
                    painter.drawLine(QPointF(at.x() - cap, end), QPointF(at.x() + cap, end));
                }
            if (point.xError > 0.0)
                for (const double end : {across(point.x - point.xError), across(point.x + point.xError)}) {
                    painter.drawLine(at, QPointF(end, at.y()));
                    painter.drawLine(QPointF(end, at.y() - cap), QPointF(end, at.y() + cap));
                }
        }
    }
}

void StudyPanel::paintMarkers(QPainter& painter) const
{
    for (const bool quiet : {true, false})
        for (const ChartSeries& series : panel_.series) {
            if (series.quiet != quiet) continue;
            const SeriesStyle& style = styles_.of(series.name);
            for (const ChartPoint& point : series.points) {
                const QPointF at = toPixel(point.x, point.y);
                if (!inside(at)) continue;
                if (point.chosen) paintRing(painter, at, radius_, theme_);
                if (series.markers || point.chosen || point.kind != PointKind::Good)
                    paintMarker(painter, at, quiet ? 0.7 * radius_ : radius_, style, point.kind, theme_);
            }
        }
}

void StudyPanel::paintLabels(QPainter& painter) const
{
    painter.setFont(numberFont_);
    const QFontMetricsF metrics(numberFont_);
    std::vector<LabelRequest> labels;
    std::vector<QString> texts;
    std::vector<QColor> inks;
    std::vector<QRectF> taken;
    std::vector<QLineF> lines;
    for (const ChartSeries& series : panel_.series) {
        for (const ChartPoint& point : series.points) {
            const QPointF at = toPixel(point.x, point.y);
            if (!inside(at)) continue;
            const double radius = point.chosen ? 2.2 * radius_ : radius_;
            if (series.markers || point.chosen)
                taken.emplace_back(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius);
            if (point.label.empty() || labels.size() >= mostLabels) continue;
            texts.push_back(readable(point.label));
            inks.push_back(series.quiet ? theme_.mutedText : theme_.text);
            labels.push_back(
                {at, radius, {metrics.horizontalAdvance(texts.back()), 0.95 * metrics.height()}, point.chosen});
        }
        if (series.line == ChartLine::None) continue;
        for (const QPolygonF& line : polylines(series))
            for (qsizetype i = 1; i < line.size(); ++i) lines.emplace_back(line[i - 1], line[i]);
    }
    paintBandLabels(painter, taken);
    const auto places = placeLabels(labels, area_.adjusted(0.0, -2.0, 2.0, 0.0), taken, lines);
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (places[i]) paintHaloed(painter, *places[i], texts[i], inks[i], theme_.plotArea);
}

void StudyPanel::paintAxes(QPainter& painter, PlotFrame frame) const
{
    painter.setPen(QPen(theme_.axis, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(QPointF(alignedPixel(area_.left()), alignedPixel(area_.top())),
                            QPointF(alignedPixel(area_.right()), alignedPixel(area_.bottom()))));
    // A frame begins at the left border of its picture.
    const double left = box_.left() - PlotFrame::gap;
    painter.translate(left, 0.0);
    frame.area.translate(-left, 0.0);
    frame.paintNumbers(painter, theme_, box_.right() + 2.0 - left);
    frame.paintAxisTitles(painter, theme_);
    painter.translate(-left, 0.0);
}

void StudyPanel::paintPointed(QPainter& painter, const PanelHit& hit) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme_.cursor, 1.5));
    if (hit.point >= 0) {
        const ChartPoint& point =
            panel_.series[static_cast<std::size_t>(hit.series)].points[static_cast<std::size_t>(hit.point)];
        painter.drawEllipse(toPixel(point.x, point.y), 2.6 * radius_, 2.6 * radius_);
    } else if (hit.cell >= 0) {
        painter.drawRect(cellBox(hit.cell).intersected(area_));
    }
    painter.restore();
}

} // namespace touchdown
