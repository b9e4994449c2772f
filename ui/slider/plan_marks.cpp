// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/plan_marks.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "ui/slider/slider_plan.h"

namespace touchdown {

namespace {

constexpr double reach = 6.0; // of a mark from its point [px]

void paintSymbol(QPainter& painter, const PlanMark& mark)
{
    const QPointF& at = mark.at;
    if (mark.kind == PlanMark::Kind::Interest) {
        painter.drawEllipse(at, reach - 1.0, reach - 1.0);
        return;
    }
    const double height = mark.kind == PlanMark::Kind::Minimum ? -1.6 * reach : 1.6 * reach;
    painter.drawPolygon(QPolygonF({at, at + QPointF(-reach, height), at + QPointF(reach, height)}));
}

/// From the point to the middle of the symbol, downwards [px].
double lift(PlanMark::Kind kind)
{
    return kind == PlanMark::Kind::Interest ? 0.0 : kind == PlanMark::Kind::Minimum ? -0.8 * reach : 0.8 * reach;
}

void paintBox(QPainter& painter, const QRectF& box, const QString& text, const PlotTheme& theme)
{
    QColor paper = theme.background;
    paper.setAlphaF(0.82F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

QSizeF boxSize(const QPainter& painter, const QString& text)
{
    const QFontMetricsF metrics(painter.font());
    return {std::max(metrics.horizontalAdvance(text) + 8.0, metrics.height()), metrics.height()};
}

bool isFree(const QRectF& box, const TakenRoom& taken)
{
    return std::ranges::none_of(taken, [&box](const QRectF& other) { return other.intersects(box); });
}

} // namespace

bool paintPlanLabel(QPainter& painter, const QPointF& centre, const QString& text, const PlotTheme& theme,
                    TakenRoom& taken)
{
    QRectF box({}, boxSize(painter, text));
    box.moveCenter(centre);
    if (!isFree(box, taken)) return false;
    taken.push_back(box);
    paintBox(painter, box, text, theme);
    return true;
}

void paintPlanMarks(QPainter& painter, const std::vector<PlanMark>& marks, const PlotTheme& theme, TakenRoom& taken)
{
    for (const PlanMark& mark : marks) {
        painter.setBrush(mark.kind == PlanMark::Kind::Interest ? QBrush(Qt::NoBrush) : QBrush(theme.curves[1]));
        for (const QPen& pen : {QPen(theme.background, 4.5), QPen(theme.curves[1], 2.0)}) {
            painter.setPen(pen);
            paintSymbol(painter, mark);
        }
        const QPointF middle = mark.at + QPointF(0.0, lift(mark.kind));
        taken.push_back(QRectF(middle - QPointF(reach, reach), QSizeF(2.0 * reach, 2.0 * reach)));
    }
    painter.setBrush(Qt::NoBrush);

    const QRectF seen = painter.clipBoundingRect();
    for (const PlanMark& mark : marks) {
        if (mark.text.isEmpty()) continue;
        const QSizeF size = boxSize(painter, mark.text);
        const QPointF aside(reach + 5.0 + size.width() / 2.0, 0.0);
        const QPointF away(0.0, reach + 5.0 + size.height() / 2.0 + std::abs(lift(mark.kind)));
        const double inwards = mark.at.x() > seen.center().x() ? -1.0 : 1.0;
        for (const QPointF& shift : {inwards * aside, -away, away, -inwards * aside}) {
            QRectF box({}, size);
            box.moveCenter(mark.at + QPointF(0.0, lift(mark.kind)) + shift);
            if (!isFree(box, taken) || !seen.contains(box)) continue;
            taken.push_back(box);
            paintBox(painter, box, mark.text, theme);
            break;
        }
    }
}

void paintCellGrid(QPainter& painter, const SliderPlan& plan, const CellGrid& grid)
{
    if (grid.x.size() < 2 || grid.y.size() < 2) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, true);
    const QPointF first = plan.toPixel({grid.x.front(), grid.y.front()});
    const QPointF last = plan.toPixel({grid.x.back(), grid.y.back()});
    // A light line under a dark one is seen on any colour.
    for (const QPen& pen : {QPen(QColor(255, 255, 255, 60), 1.4), QPen(QColor(10, 14, 20, 110), 0.6)}) {
        painter.setPen(pen);
        for (const double x : grid.x) {
            const double at = plan.toPixel({x, 0.0}).x();
            painter.drawLine(QPointF(at, first.y()), QPointF(at, last.y()));
        }
        for (const double y : grid.y) {
            const double at = plan.toPixel({0.0, y}).y();
            painter.drawLine(QPointF(first.x(), at), QPointF(last.x(), at));
        }
    }
    painter.restore();
}

} // namespace touchdown
