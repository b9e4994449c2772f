// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/rail_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchdown {

namespace {

/// The square of it.
double squaredDistance(const QPointF& point, const QPointF& a, const QPointF& b)
{
    const QPointF along = b - a;
    const double square = QPointF::dotProduct(along, along);
    const double part = square > 0.0 ? std::clamp(QPointF::dotProduct(point - a, along) / square, 0.0, 1.0) : 0.0;
    const QPointF away = point - a - part * along;
    return QPointF::dotProduct(away, away);
}

double distanceToOutline(const QPointF& point, const QPolygonF& polygon)
{
    double least = std::numeric_limits<double>::infinity();
    for (qsizetype i = 0; i < polygon.size(); ++i)
        least = std::min(least, squaredDistance(point, polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]));
    return std::sqrt(least);
}

bool holds(const QPolygonF& polygon, const QPointF& point) { return polygon.containsPoint(point, Qt::OddEvenFill); }

} // namespace

double distanceToEdge(const QPointF& point, const QPointF& a, const QPointF& b)
{
    return std::sqrt(squaredDistance(point, a, b));
}

QPolygonF railPolygon(const Rail& rail)
{
    QPolygonF polygon;
    for (const RailPoint& point : rail.points) polygon << QPointF(point.x, point.y);
    return polygon;
}

std::optional<std::size_t> railAt(const AirBearingSurface& surface, const SurfacePoint& point)
{
    for (std::size_t i = surface.rails.size(); i-- > 0;)
        if (holds(railPolygon(surface.rails[i]), {point.x, point.y})) return i;
    return std::nullopt;
}

std::vector<SurfacePoint> railNumberPoints(const AirBearingSurface& surface)
{
    constexpr int steps = 28; // of the search across each rail
    std::vector<QPolygonF> polygons;
    for (const Rail& rail : surface.rails) polygons.push_back(railPolygon(rail));

    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const QRectF box = polygons[i].boundingRect();
        std::vector<const QPolygonF*> above;
        for (std::size_t later = i + 1; later < polygons.size(); ++later)
            if (polygons[later].boundingRect().intersects(box)) above.push_back(&polygons[later]);
        QPointF best = box.center();
        double bestRoom = -1.0;
        bool bestFree = false;
        for (int k = 0; k < steps * steps; ++k) {
            const QPointF at(box.left() + (k % steps + 0.5) / steps * box.width(),
                             box.top() + (k / steps + 0.5) / steps * box.height());
            if (!holds(polygons[i], at)) continue;
            double room = distanceToOutline(at, polygons[i]);
            bool free = true;
            for (const QPolygonF* later : above) {
                if (bestFree && (!free || room <= bestRoom)) break; // it cannot be the best any more
                if (holds(*later, at))
                    free = false;
                else
                    room = std::min(room, distanceToOutline(at, *later));
            }
            if (free < bestFree || (free == bestFree && room <= bestRoom)) continue;
            best = at;
            bestRoom = room;
            bestFree = free;
        }
        points.push_back({best.x(), best.y()});
    }
    return points;
}

std::vector<double> recessLevels(const AirBearingSurface& surface, std::size_t most)
{
    std::vector<double> levels{surface.baseRecess};
    if (surface.rails.empty()) levels.push_back(0.0); // where rails would be: a base without any is far
    for (const Rail& rail : surface.rails) {
        const std::size_t used = rail.kind == RailKind::Step ? 1 : rail.recess.size();
        levels.insert(levels.end(), rail.recess.begin(), rail.recess.begin() + static_cast<std::ptrdiff_t>(used));
    }
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    // Too many levels: remove the one nearest to its lower neighbour.
    while (levels.size() > std::max<std::size_t>(most, 2)) {
        std::size_t nearest = 1;
        for (std::size_t i = 1; i + 1 < levels.size(); ++i)
            if (levels[i] - levels[i - 1] < levels[nearest] - levels[nearest - 1]) nearest = i;
        levels.erase(levels.begin() + static_cast<std::ptrdiff_t>(nearest));
    }
    return levels;
}

} // namespace touchdown
