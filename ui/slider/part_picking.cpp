// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/part_picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QCoreApplication>

#include "core/physics/slider/surface_relations.h"
#include "ui/slider/kept_distances.h"
#include "ui/slider/rail_drawing.h"
#include "ui/slider/slider_plan.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double cornerReach = 8.0, edgeReach = 5.0; // [px]
constexpr double sameDistance = 0.5;                 // [px]

double apart(const QPointF& a, const QPointF& b) { return std::hypot(b.x() - a.x(), b.y() - a.y()); }

/// The nearest of all that are offered within a reach; the first of those that are about as near.
class Nearest {
public:
    explicit Nearest(double reach) : best_(reach) {}
    void offer(const SurfacePart& part, double distance, bool preferred)
    {
        const double least = part_ ? best_ - sameDistance : best_;
        if (distance > reach_ || (distance >= least && preferred == preferred_) || (preferred_ && !preferred)) return;
        best_ = distance;
        preferred_ = preferred;
        part_ = part;
    }
    const std::optional<SurfacePart>& part() const { return part_; }

private:
    double best_, reach_ = best_;
    bool preferred_ = false;
    std::optional<SurfacePart> part_;
};

bool isOf(const PartSelection& parts, std::size_t rail)
{
    return std::ranges::any_of(parts, [rail](const SurfacePart& part) { return isOfRail(part) && part.item == rail; });
}

QString translated(const char* text) { return QCoreApplication::translate("SurfaceEditor", text); }

QString railPlaceText(const RailPlace& place, bool whole)
{
    const PartKind kind = place.edge ? PartKind::Edge : PartKind::Corner;
    return partText(whole ? SurfacePart{kind, place.rail, place.corner} : SurfacePart{PartKind::Rail, place.rail});
}

} // namespace

std::optional<SurfacePart> partAt(const SliderPlan& plan, const AirBearingSurface& surface, const QPointF& pixel,
                                  const PartSelection& preferred)
{
    Nearest corner(cornerReach), edge(edgeReach);
    for (std::size_t i = 0; i < surface.pointsOfInterest.size(); ++i)
        corner.offer({PartKind::Interest, i}, apart(pixel, plan.toPixel(surface.pointsOfInterest[i])), true);
    // From the top: of corners that coincide the one that is seen is first.
    for (std::size_t i = surface.rails.size(); i-- > 0;) {
        const std::vector<RailPoint>& points = surface.rails[i].points;
        const bool first = isOf(preferred, i);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const RailPoint& next = points[(k + 1) % points.size()];
            const QPointF a = plan.toPixel({points[k].x, points[k].y}), b = plan.toPixel({next.x, next.y});
            corner.offer({PartKind::Corner, i, k}, apart(pixel, a), first);
            edge.offer({PartKind::Edge, i, k}, distanceToEdge(pixel, a, b), first);
        }
    }
    if (corner.part()) return corner.part();
    if (const auto distance = keptDistanceAt(plan, surface, pixel)) return SurfacePart{PartKind::Distance, *distance};
    if (edge.part()) return edge.part();
    if (const auto rail = railAt(surface, plan.toSlider(pixel))) return SurfacePart{PartKind::Rail, *rail};
    return {};
}

PartSelection partsWithin(const AirBearingSurface& surface, const QRectF& area)
{
    PartSelection rails, corners, interests;
    for (std::size_t i = 0; i < surface.rails.size(); ++i) {
        bool whole = true;
        for (std::size_t k = 0; k < surface.rails[i].points.size(); ++k) {
            const RailPoint& point = surface.rails[i].points[k];
            if (area.contains(point.x, point.y))
                corners.insert({PartKind::Corner, i, k});
            else
                whole = false;
        }
        if (whole) rails.insert({PartKind::Rail, i});
    }
    for (std::size_t i = 0; i < surface.pointsOfInterest.size(); ++i)
        if (area.contains(surface.pointsOfInterest[i].x, surface.pointsOfInterest[i].y))
            interests.insert({PartKind::Interest, i});
    PartSelection found = rails.empty() ? corners : rails;
    found.merge(interests);
    return found;
}

PartSelection railsOf(const PartSelection& parts)
{
    PartSelection rails;
    for (const SurfacePart& part : parts)
        if (isOfRail(part)) rails.insert({PartKind::Rail, part.item});
    return rails;
}

std::set<std::size_t> sameRails(const AirBearingSurface& before, const AirBearingSurface& after,
                                const std::set<std::size_t>& rails)
{
    std::set<std::size_t> same;
    for (const std::size_t rail : rails) {
        if (rail >= before.rails.size()) continue;
        const bool kept = rail < after.rails.size() && after.rails[rail] == before.rails[rail];
        const auto equal = std::ranges::find(after.rails, before.rails[rail]);
        if (!kept && equal != after.rails.end())
            same.insert(static_cast<std::size_t>(equal - after.rails.begin()));
        else if (kept || before.rails.size() == after.rails.size())
            same.insert(rail);
    }
    return same;
}

