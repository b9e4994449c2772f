// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/colour_bar.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QImage>

#include "ui/plot/plot_painter.h"

namespace touchdown {

namespace {

constexpr double barWidth = 16.0;  // [px]
constexpr double tickLength = 4.0; // [px]
constexpr double indent = 8.0;     // from the left of the column [px]
constexpr int steps = 256;         // of colour along the bar

} // namespace

double colourBarWidth(const QFont& font, const std::vector<ScaleTick>& ticks)
{
    const QFontMetricsF metrics(plotNumberFont(font));
    double widest = metrics.horizontalAdvance(QStringLiteral("00000"));
    for (const ScaleTick& tick : ticks) widest = std::max(widest, metrics.horizontalAdvance(tick.text));
    return std::ceil(indent + barWidth + tickLength + 4.0 + widest);
}

int colourBarRoom(const QFont& font, double height)
{
    return static_cast<int>(height / (2.5 * QFontMetricsF(plotNumberFont(font)).height()));
}

void paintColourBar(QPainter& painter, const QRectF& column, const QFont& font, const PlotTheme& theme,
                    const ColourScale& scale, const std::vector<ScaleTick>& ticks, const QString& title, bool downwards)
{
    const QFont numberFont = plotNumberFont(font);
    const double height = QFontMetricsF(numberFont).height();
    const double top = column.top() + (title.isEmpty() ? 0.0 : height + 6.0);
    const QRectF bar(column.left() + indent, top + 0.5, barWidth, column.bottom() - top - 1.0);

    QImage colours(1, steps, QImage::Format_RGB32);
    for (int i = 0; i < steps; ++i) {
        const double position = (i + 0.5) / steps;
        colours.setPixel(0, i, scale.colourAt(downwards ? position : 1.0 - position));
    }
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(bar, colours);
    painter.setPen(QPen(theme.axis, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);

    painter.setFont(numberFont);
    painter.setPen(theme.mutedText);
    if (!title.isEmpty())
        painter.drawText(QRectF(column.left() + 2.0, column.top(), column.width(), height),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, title);
    for (const ScaleTick& tick : ticks) {
        const double y =
            downwards ? bar.top() + tick.position * bar.height() : bar.bottom() - tick.position * bar.height();
        painter.setPen(QPen(theme.axis, 1.0));
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + tickLength, y));
        painter.setPen(theme.mutedText);
        // The numbers at the ends stay beside the bar.
        const double text = std::clamp(y, bar.top() + height / 2.0 - 2.0, bar.bottom() - height / 2.0 + 2.0);
        painter.drawText(QRectF(bar.right() + tickLength + 4.0, text - height / 2.0, 200.0, height),
                         Qt::AlignLeft | Qt::AlignVCenter, tick.text);
    }
    painter.restore();
}

} // namespace touchdown
