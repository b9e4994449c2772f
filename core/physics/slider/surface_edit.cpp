// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_edit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/physics/slider/corner_numbers.h"

namespace touchdown {

namespace {

using Corners = std::set<std::pair<std::size_t, std::size_t>>; // rail and corner

std::size_t after(const Rail& rail, std::size_t corner) { return (corner + 1) % rail.points.size(); }
std::size_t before(const Rail& rail, std::size_t corner)
{
    return (corner + rail.points.size() - 1) % rail.points.size();
}

/// The corners that move with these parts.
Corners cornersOf(const AirBearingSurface& surface, const PartSelection& parts)
{
    Corners corners;
    for (const SurfacePart& part : parts) {
        if (!isOfRail(part) || !has(surface, part)) continue;
        const Rail& rail = surface.rails[part.item];
        if (part.kind == PartKind::Rail)
            for (std::size_t i = 0; i < rail.points.size(); ++i) corners.insert({part.item, i});
        else
            corners.insert({part.item, part.index});
        if (part.kind == PartKind::Edge) corners.insert({part.item, after(rail, part.index)});
    }
    return corners;
}

PartSelection only(const PartSelection& parts, PartKind kind)
{
    PartSelection some;
    std::ranges::copy_if(parts, std::inserter(some, some.end()),
                         [kind](const SurfacePart& part) { return part.kind == kind; });
    return some;
}

double turned(double y, double width) { return tidy(width - y); }

template <class Point>
void moveBy(Point& point, SurfaceShift by)
{
    if (by.x != 0.0) point.x = tidy(point.x + by.x);
    if (by.y != 0.0) point.y = tidy(point.y + by.y);
}

/// The plane of a ramp at a place [m]; a step's recess.
double topAt(const Rail& rail, double x, double y)
{
    if (rail.kind == RailKind::Step) return rail.recess[0];
    const RailPoint &a = rail.points[0], &b = rail.points[1], &c = rail.points[2];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0.0) return rail.recess[0];
    const double atB = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;
    const double atC = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;
    return rail.recess[0] + atB * (rail.recess[1] - rail.recess[0]) + atC * (rail.recess[2] - rail.recess[0]);
}

/// The plane of a ramp goes through its first three corners, which may be others now.
void keepPlane(const Rail& before, Rail& now)
{
    if (now.kind != RailKind::Ramp || now.points.size() < 3 || before.points.size() < 3) return;
    for (std::size_t k = 0; k < now.recess.size(); ++k)
        if (now.points[k].x != before.points[k].x || now.points[k].y != before.points[k].y)
            now.recess[k] = topAt(before, now.points[k].x, now.points[k].y);
}

/// Where a line through `from` along (dx, dy) meets the line through `at` whose normal is (nx, ny); nothing where they
/// are parallel.
std::optional<SurfacePoint> meeting(const RailPoint& from, double dx, double dy, SurfacePoint at, double nx, double ny)
{
    constexpr double parallel = 0.2; // sine of the angle, below which a corner would slide far
    const double slope = dx * nx + dy * ny;
    if (!(std::abs(slope) > parallel * std::hypot(dx, dy))) return {};
    const double along = ((at.x - from.x) * nx + (at.y - from.y) * ny) / slope;
    return SurfacePoint{from.x + along * dx, from.y + along * dy};
}

void shiftEdge(Rail& rail, std::size_t edge, SurfaceShift by)
{
    const std::size_t next = after(rail, edge);
    const RailPoint a = rail.points[edge], b = rail.points[next];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0.0)) return;
    const double nx = (b.y - a.y) / length, ny = (a.x - b.x) / length; // as edgeNormal
    const double distance = by.x * nx + by.y * ny;
    const SurfacePoint at{a.x + distance * nx, a.y + distance * ny}; // on the shifted edge
    const auto slide = [&](std::size_t corner, const RailPoint& neighbour) {
        RailPoint& moves = rail.points[corner];
        const auto met = meeting(moves, moves.x - neighbour.x, moves.y - neighbour.y, at, nx, ny);
        const SurfacePoint place = met ? *met : SurfacePoint{moves.x + distance * nx, moves.y + distance * ny};
        // An edge along x or y keeps that coordinate of its neighbour to the bit.
        if (moves.x != neighbour.x || nx != 0.0) moves.x = tidy(place.x);
        if (moves.y != neighbour.y || ny != 0.0) moves.y = tidy(place.y);
    };
    const RailPoint ahead = rail.points[before(rail, edge)], behind = rail.points[after(rail, next)];
    slide(edge, ahead);
    slide(next, behind);
}

} // namespace

