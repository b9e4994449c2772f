// SPDX-License-Identifier: GPL-3.0-or-later
//
// What has a label in a plot: shaded areas, reference lines and point marks.
#include "ui/plot/plot_painter.h"

#include <algorithm>
#include <cmath>
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

/// The marks whose point is inside the area; QRectF contains what is not finite, too.
std::vector<PlotPainter::PlacedMark> PlotPainter::placeMarks() const
{
    std::vector<PlacedMark> placed;
    for (const PointMark& mark : plot_.pointMarks()) {
        const QPointF at(frame_.across(x_.position(mark.x)), frame_.up(y_.position(mark.y)));
        if (std::isfinite(at.x()) && std::isfinite(at.y()) && area_.contains(at))
            placed.push_back({&mark, at - QPointF(0.0, 3.0)});
    }
    return placed;
}

std::vector<QRectF> PlotPainter::pointers() const
{
    std::vector<QRectF> boxes;
    for (const auto& [mark, tip] : placeMarks()) boxes.emplace_back(tip - QPointF(4.0, 6.0), QSizeF(8.0, 6.0));
    return boxes;
}

std::vector<PlotLabel> PlotPainter::labels() const
{
    std::vector<PlotLabel> labels;
    std::vector<QRectF> taken = pointers();
    const QFontMetricsF metrics(frame_.numberFont);
    const auto sizeOf = [&](const QString& text) {
        return QSizeF(metrics.horizontalAdvance(text) + 4.0, metrics.height());
    };
    const auto meets = [&taken](const QRectF& box) {
        return std::ranges::find_if(taken, [&box](const QRectF& other) { return other.intersects(box); });
    };
    const auto add = [&](const QRectF& box, const QString& text, const QColor& colour, bool behind = false) {
        taken.push_back(box);
        labels.push_back({box, text, colour, behind});
    };

    // The fewer places a label has, the sooner it chooses: areas and words at points three, lines many.
    for (const ShadedArea& shaded : plot_.shadedAreas()) {
        if (shaded.label.isEmpty()) continue;
        QRectF box(QPointF(), sizeOf(shaded.label));
        const QPointF centre = outlineOf(shaded).boundingRect().center();
        for (const double higher : {0.0, box.height(), -box.height()}) {
            box.moveCenter(centre - QPointF(0.0, higher));
            if (!area_.contains(box) || meets(box) != taken.end()) continue;
            add(box, shaded.label, theme_.text, true);
            break;
        }
    }
    for (const auto& [mark, tip] : placeMarks()) {
        const QSizeF size = sizeOf(mark->label);
        // The highest point may have no room above it: its label stands beside it, below the plot's upper edge.
        const double beside = std::max(tip.y() - size.height(), area_.top());
        const QPointF corners[] = {tip - QPointF(size.width() / 2.0, 7.0 + size.height()),
                                   {tip.x() + 6.0, beside},
                                   {tip.x() - 6.0 - size.width(), beside}};
        for (const QPointF& corner : corners) {
            const QRectF box(corner, size);
            if (!area_.contains(box) || meets(box) != taken.end()) continue;
            add(box, mark->label, theme_.text);
            break; // without room anywhere the marker stands alone
        }
    }
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (line.label.isEmpty() || !isSeen(line)) continue;
        QRectF box(QPointF(), sizeOf(line.label));
        if (line.upright) {
            // Beside its line at the bottom, where no peak has its label, above the labels of its neighbours.
            const double x = frame_.across(x_.position(line.value));
            box.moveBottomLeft({x + 3.0, area_.bottom() - 2.0});
            if (box.right() > area_.right()) box.moveRight(x - 3.0);
            for (auto other = meets(box); other != taken.end(); other = meets(box)) box.moveBottom(other->top() - 1.0);
            if (box.top() < area_.top()) continue;
        } else {
            const std::optional<QRectF> free = placeOfLabel(box.size(), frame_.up(y_.position(line.value)), taken);
            if (!free) continue;
            box = *free;
        }
        add(box, line.label, theme_.mutedText);
    }
    return labels;
}

void PlotPainter::paintPointers(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (const auto& [mark, tip] : placeMarks()) {
        painter.setBrush(theme_.colour(mark->style));
        painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4.0, -6.0), tip + QPointF(4.0, -6.0)}));
    }
    painter.setBrush(Qt::NoBrush);
}

void PlotPainter::paintLabels(QPainter& painter, bool behind) const
{
    painter.setFont(frame_.numberFont);
    QColor paper = theme_.plotArea;
    paper.setAlphaF(0.75F);
    for (const auto& [box, text, colour, isBehind] : labels()) {
        if (isBehind != behind) continue;
        painter.fillRect(box, paper);
        painter.setPen(colour);
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

} // namespace touchdown
