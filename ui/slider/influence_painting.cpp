// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/influence_painting.h"

#include <algorithm>
#include <cmath>

#include "ui/slider/rail_drawing.h"
#include "ui/slider/surface_view.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double longestArrow = 44.0, shortestArrow = 4.0; // [px]
constexpr double recessStep = 10e-9, edgeStep = 1e-6;      // of which the words of an influence speak [m]

/// The largest size of all of one kind.
double largest(const ShownInfluence& influence, PartKind kind)
{
    double most = 0.0;
    for (const auto& [part, value] : influence)
        if (part.kind == kind) most = std::max(most, std::abs(value));
    return most;
}

/// "0.036 nm", "−12 nm".
QString twoDigits(double metres)
{
    const double size = std::abs(metres) * 1e9;
    const int decimals = size > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(size))), 0, 9) : 0;
    return typeset(metres * 1e9, decimals) + QStringLiteral("\u00A0nm");
}

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& way, const PlotTheme& theme)
{
    const double length = std::hypot(way.x(), way.y());
    if (length < shortestArrow) return;
    const QPointF along = way / length, across(-along.y(), along.x()), tip = from + way;
    const QPolygonF head({tip + 3.0 * along, tip - 6.0 * along + 4.5 * across, tip - 6.0 * along - 4.5 * across});
    const bool dark = theme.background.lightness() < 128;
    const QColor ink = dark ? Qt::white : Qt::black;
    // A rim in the other one, so that it is seen on any colour.
    for (const auto& [colour, rim] : {std::pair(QColor(dark ? Qt::black : Qt::white), 3.6), std::pair(ink, 0.0)}) {
        painter.setPen(QPen(colour, 2.4 + rim));
        painter.drawLine(from, tip);
        painter.setPen(rim > 0.0 ? QPen(colour, rim) : QPen(Qt::NoPen));
        painter.setBrush(colour);
        painter.drawPolygon(head);
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace

std::optional<ColourScale> influenceScale(const ShownInfluence& influence, const PlotTheme& theme)
{
    const double most = largest(influence, PartKind::Rail);
    if (!(most > 0.0)) return {};
    const bool dark = theme.background.lightness() < 128;
    return ColourScale::aboutZero(dark ? ColourMap::DivergingOnDark : ColourMap::DivergingOnLight, -most, most);
}

void paintInfluenceTops(QPainter& painter, const SurfaceView& plan, const ShownInfluence& influence,
                        const PlotTheme& theme)
{
    const auto scale = influenceScale(influence, theme);
    if (!scale) return;
    const QRectF area = plan.area();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.grid);
    painter.drawRect(QRectF(plan.toPixel({area.left(), area.bottom()}), plan.toPixel({area.right(), area.top()})));
    for (const auto& [part, value] : influence) {
        if (part.kind != PartKind::Rail || !has(plan.surface(), part)) continue;
        QPolygonF top;
        for (const RailPoint& point : plan.surface().rails[part.item].points) top << plan.toPixel({point.x, point.y});
        painter.setBrush(QColor(scale->colour(value)));
        painter.drawPolygon(top);
    }
    painter.setBrush(Qt::NoBrush);
}

void paintInfluenceArrows(QPainter& painter, const SurfaceView& plan, const ShownInfluence& influence,
                          const PlotTheme& theme)
{
    const double mostEdge = largest(influence, PartKind::Edge);
    for (const auto& [part, value] : influence) {
        if (part.kind != PartKind::Edge || !has(plan.surface(), part)) continue;
        const std::vector<RailPoint>& points = plan.surface().rails[part.item].points;
        const RailPoint &a = points[part.index], &b = points[(part.index + 1) % points.size()];
        const QPointF from = plan.toPixel({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
        QPointF normal(b.y - a.y, b.x - a.x); // on the screen y points down
        normal /= std::max(std::hypot(normal.x(), normal.y()), 1e-300);
        const SurfacePoint probe = plan.toSlider(from + 2.0 * normal);
        if (railPolygon(plan.surface().rails[part.item]).containsPoint({probe.x, probe.y}, Qt::OddEvenFill))
            normal = -normal; // outwards
        paintArrow(painter, from, longestArrow * value / std::max(mostEdge, 1e-300) * normal, theme);
    }
}

QString influenceWords(const ShownInfluence& influence)
{
    const double mostRail = largest(influence, PartKind::Rail), mostEdge = largest(influence, PartKind::Edge);
    QString words = tr("min changes by up to %1 per 10 nm of recess").arg(twoDigits(mostRail * recessStep));
    if (mostEdge > 0.0) words += tr("; arrows raise it by up to %1 per µm").arg(twoDigits(mostEdge * edgeStep));
    return words;
}

QString influenceText(const ShownInfluence& influence, const SurfacePart& part)
{
    for (const auto& [each, value] : influence) {
        if (each != part) continue;
        return part.kind == PartKind::Rail ? tr("10 nm more recess: min %1").arg(twoDigits(value * recessStep))
                                           : tr("1 µm outwards: min %1").arg(twoDigits(value * edgeStep));
    }
    return {};
}

} // namespace touchdown