double tidy(double place)
{
    constexpr double perMetre = 1e15;
    return std::abs(place) < 1.0 ? std::round(place * perMetre) / perMetre : place;
}

bool isOfRail(const SurfacePart& part) { return part.kind <= PartKind::Corner; }

bool has(const AirBearingSurface& surface, const SurfacePart& part)
{
    if (part.kind == PartKind::Interest) return part.item < surface.pointsOfInterest.size();
    if (part.kind == PartKind::Distance) return part.item < surface.distances.size();
    if (part.kind == PartKind::Symmetry) return part.item < surface.symmetries.size();
    if (part.item >= surface.rails.size()) return false;
    return part.kind == PartKind::Rail || part.index < surface.rails[part.item].points.size();
}

AirBearingSurface moved(AirBearingSurface surface, const PartSelection& parts, SurfaceShift by)
{
    if (parts.size() == 1 && parts.begin()->kind == PartKind::Edge && has(surface, *parts.begin())) {
        shiftEdge(surface.rails[parts.begin()->item], parts.begin()->index, by);
        return surface;
    }
    for (const auto& [rail, corner] : cornersOf(surface, parts)) moveBy(surface.rails[rail].points[corner], by);
    for (const SurfacePart& part : only(parts, PartKind::Interest))
        if (has(surface, part)) moveBy(surface.pointsOfInterest[part.item], by);
    return surface;
}

SurfaceShift edgeNormal(const AirBearingSurface& surface, const SurfacePart& edge)
{
    const Rail& rail = surface.rails.at(edge.item);
    const RailPoint &a = rail.points.at(edge.index), &b = rail.points[after(rail, edge.index)];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0.0)) return {};
    return {(b.y - a.y) / length, (a.x - b.x) / length};
}

AirBearingSurface withCorner(AirBearingSurface surface, std::size_t rail, std::size_t edge, SurfacePoint at)
{
    Rail& changed = surface.rails.at(rail);
    const Rail before = changed;
    const RailPoint corner{tidy(at.x), tidy(at.y), before.points.at(edge).wall};
    CornerNumbers numbers(surface);
    changed.points.insert(changed.points.begin() + static_cast<std::ptrdiff_t>(edge) + 1, corner);
    numbers.insert(rail, edge + 1);
    keepPlane(before, changed);
    numbers.apply(surface);
    return surface;
}

AirBearingSurface without(AirBearingSurface surface, const PartSelection& parts)
{
    Corners corners;
    std::set<std::size_t> rails;
    for (const SurfacePart& part : parts) {
        if (!isOfRail(part) || !has(surface, part)) continue;
        if (part.kind == PartKind::Rail)
            rails.insert(part.item);
        else
            corners.insert(
                {part.item, part.kind == PartKind::Edge ? after(surface.rails[part.item], part.index) : part.index});
    }
    const auto removeItems = [&](PartKind kind, auto& items) {
        const PartSelection some = only(parts, kind);
        for (auto part = some.rbegin(); part != some.rend(); ++part)
            if (part->item < items.size()) items.erase(items.begin() + static_cast<std::ptrdiff_t>(part->item));
    };
    removeItems(PartKind::Interest, surface.pointsOfInterest);
    removeItems(PartKind::Distance, surface.distances);
    removeItems(PartKind::Symmetry, surface.symmetries);
    // From the last to the first, so that the numbers of the others hold.
    CornerNumbers numbers(surface);
    for (auto each = corners.rbegin(); each != corners.rend(); ++each) {
        Rail& rail = surface.rails[each->first];
        const Rail before = rail;
        rail.points.erase(rail.points.begin() + static_cast<std::ptrdiff_t>(each->second));
        numbers.erase(each->first, each->second);
        keepPlane(before, rail);
        if (rail.points.size() < 3) rails.insert(each->first);
    }
    for (auto rail = rails.rbegin(); rail != rails.rend(); ++rail) {
        surface.rails.erase(surface.rails.begin() + static_cast<std::ptrdiff_t>(*rail));
        numbers.eraseRail(*rail);
    }
    numbers.apply(surface);
    return surface;
}

