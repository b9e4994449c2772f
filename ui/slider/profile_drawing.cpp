// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/profile_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/formats/units.h"
#include "ui/plot/plot_axis.h"

namespace touchdown {

namespace {

constexpr double stripeLength = 2e-4; // of the marks that move with the disk [m]

} // namespace

QPointF ProfileDrawing::toPixel(double along, double height) const
{
    return {area.left() + area.width() * along / size,
            area.bottom() - area.height() * (height - heights.low) / heights.width()};
}

double ProfileDrawing::exaggeration() const { return (area.height() / heights.width()) / (area.width() / size); }

QPolygonF ProfileDrawing::line(std::span<const double> at) const
{
    QPolygonF points;
    const double steps = static_cast<double>(at.size()) - 1.0;
    for (std::size_t i = 0; i < at.size(); ++i)
        points << toPixel(size * static_cast<double>(i) / steps, std::min(at[i], ceiling * heights.high));
    return points;
}

void ProfileDrawing::paintDisk(QPainter& painter, const PlotTheme& theme) const
{
    const double surface = toPixel(0.0, 0.0).y();
    painter.fillRect(QRectF(QPointF(area.left(), surface), area.bottomRight()), theme.grid);
    painter.setPen(QPen(theme.axis, 1.5));
    painter.drawLine(QPointF(area.left(), surface), QPointF(area.right(), surface));
}

void ProfileDrawing::paintDisk(QPainter& painter, const PlotTheme& theme, std::span<const double> at) const
{
    const QPolygonF surface = line(at);
    QPolygonF body = surface;
    body << area.bottomRight() << area.bottomLeft();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.grid);
    painter.drawPolygon(body);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.axis, 1.5));
    painter.drawPolyline(surface);
}

void ProfileDrawing::paintMotion(QPainter& painter, const PlotTheme& theme, double distance) const
{
    const double surface = toPixel(0.0, 0.0).y();
    painter.setPen(QPen(theme.mutedText, 1.0));
    for (double x = std::fmod(distance, stripeLength) - stripeLength; x < size; x += stripeLength) {
        const double pixel = toPixel(x, 0.0).x();
        painter.drawLine(QPointF(pixel, surface + 3.0), QPointF(pixel - 6.0, area.bottom()));
    }
}

void ProfileDrawing::paintSlider(QPainter& painter, const QColor& colour, std::span<const double> at) const
{
    QPolygonF outline = line(at);
    outline.prepend(toPixel(0.0, 2.0 * heights.high)); // above the area, which clips
    outline.append(toPixel(size, 2.0 * heights.high));
    QColor body = colour;
    painter.setPen(QPen(body, 1.5));
    body.setAlphaF(0.4F);
    painter.setBrush(body);
    painter.drawPolygon(outline);
    painter.setBrush(Qt::NoBrush);
}

void ProfileDrawing::paintOutline(QPainter& painter, const QPen& pen, double otherSize,
                                  std::span<const double> at) const
{
    ProfileDrawing other = *this;
    other.size = otherSize;
    other.area.setWidth(area.width() * otherSize / size); // the same scale
    painter.setPen(pen);
    painter.drawPolyline(other.line(at));
}

void ProfileDrawing::paintFrame(QPainter& painter, const PlotTheme& theme, const QString& title,
                                const QString& remark) const
{
    const double lineHeight = painter.fontMetrics().height();
    painter.setPen(theme.axis);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    painter.setPen(theme.text);
    PlotAxis along;
    along.label = {title, QStringLiteral("mm"), unitFactor("mm"), AxisScale::Linear};
    along.setRange({0.0, size});
    const int most = std::clamp(static_cast<int>(area.width() / 60.0), 2, 8);
    for (const AxisTick& tick : along.ticks(most))
        if (!tick.text.isEmpty())
            painter.drawText(QRectF(toPixel(tick.value, 0.0).x() - 40.0, area.bottom() + 3.0, 80.0, lineHeight),
                             Qt::AlignHCenter | Qt::AlignTop, tick.text);
    const QFontMetricsF metrics(painter.font());
    const bool room = metrics.horizontalAdvance(along.text() + remark) <= area.width();
    painter.drawText(QRectF(area.left(), area.bottom() + 1.2 * lineHeight, area.width(), lineHeight),
                     Qt::AlignHCenter | Qt::AlignTop,
                     room ? along.text() + remark : metrics.elidedText(along.text(), Qt::ElideRight, area.width()));
}

} // namespace touchdown
