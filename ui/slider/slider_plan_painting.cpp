// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands around the content of a plan: outline, edges, air flow, scales, title and reading.
#include "ui/slider/slider_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <QFontMetricsF>
#include <QPainter>

#include "ui/plot/plot_frame.h"
#include "ui/slider/plan_marks.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

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
    const QRectF area = planArea();
    paintKey(painter, QRectF(area.right() + PlotFrame::gap, area.top(), keyWidth(), area.height()), theme);
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
    painter.drawText(QRectF(outline.left(), outline.bottom() + PlotFrame::gap, outline.width(), text), Qt::AlignCenter,
                     tr("inner edge"));
    painter.drawText(QRectF(outline.left(), outline.top() - PlotFrame::gap - text, outline.width(), text),
                     airAbove() ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignCenter, tr("outer edge"));
    const auto drawUpright = [&](double x, double turn, const QString& name) {
        painter.save();
        painter.translate(x, outline.center().y());
        painter.rotate(turn);
        painter.drawText(QRectF(-outline.height() / 2.0, -text / 2.0, outline.height(), text), Qt::AlignCenter, name);
        painter.restore();
    };
    drawUpright(outline.left() - PlotFrame::gap - text / 2.0, -90.0, tr("leading edge"));
    drawUpright(outline.right() + PlotFrame::gap + text / 2.0, 90.0, tr("trailing edge"));
    paintAirFlow(painter, theme);
}

void SliderPlan::paintAirFlow(QPainter& painter, const PlotTheme& theme) const
{
    const QFont font = plotNumberFont(this->font());
    const QFontMetricsF metrics(font);
    // On the screen y points down, and positive skew turns the flow towards the inner edge, which is below.
    const QPointF along(std::cos(skew_), std::sin(skew_));
    const QPointF across(-along.y(), along.x());
    const QPointF corner = toPixel({area_.left(), area_.bottom()});
    const double length = airAbove() ? arrowOnPaper : arrowLength;
    QPointF tip = toPixel({area_.left(), area_.center().y()}) - QPointF(2.0 * PlotFrame::gap + metrics.height(), 0.0);
    // On paper above the leading end of the slider.
    const double above = corner.y() - PlotFrame::gap - 0.5 * metrics.height();
    if (airAbove()) tip = QPointF(std::max(corner.x() - metrics.height(), planArea().left() + 2.0) + length, above);
    const QPointF tail = tip - length * along;
    const QString turn = skew_ != 0.0 ? typeset(skew_ * 180.0 / std::numbers::pi, 1) + QStringLiteral("°") : QString();
    painter.setPen(QPen(theme.mutedText, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(tail, tip - 6.0 * along);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.mutedText);
    painter.drawPolygon(QPolygonF({tip, tip - 9.0 * along + 4.5 * across, tip - 9.0 * along - 4.5 * across}));
    painter.setBrush(Qt::NoBrush);

    painter.setFont(font);
    painter.setPen(theme.mutedText);
    if (airAbove()) {
        painter.drawText(QRectF(tip.x() + PlotFrame::gap, above - 0.5 * metrics.height(), 0.0, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, tr("air") + QLatin1Char(' ') + turn);
        return;
    }
    const QRectF box(tip.x() - arrowLength - 2.0 * PlotFrame::gap, 0.0, arrowLength + 3.0 * PlotFrame::gap,
                     metrics.height());
    const double half = 0.5 * arrowLength * std::abs(along.y()) + 8.0;
    const double middle = 0.5 * (tip.y() + tail.y());
    painter.drawText(box.translated(0.0, middle - half - metrics.height()), Qt::AlignCenter | Qt::TextDontClip,
                     tr("air"));
    painter.drawText(box.translated(0.0, middle + half), Qt::AlignCenter | Qt::TextDontClip, turn);
}

void SliderPlan::paintGrid(QPainter& painter) const
{
    if (gridShown_) paintCellGrid(painter, *this, grid_);
}

void SliderPlan::paintScales(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = planArea();
    const QRectF seen = view();
    PlotAxis x, y;
    x.label = axisLabel(QStringLiteral("x"));
    y.label = axisLabel(QStringLiteral("y"));
    x.setRange({seen.left(), seen.right()});
    y.setRange({seen.top(), seen.bottom()});
    const double rounding = 1e-6 * std::max(area_.width(), area_.height());
    painter.setPen(QPen(theme.axis, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(
        QRectF(std::floor(area.left()) + 0.5, std::floor(area.top()) + 0.5, area.width() - 1.0, area.height() - 1.0));

    PlotFrame frame(area, font(), x, y, 12);
    const auto keepWithin = [rounding](std::vector<AxisTick>& ticks, double low, double high) {
        std::erase_if(ticks, [&](const AxisTick& t) { return t.value < low - rounding || t.value > high + rounding; });
    };
    keepWithin(frame.xTicks, area_.left(), area_.right()); // beside the slider there is nothing
    keepWithin(frame.yTicks, area_.top(), area_.bottom());
    frame.paintNumbers(painter, theme, width());
    frame.paintAxisTitles(painter, theme);
    paintHeader(painter, theme, frame);
}

void SliderPlan::paintHeader(QPainter& painter, const PlotTheme& theme, const PlotFrame& frame) const
{
    const QFontMetricsF metrics(frame.textFont);
    const QRectF row(frame.area.left(), PlotFrame::gap, width() - frame.area.left() - PlotFrame::gap, metrics.height());
    const QString said = paper_ ? QString() : reading();
    const double read = std::min(metrics.horizontalAdvance(said), row.width());
    frame.paintTitle(painter, theme, title_, row.width() - read - 2.0 * PlotFrame::gap);
    painter.setFont(frame.textFont);
    painter.setPen(theme.mutedText);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, metrics.elidedText(said, Qt::ElideRight, row.width()));
}

} // namespace touchdown