AirBearingSurface withCopies(AirBearingSurface surface, const PartSelection& parts, SurfaceShift by)
{
    const std::size_t count = surface.rails.size();
    PartSelection copies;
    for (const SurfacePart& part : only(parts, PartKind::Rail)) {
        if (part.item >= count) continue;
        copies.insert({PartKind::Rail, surface.rails.size()});
        surface.rails.push_back(Rail(surface.rails[part.item]));
    }
    return moved(std::move(surface), copies, by);
}

AirBearingSurface mirrored(AirBearingSurface surface, const PartSelection& parts, double width)
{
    for (const SurfacePart& part : parts) {
        if (!has(surface, part)) continue;
        if (part.kind == PartKind::Rail)
            for (RailPoint& point : surface.rails[part.item].points) point.y = turned(point.y, width);
        if (part.kind == PartKind::Interest)
            surface.pointsOfInterest[part.item].y = turned(surface.pointsOfInterest[part.item].y, width);
    }
    return surface;
}

AirBearingSurface reordered(AirBearingSurface surface, std::size_t rail, std::size_t place)
{
    CornerNumbers numbers(surface);
    const auto move = [rail, place](auto& rails) {
        const auto at = [&](std::size_t i) { return rails.begin() + static_cast<std::ptrdiff_t>(i); };
        if (rail < place)
            std::rotate(at(rail), at(rail) + 1, at(place) + 1);
        else
            std::rotate(at(place), at(rail), at(rail) + 1);
    };
    move(surface.rails);
    move(numbers.rails());
    numbers.apply(surface);
    return surface;
}

AirBearingSurface withoutWall(AirBearingSurface surface, std::size_t wall)
{
    surface.walls.erase(surface.walls.begin() + static_cast<std::ptrdiff_t>(wall));
    const int number = static_cast<int>(wall) + 1;
    for (Rail& rail : surface.rails)
        for (RailPoint& point : rail.points) {
            if (point.wall == number) point.wall = 0;
            if (point.wall > number) --point.wall;
        }
    return surface;
}

AirBearingSurface withoutUnusedWalls(AirBearingSurface surface)
{
    std::set<int> used;
    for (const Rail& rail : surface.rails)
        for (const RailPoint& point : rail.points) used.insert(point.wall);
    for (std::size_t wall = surface.walls.size(); wall-- > 0;)
        if (!used.contains(static_cast<int>(wall) + 1)) surface = withoutWall(std::move(surface), wall);
    return surface;
}

AirBearingSurface withEdgeWall(AirBearingSurface surface, const PartSelection& parts, int wall)
{
    for (const SurfacePart& part : parts) {
        if (!has(surface, part)) continue;
        if (part.kind == PartKind::Edge) surface.rails[part.item].points[part.index].wall = wall;
        if (part.kind == PartKind::Rail)
            for (RailPoint& point : surface.rails[part.item].points) point.wall = wall;
    }
    return surface;
}

std::vector<std::optional<MirrorImage>> mirrorImages(const AirBearingSurface& surface, double width, double reach)
{
    const auto imageIn = [&](const Rail& rail, const Rail& other) -> std::optional<std::vector<std::size_t>> {
        if (rail.kind != other.kind || rail.points.size() != other.points.size()) return {};
        std::vector<std::size_t> corners;
        for (const RailPoint& point : rail.points) {
            const auto meets = [&](const RailPoint& p) {
                return std::abs(p.x - point.x) <= reach && std::abs(turned(p.y, width) - point.y) <= reach;
            };
            const auto found = std::ranges::find_if(other.points, meets);
            if (found == other.points.end()) return {};
            constexpr double sameHeight = 1e-13; // [m]
            if (std::abs(topAt(other, found->x, found->y) - topAt(rail, point.x, point.y)) > sameHeight) return {};
            corners.push_back(static_cast<std::size_t>(found - other.points.begin()));
        }
        // Each corner is the image of one, in the same or the opposite order around the rail.
        std::vector<std::size_t> sorted = corners;
        std::ranges::sort(sorted);
        if (std::ranges::adjacent_find(sorted) != sorted.end()) return {};
        return corners;
    };
    std::vector<std::optional<MirrorImage>> images(surface.rails.size());
    for (std::size_t i = 0; i < surface.rails.size(); ++i)
        for (std::size_t k = 0; k < surface.rails.size() && !images[i]; ++k)
            if (auto corners = imageIn(surface.rails[i], surface.rails[k]))
                images[i].emplace(MirrorImage{k, std::move(*corners)});
    // Of several alike the first two are a pair.
    for (std::size_t i = 0; i < images.size(); ++i)
        if (images[i] && (!images[images[i]->rail] || images[images[i]->rail]->rail != i)) images[i].reset();
    return images;
}

