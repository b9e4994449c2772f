// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the plan shows what a change of a part would do.
#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/slider/rail_drawing.h"
#include "ui/slider/surface_editor.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double longestArrow = 44.0, shortestArrow = 4.0; // [px]
constexpr double recessStep = 10e-9, edgeStep = 1e-6;      // of which the words tell [m]

/// The largest size of all of one kind.
double largest(const std::vector<std::pair<SurfacePart, double>>& influence, PartKind kind)
{
    double most = 0.0;
    for (const auto& [part, value] : influence)
        if (part.kind == kind) most = std::max(most, std::abs(value));
    return most;
}

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& way, const QColor& colour)
{
    const double length = std::hypot(way.x(), way.y());
    if (length < shortestArrow) return;
    const QPointF along = way / length, across(-along.y(), along.x()), tip = from + way;
    painter.setPen(QPen(colour, 2.4));
    painter.drawLine(from, tip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(
        QPolygonF({tip + 3.0 * along, tip - 6.0 * along + 4.5 * across, tip - 6.0 * along - 4.5 * across}));
    painter.setBrush(Qt::NoBrush);
}

} // namespace

void SurfaceEditor::paintInfluence(QPainter& painter, const PlotTheme& theme) const
{
    if (influence_.empty()) return;
    const QColor raises = theme.curves[0], lowers = theme.curves[1];
    const double mostRail = largest(influence_, PartKind::Rail), mostEdge = largest(influence_, PartKind::Edge);
    for (const auto& [part, value] : influence_) {
        if (!has(surface(), part)) continue;
        const std::vector<RailPoint>& points = surface().rails[part.item].points;
        if (part.kind == PartKind::Rail) {
            QColor fill = value > 0.0 ? raises : lowers;
            fill.setAlphaF(static_cast<float>(0.75 * std::sqrt(std::abs(value) / std::max(mostRail, 1e-300))));
            QPolygonF outline;
            for (const RailPoint& point : points) outline << toPixel({point.x, point.y});
            painter.setPen(Qt::NoPen);
            painter.setBrush(fill);
            painter.drawPolygon(outline);
            painter.setBrush(Qt::NoBrush);
            continue;
        }
        const RailPoint &a = points[part.index], &b = points[(part.index + 1) % points.size()];
        const QPointF from = toPixel({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
        QPointF normal(b.y - a.y, b.x - a.x); // on the screen y points down
        normal /= std::max(std::hypot(normal.x(), normal.y()), 1e-300);
        const QPointF probe = from + 2.0 * normal;
        if (railPolygon(surface().rails[part.item])
                .containsPoint({toSlider(probe).x, toSlider(probe).y}, Qt::OddEvenFill))
            normal = -normal; // outwards
        paintArrow(painter, from, longestArrow * value / std::max(mostEdge, 1e-300) * normal, theme.text);
    }
}

QString SurfaceEditor::influenceWords() const
{
    const double mostRail = largest(influence_, PartKind::Rail), mostEdge = largest(influence_, PartKind::Edge);
    QString words = tr("10 nm more recess raises (blue) or lowers (orange) the minimum spacing by up to %1.")
                        .arg(lengthText(mostRail * recessStep, 2));
    const QString perEdge = lengthText(mostEdge * edgeStep, 2);
    if (mostEdge > 0.0) words += tr(" An edge moved along its arrow raises it, by up to %1 per µm.").arg(perEdge);
    return words;
}

} // namespace touchdown
