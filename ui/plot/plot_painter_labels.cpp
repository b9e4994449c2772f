// SPDX-License-Identifier: GPL-3.0-or-later
//
// What has a label in a plot: reference lines and point marks.
#include "ui/plot/plot_painter.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <QFontMetricsF>

#include "ui/plot/plot_path.h"

namespace touchdown {

bool PlotPainter::isSeen(const ReferenceLine& line) const
{
    return (line.upright ? x_ : y_).range().contains(line.value);
}

void PlotPainter::paintReferenceLines(QPainter& painter) const
{
    QPen pen(theme_.referenceLine, 1.0);
    pen.setDashPattern({4.0, 4.0});
    painter.setPen(pen);
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (!isSeen(line)) continue;
        const double y = alignedPixel(frame_.up(y_.position(line.value)));
        const double x = alignedPixel(frame_.across(x_.position(line.value)));
        if (line.upright)
            painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
        else
            painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
}

/// At the right end of a level line at `y`, above it if there is room. On paper, where nobody can look below a label,
/// it is the first place from the right that no curve crosses, if there is one.
std::optional<QRectF> PlotPainter::placeOfLabel(const QSizeF& size, double y, const std::vector<QRectF>& taken) const
{
    std::optional<QRectF> first;
    QRectF box(QPointF(), size);
    for (double right = area_.right() - 4.0; right - size.width() >= area_.left(); right -= size.width()) {
        for (const double top : {y - 1.0 - size.height(), y + 2.0}) {
            box.moveTopRight({right, top});
            const auto meets = [&box](const QRectF& other) { return other.intersects(box); };
            if (!area_.contains(box) || std::ranges::any_of(taken, meets)) continue;
            if (!first) first = box;
            if (!paper_ || !isCrossed(box)) return box;
        }
    }
    return first;
}

/// Whether a curve passes through a box [px].
bool PlotPainter::isCrossed(const QRectF& box) const
{
    return std::ranges::any_of(curves_, [&](const PlotCurve& curve) {
        std::vector<QPointF> path = pathOf(curve);
        for (QPointF& point : path) {
            point = {frame_.across(point.x()), frame_.up(point.y())};
            point = {(point.x() - box.left()) / box.width(), (point.y() - box.top()) / box.height()};
        }
        return !insideArea(path).empty();
    });
}

void PlotPainter::paintReferenceLabels(QPainter& painter) const
{
    painter.setFont(frame_.numberFont);
    const QFontMetricsF metrics(frame_.numberFont);
    std::vector<QRectF> taken;
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (line.label.isEmpty() || !isSeen(line)) continue;
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(line.label) + 4.0, metrics.height());
        if (line.upright) {
            // Beside its line at the bottom, where no peak has its label, above the labels of its neighbours.
            const double x = frame_.across(x_.position(line.value));
            box.moveBottomLeft({x + 3.0, area_.bottom() - 2.0});
            if (box.right() > area_.right()) box.moveRight(x - 3.0);
            for (const QRectF& other : taken)
                if (box.intersects(other)) box.moveBottom(other.top() - 1.0);
            if (box.top() < area_.top()) continue;
        } else {
            const std::optional<QRectF> free = placeOfLabel(box.size(), frame_.up(y_.position(line.value)), taken);
            if (!free) continue;
            box = *free;
        }
        taken.push_back(box);
        paintLabel(painter, box, line.label, theme_.mutedText);
    }
}

void PlotPainter::paintPointMarks(QPainter& painter) const
{
    struct Placed {
        const PointMark* mark;
        QPointF tip;
    };
    std::vector<Placed> placed;
    std::vector<QRectF> taken;
    painter.setPen(Qt::NoPen);
    for (const PointMark& mark : plot_.pointMarks()) {
        const QPointF at(frame_.across(x_.position(mark.x)), frame_.up(y_.position(mark.y)));
        if (!area_.contains(at)) continue;
        const QPointF tip = at - QPointF(0.0, 3.0);
        painter.setBrush(theme_.colour(mark.style));
        painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4.0, -6.0), tip + QPointF(4.0, -6.0)}));
        placed.push_back({&mark, tip});
        taken.emplace_back(tip - QPointF(4.0, 6.0), QSizeF(8.0, 6.0));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setFont(frame_.numberFont);
    const QFontMetricsF metrics(frame_.numberFont);
    for (const auto& [mark, tip] : placed) {
        const QSizeF size(metrics.horizontalAdvance(mark->label) + 4.0, metrics.height());
        // The highest point may have no room above it: its label stands beside it, below the plot's upper edge.
        const double beside = std::max(tip.y() - size.height(), area_.top());
        const QPointF corners[] = {tip - QPointF(size.width() / 2.0, 7.0 + size.height()),
                                   {tip.x() + 6.0, beside},
                                   {tip.x() - 6.0 - size.width(), beside}};
        for (const QPointF& corner : corners) {
            const QRectF box(corner, size);
            const auto meets = [&](const QRectF& other) { return other.intersects(box); };
            if (!area_.contains(box) || std::ranges::any_of(taken, meets)) continue;
            taken.push_back(box);
            paintLabel(painter, box, mark->label, theme_.text);
            break; // without room anywhere the marker stands alone
        }
    }
}

void PlotPainter::paintLabel(QPainter& painter, const QRectF& box, const QString& text, const QColor& colour) const
{
    QColor paper = theme_.plotArea;
    paper.setAlphaF(0.75F);
    painter.fillRect(box, paper);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace touchdown
