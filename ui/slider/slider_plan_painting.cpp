// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/slider_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "ui/plot/plot_painter.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

void SliderPlan::paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme)
{
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    paint(painter, theme);
    painter.restore();
}

void SliderPlan::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter, plotTheme(palette()));
}

void SliderPlan::paint(QPainter& painter, const PlotTheme& theme)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme.background);
    painter.save();
    painter.setClipRect(planArea(), Qt::IntersectClip);
    paintContent(painter, theme);
    paintSurroundings(painter, theme);
    painter.restore();
    paintScales(painter, theme);
    paintHeader(painter, theme);
    const QRectF area = planArea();
    paintKey(painter, QRectF(area.right() + gap, area.top(), keyWidth(), area.height()), theme);
}

void SliderPlan::paintSurroundings(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF outline = QRectF(toPixel({area_.left(), area_.bottom()}), toPixel({area_.right(), area_.top()}));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.text, 1.2));
    painter.drawRect(outline);
    if (!slider_) return;

    const QFont font = plotNumberFont(this->font());
    const double text = QFontMetricsF(font).height();
    painter.setFont(font);
    painter.setPen(theme.mutedText);
    painter.drawText(QRectF(outline.left(), outline.bottom() + gap, outline.width(), text), Qt::AlignCenter,
                     tr("inner edge"));
    painter.drawText(QRectF(outline.left(), outline.top() - gap - text, outline.width(), text), Qt::AlignCenter,
                     tr("outer edge"));
    const auto drawUpright = [&](double x, double turn, const QString& name) {
        painter.save();
        painter.translate(x, outline.center().y());
        painter.rotate(turn);
        painter.drawText(QRectF(-outline.height() / 2.0, -text / 2.0, outline.height(), text), Qt::AlignCenter, name);
        painter.restore();
    };
    drawUpright(outline.left() - gap - text / 2.0, -90.0, tr("leading edge"));
    drawUpright(outline.right() + gap + text / 2.0, 90.0, tr("trailing edge"));
    paintAirFlow(painter, theme);
}

void SliderPlan::paintAirFlow(QPainter& painter, const PlotTheme& theme) const
{
    const QFont font = plotNumberFont(this->font());
    const QFontMetricsF metrics(font);
    const QPointF tip = toPixel({area_.left(), area_.center().y()}) - QPointF(2.0 * gap + metrics.height(), 0.0);
    // On the screen y points down, and positive skew turns the flow towards the inner edge, which is below.
    const QPointF along(std::cos(skew_), std::sin(skew_));
    const QPointF across(-along.y(), along.x());
    const QPointF tail = tip - arrowLength * along;
    painter.setPen(QPen(theme.mutedText, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(tail, tip - 6.0 * along);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.mutedText);
    painter.drawPolygon(QPolygonF({tip, tip - 9.0 * along + 4.5 * across, tip - 9.0 * along - 4.5 * across}));
    painter.setBrush(Qt::NoBrush);

    painter.setFont(font);
    painter.setPen(theme.mutedText);
    const QRectF box(tip.x() - arrowLength - 2.0 * gap, 0.0, arrowLength + 3.0 * gap, metrics.height());
    const double half = 0.5 * arrowLength * std::abs(along.y()) + 8.0;
    const double middle = 0.5 * (tip.y() + tail.y());
    painter.drawText(box.translated(0.0, middle - half - metrics.height()), Qt::AlignCenter | Qt::TextDontClip,
                     tr("air"));
    if (skew_ != 0.0)
        painter.drawText(box.translated(0.0, middle + half), Qt::AlignCenter | Qt::TextDontClip,
                         typeset(skew_ * 180.0 / std::numbers::pi, 1) + QStringLiteral("°"));
}

void SliderPlan::paintScales(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = planArea();
    const QRectF seen = view();
    const PlotAxis x = axis(QStringLiteral("x"), seen.left(), seen.right());
    const PlotAxis y = axis(QStringLiteral("y"), seen.top(), seen.bottom());
    const double rounding = 1e-6 * std::max(area_.width(), area_.height());
    const QFont numberFont = plotNumberFont(font());
    const QFontMetricsF numbers(numberFont);
    painter.setPen(QPen(theme.axis, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(
        QRectF(std::floor(area.left()) + 0.5, std::floor(area.top()) + 0.5, area.width() - 1.0, area.height() - 1.0));

    painter.setFont(numberFont);
    const int mostX = static_cast<int>(area.width() / numbers.horizontalAdvance(QStringLiteral("00000.000")));
    for (const AxisTick& tick : x.ticks(std::min(12, mostX))) {
        if (tick.value < area_.left() - rounding || tick.value > area_.right() + rounding) continue; // there is nothing
        const double at = toPixel({tick.value, area_.top()}).x();
        painter.setPen(QPen(theme.axis, 1.0));
        painter.drawLine(QPointF(at, area.bottom()), QPointF(at, area.bottom() + tickLength));
        painter.setPen(theme.mutedText);
        painter.drawText(QRectF(at - 50.0, area.bottom() + tickLength, 100.0, numbers.height()), Qt::AlignCenter,
                         tick.text);
    }
    for (const AxisTick& tick : y.ticks(std::min(12, static_cast<int>(area.height() / (2.0 * numbers.height()))))) {
        if (tick.value < area_.top() - rounding || tick.value > area_.bottom() + rounding) continue;
        const double at = toPixel({area_.left(), tick.value}).y();
        painter.setPen(QPen(theme.axis, 1.0));
        painter.drawLine(QPointF(area.left() - tickLength, at), QPointF(area.left(), at));
        painter.setPen(theme.mutedText);
        painter.drawText(QRectF(0.0, at - numbers.height() / 2.0, area.left() - tickLength - 3.0, numbers.height()),
                         Qt::AlignRight | Qt::AlignVCenter, tick.text);
    }

    const QFont textFont = plotTextFont(font());
    const double text = QFontMetricsF(textFont).height();
    painter.setFont(textFont);
    painter.setPen(theme.text);
    painter.drawText(QRectF(area.left(), area.bottom() + tickLength + numbers.height() + 2.0, area.width(), text + 2.0),
                     Qt::AlignCenter, x.text());
    painter.save();
    painter.translate(gap, area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, 0.0, area.height(), text), Qt::AlignCenter, y.text());
    painter.restore();
}

void SliderPlan::paintHeader(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = planArea();
    QFont font = plotTextFont(this->font());
    const QFontMetricsF metrics(font);
    const QRectF row(area.left(), gap, width() - area.left() - gap, metrics.height());
    QFont heavy = font;
    heavy.setWeight(QFont::DemiBold);
    const QFontMetricsF heavyMetrics(heavy);
    const double read = std::min(metrics.horizontalAdvance(reading_), row.width());
    const QString title = heavyMetrics.elidedText(title_, Qt::ElideRight, row.width() - read - 2.0 * gap);
    painter.setFont(heavy);
    painter.setPen(theme.text);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, title);
    painter.setFont(font);
    painter.setPen(theme.mutedText);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, metrics.elidedText(reading_, Qt::ElideRight, row.width()));
}

} // namespace touchdown