AirBearingSurface movedInPairs(const AirBearingSurface& surface, const PartSelection& parts, SurfaceShift by,
                               double width, double reach, const std::set<std::size_t>& single)
{
    AirBearingSurface result = moved(surface, parts, by);
    const AirBearingSurface alone = result;
    const auto shiftOf = [&](std::size_t rail, std::size_t corner) {
        const RailPoint &from = surface.rails[rail].points[corner], &to = alone.rails[rail].points[corner];
        return SurfaceShift{to.x - from.x, to.y - from.y};
    };
    const auto still = [](SurfaceShift shift) { return shift.x == 0.0 && shift.y == 0.0; };
    const auto images = mirrorImages(surface, width, reach);
    for (std::size_t i = 0; i < surface.rails.size(); ++i) {
        if (!images[i] || single.contains(i) || single.contains(images[i]->rail)) continue;
        for (std::size_t k = 0; k < surface.rails[i].points.size(); ++k) {
            const std::size_t rail = images[i]->rail, corner = images[i]->corner[k];
            const SurfaceShift own = shiftOf(i, k), image = shiftOf(rail, corner);
            if (still(image)) continue;
            const RailPoint& from = surface.rails[i].points[k];
            RailPoint& to = result.rails[i].points[k];
            if (rail == i && corner == k) // on the centre line
                to.y = from.y;
            else {
                to = from;
                moveBy(to, still(own) ? SurfaceShift{image.x, -image.y}
                                      : SurfaceShift{0.5 * (own.x + image.x), 0.5 * (own.y - image.y)});
            }
        }
    }
    return result;
}

SnappedPlace snapped(const AirBearingSurface& surface, const PartSelection& moving, SurfacePoint at,
                     const SnapGrid& grid)
{
    SnappedPlace place{at};
    double nearX = grid.reach, nearY = grid.reach;
    const auto take = [&](double candidate, double wanted, double& near, double& coordinate, SnapTarget& held,
                          SnapTarget what) {
        const double distance = std::abs(candidate - wanted);
        if (distance > near || (distance == near && held != SnapTarget::None)) return false;
        near = distance;
        coordinate = candidate;
        held = what;
        return true;
    };
    const auto takeX = [&](double x, SnapTarget what) { return take(x, at.x, nearX, place.at.x, place.x, what); };
    const auto takeY = [&](double y, SnapTarget what) { return take(y, at.y, nearY, place.at.y, place.y, what); };
    // Of places alike the first holds.
    takeY(0.5 * grid.width, SnapTarget::Centre);
    for (const double x : {0.0, grid.length}) takeX(x, SnapTarget::Border);
    for (const double y : {0.0, grid.width}) takeY(y, SnapTarget::Border);
    const Corners own = cornersOf(surface, moving);
    for (std::size_t i = 0; i < surface.rails.size(); ++i)
        for (std::size_t k = 0; k < surface.rails[i].points.size(); ++k) {
            if (own.contains({i, k})) continue;
            const SurfacePart corner{PartKind::Corner, i, k};
            if (takeX(surface.rails[i].points[k].x, SnapTarget::Corner)) place.xCorner = corner;
            if (takeY(surface.rails[i].points[k].y, SnapTarget::Corner)) place.yCorner = corner;
        }
    // A corner with both coordinates is reported before two corners with one each.
    if (place.x == SnapTarget::Corner && place.y == SnapTarget::Corner)
        for (std::size_t i = 0; i < surface.rails.size(); ++i)
            for (std::size_t k = 0; k < surface.rails[i].points.size(); ++k) {
                const RailPoint& corner = surface.rails[i].points[k];
                if (!own.contains({i, k}) && corner.x == place.at.x && corner.y == place.at.y)
                    place.xCorner = place.yCorner = {PartKind::Corner, i, k};
            }
    const auto onRaster = [&](double value) { return tidy(std::round(value / grid.raster) * grid.raster); };
    if (grid.raster > 0.0 && place.x == SnapTarget::None) place.at.x = onRaster(at.x), place.x = SnapTarget::Raster;
    if (grid.raster > 0.0 && place.y == SnapTarget::None) place.at.y = onRaster(at.y), place.y = SnapTarget::Raster;
    return place;
}

} // namespace touchdown
