// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan_marks.h"

#include <algorithm>

#include <QFontMetricsF>

namespace touchdown {

namespace {

constexpr double reach = 6.0; // of a mark from its point [px]

void paintSymbol(QPainter& painter, const QPointF& at, PlanMark kind)
{
    switch (kind) {
    case PlanMark::Interest: painter.drawEllipse(at, reach - 1.0, reach - 1.0); break;
    case PlanMark::Minimum:
        painter.drawPolygon(QPolygonF({at, at + QPointF(-reach, -1.6 * reach), at + QPointF(reach, -1.6 * reach)}));
        break;
    case PlanMark::Maximum:
        painter.drawPolygon(QPolygonF({at, at + QPointF(-reach, 1.6 * reach), at + QPointF(reach, 1.6 * reach)}));
        break;
    case PlanMark::Cursor:
        painter.drawLine(at - QPointF(reach, 0.0), at + QPointF(reach, 0.0));
        painter.drawLine(at - QPointF(0.0, reach), at + QPointF(0.0, reach));
        break;
    }
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

} // namespace

void paintPlanLabel(QPainter& painter, const QPointF& centre, const QString& text, const PlotTheme& theme)
{
    QRectF box({}, boxSize(painter, text));
    box.moveCenter(centre);
    paintBox(painter, box, text, theme);
}

void paintPlanMark(QPainter& painter, const QPointF& at, PlanMark kind, const QString& text, const PlotTheme& theme)
{
    painter.setBrush(kind == PlanMark::Interest || kind == PlanMark::Cursor ? QBrush(Qt::NoBrush) : QBrush(theme.curves[1]));
    painter.setPen(QPen(theme.background, kind == PlanMark::Cursor ? 4.0 : 4.5));
    paintSymbol(painter, at, kind);
    painter.setPen(QPen(kind == PlanMark::Cursor ? theme.text : theme.curves[1], kind == PlanMark::Cursor ? 1.5 : 2.0));
    paintSymbol(painter, at, kind);
    painter.setBrush(Qt::NoBrush);
    if (text.isEmpty()) return;

    const QRectF seen = painter.clipBoundingRect();
    QRectF box({}, boxSize(painter, text));
    const double lift = kind == PlanMark::Minimum ? -0.8 * reach : kind == PlanMark::Maximum ? 0.8 * reach : 0.0;
    box.moveCenter(at + QPointF(0.0, lift));
    box.moveLeft(at.x() + reach + 5.0);
    if (at.x() > seen.center().x()) box.moveRight(at.x() - reach - 5.0);
    paintBox(painter, box, text, theme);
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
