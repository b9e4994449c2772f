// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of a plot beside its curves: reference lines, events, named points, the direction of a phase portrait.
#include "ui/plot/plot_painter.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "ui/plot/plot_path.h"

namespace touchdown {

namespace {

constexpr double labelGap = 6.0; // [px]

double onPixel(double pixel)
{
    return std::floor(pixel) + 0.5; // a thin line fills one row of pixels
}

} // namespace

void PlotPainter::paintReferenceLines(QPainter& painter) const
{
    QPen pen(theme_.referenceLine, 1.0);
    pen.setDashPattern({4.0, 4.0});
    painter.setPen(pen);
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (!plot_.yAxis().range().contains(line.value)) continue;
        const double y = onPixel(up(plot_.yAxis().position(line.value)));
        painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
}

void PlotPainter::paintReferenceLabels(QPainter& painter) const
{
    painter.setFont(numberFont_);
    const QFontMetricsF metrics(numberFont_);
    std::vector<QRectF> taken;
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (line.label.isEmpty() || !plot_.yAxis().range().contains(line.value)) continue;
        const double y = up(plot_.yAxis().position(line.value));
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(line.label) + 4.0, metrics.height());
        box.moveBottomRight({area_.right() - 4.0, y - 1.0});
        if (box.top() < area_.top()) box.moveTop(y + 2.0);
        for (const QRectF& other : taken)
            if (box.intersects(other)) box.moveRight(other.left() - labelGap);
        taken.push_back(box);
        paintLabel(painter, box, line.label, theme_.mutedText);
    }
}

void PlotPainter::paintEventMarks(QPainter& painter) const
{
    painter.setPen(QPen(theme_.referenceLine, 1.0));
    double last = -1e9;
    for (const EventMark& mark : plot_.eventMarks()) {
        if (plot_.isPhasePortrait() || !plot_.xAxis().range().contains(mark.time)) continue;
        const double x = onPixel(across(plot_.xAxis().position(mark.time)));
        if (x == last) continue; // thousands of bounces fall onto one column
        last = x;
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.top() + 6.0));
    }
}

void PlotPainter::paintArrows(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < std::min(plot_.curves().size(), plot_.phasePaths().size()); ++i) {
        if (!plot_.curves()[i].arrows) continue;
        painter.setBrush(theme_.colour(plot_.curves()[i].style));
        for (const PathArrow& arrow : pathArrows(plot_.phasePaths()[i], area_.size())) {
            const QPointF along(arrow.along.x(), -arrow.along.y());
            const QPointF side(-along.y(), along.x());
            const QPointF tip = QPointF(across(arrow.tip.x()), up(arrow.tip.y())) + 4.5 * along;
            painter.drawPolygon(QPolygonF({tip, tip - 9.0 * along + 4.0 * side, tip - 9.0 * along - 4.0 * side}));
        }
    }
    painter.setBrush(Qt::NoBrush);
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
        const QPointF at(across(plot_.xAxis().position(mark.x)), up(plot_.yAxis().position(mark.y)));
        if (!area_.contains(at)) continue;
        const QPointF tip = at - QPointF(0.0, 3.0);
        painter.setBrush(theme_.colour(mark.style));
        painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4.0, -6.0), tip + QPointF(4.0, -6.0)}));
        placed.push_back({&mark, tip});
        taken.emplace_back(tip - QPointF(4.0, 6.0), QSizeF(8.0, 6.0));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setFont(numberFont_);
    const QFontMetricsF metrics(numberFont_);
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
            if (!area_.contains(box) || std::any_of(taken.begin(), taken.end(), meets)) continue;
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