QString partText(const SurfacePart& part)
{
    const QString item = QString::number(part.item + 1), index = QString::number(part.index + 1);
    switch (part.kind) {
    case PartKind::Rail: return translated("rail %1").arg(item);
    case PartKind::Edge: return translated("edge %1 of rail %2").arg(index, item);
    case PartKind::Corner: return translated("corner %1 of rail %2").arg(index, item);
    case PartKind::Interest: return translated("point of interest %1").arg(item);
    case PartKind::Distance: return translated("kept distance %1").arg(item);
    case PartKind::Symmetry: return translated("kept symmetry %1").arg(item);
    }
    return {};
}

QString selectionText(const PartSelection& parts)
{
    if (parts.size() == 1) return partText(*parts.begin());
    return translated("%1 parts").arg(parts.size());
}

QString relationText(const AirBearingSurface& surface, const SurfacePart& relation, bool whole)
{
    if (relation.kind == PartKind::Symmetry) {
        const auto [rail, image] = surface.symmetries[relation.item];
        if (rail == image) return translated("rail %1 stays symmetric").arg(rail + 1);
        return translated("rails %1 and %2 stay mirror images").arg(rail + 1).arg(image + 1);
    }
    const auto& [from, to, alongX, value] = surface.distances[relation.item];
    const bool places = whole || from.rail == to.rail;
    return translated("%1 stays %2 from %3 along %4")
        .arg(railPlaceText(to, places), lengthText(value), railPlaceText(from, places),
             alongX ? QStringLiteral("x") : QStringLiteral("y"));
}

QString snapText(SnapTarget target, const SurfacePart& corner)
{
    switch (target) {
    case SnapTarget::Corner: return partText(corner);
    case SnapTarget::Centre: return translated("centre line");
    case SnapTarget::Border: return translated("border");
    case SnapTarget::Raster:
    case SnapTarget::None: break;
    }
    return {};
}

SnappedPlace snappedTo(const std::vector<SurfacePoint>& places, const AirBearingSurface& surface,
                       const PartSelection& moving, SurfacePoint at, const SnapGrid& grid)
{
    const auto away = [&](const SurfacePoint& place) { return std::hypot(place.x - at.x, place.y - at.y); };
    const auto nearest = std::ranges::min_element(places, {}, away);
    if (nearest == places.end() || away(*nearest) > grid.reach) return snapped(surface, moving, at, grid);
    return {*nearest, {}, {}, {}, {}};
}

SurfacePoint placeOf(const AirBearingSurface& surface, const SurfacePart& part, SurfacePoint near)
{
    if (part.kind == PartKind::Interest) return surface.pointsOfInterest[part.item];
    if (part.kind == PartKind::Distance) return middleOf(surface, surface.distances[part.item].to);
    if (part.kind == PartKind::Symmetry)
        return placeOf(surface, {PartKind::Corner, surface.symmetries[part.item].image}, near);
    const std::vector<RailPoint>& points = surface.rails[part.item].points;
    std::size_t corner = part.index;
    if (part.kind == PartKind::Rail) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < points.size(); ++k)
            if (const double away = std::hypot(points[k].x - near.x, points[k].y - near.y); away < least)
                least = away, corner = k;
    }
    return {points[corner].x, points[corner].y};
}

std::vector<SurfacePoint> placesToMeasure(const AirBearingSurface& surface, const PartSelection& parts)
{
    std::vector<SurfacePoint> places;
    for (const SurfacePart& part : parts)
        if (part.kind == PartKind::Corner || part.kind == PartKind::Interest)
            places.push_back(placeOf(surface, part, {}));
    if (parts.size() == 1 && parts.begin()->kind == PartKind::Edge) {
        const std::vector<RailPoint>& points = surface.rails[parts.begin()->item].points;
        for (const std::size_t k : {parts.begin()->index, (parts.begin()->index + 1) % points.size()})
            places.push_back({points[k].x, points[k].y});
    }
    return places;
}

SurfacePoint placeOnEdge(const AirBearingSurface& surface, const SurfacePart& edge, SurfacePoint near, double raster)
{
    const std::vector<RailPoint>& points = surface.rails[edge.item].points;
    const RailPoint &a = points[edge.index], &b = points[(edge.index + 1) % points.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double share = squared > 0.0 ? ((near.x - a.x) * dx + (near.y - a.y) * dy) / squared : 0.5;
    const auto between = [&](double from, double to) {
        const double place = from + std::clamp(share, 0.0, 1.0) * (to - from);
        return from == to ? from : raster > 0.0 ? std::round(place / raster) * raster : place;
    };
    return {between(a.x, b.x), between(a.y, b.y)};
}

} // namespace touchdown
