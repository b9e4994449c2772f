// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "core/physics/slider/part_list.h"
#include "core/physics/slider/rail_outline.h"

namespace touchdown {

namespace {

constexpr double touching = 1e-12; // [m] closer than this, points and lines meet
constexpr double straight = 1e-6;  // sine of the angle below which a line runs straight on

using Problems = std::vector<SurfaceProblem>;
using Indices = std::vector<std::size_t>;

std::string text(std::size_t number) { return std::to_string(number); }

/// The indices below `count` for which `holds` is true.
Indices indicesWhere(std::size_t count, const std::function<bool(std::size_t)>& holds)
{
    Indices indices;
    for (std::size_t i = 0; i < count; ++i)
        if (holds(i)) indices.push_back(i);
    return indices;
}

/// Reports problems of a rail or a wall profile.
struct Part {
    std::string name; // "Rail 3"
    std::string key;  // "abs.rail[3]"
    Problems& problems;
    const std::vector<RailPoint>* corners = nullptr; // of a rail

    void add(const std::string& predicate, std::vector<SurfacePoint> places = {}) const
    {
        problems.push_back({key, name + predicate, std::move(places)});
    }
    /// Of corners or points, if there are any: "Rail 3: corner 4", then the verb for one or for several points, then
    /// the rest.
    void add(const Indices& points, const char* one, const char* several, const std::string& rest,
             const char* before = ": ") const
    {
        if (points.empty()) return;
        std::vector<SurfacePoint> places;
        for (const std::size_t i : points)
            if (corners != nullptr && std::isfinite((*corners)[i].x) && std::isfinite((*corners)[i].y))
                places.push_back({(*corners)[i].x, (*corners)[i].y});
        add(before + partList(corners != nullptr ? "corner" : "point", points) + (points.size() == 1 ? one : several) +
                rest,
            std::move(places));
    }
};

double distance(const RailPoint& a, const RailPoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The cross product of b - a and c - a [m^2].
double cross(const RailPoint& a, const RailPoint& b, const RailPoint& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

enum class Meeting { Apart, Touching, Crossing };

/// How the edges a-b and c-d meet.
Meeting meeting(const RailPoint& a, const RailPoint& b, const RailPoint& c, const RailPoint& d)
{
    const auto apart = [](double a0, double a1, double b0, double b1) {
        return std::max(a0, a1) + touching < std::min(b0, b1) || std::max(b0, b1) + touching < std::min(a0, a1);
    };
    if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return Meeting::Apart;
    const double ab = distance(a, b);
    const double cd = distance(c, d);
    const double offC = cross(a, b, c) / ab, offD = cross(a, b, d) / ab; // distances from the other's line
    const double offA = cross(c, d, a) / cd, offB = cross(c, d, b) / cd;
    const auto sameSide = [](double p, double q) {
        return (p > touching && q > touching) || (p < -touching && q < -touching);
    };
    const auto acrossClearly = [](double p, double q) {
        return (p > touching && q < -touching) || (p < -touching && q > touching);
    };
    if (sameSide(offC, offD) || sameSide(offA, offB)) return Meeting::Apart;
    return acrossClearly(offC, offD) && acrossClearly(offA, offB) ? Meeting::Crossing : Meeting::Touching;
}

/// Where the lines a-b and c-d meet; the middle of c-d where they are parallel.
SurfacePoint meetingPoint(const RailPoint& a, const RailPoint& b, const RailPoint& c, const RailPoint& d)
{
    const double offC = cross(a, b, c), offD = cross(a, b, d);
    const double share = offC != offD ? std::clamp(offC / (offC - offD), 0.0, 1.0) : 0.5;
    return {std::lerp(c.x, d.x, share), std::lerp(c.y, d.y, share)};
}

/// Where the first two edges of the outline, without repeated points, meet so; neighbours are left out.
std::optional<SurfacePoint> meetsItself(const std::vector<RailPoint>& points, Meeting how)
{
    const std::size_t count = points.size();
    for (std::size_t i = 0; i + 2 < count; ++i) {
        for (std::size_t j = i + 2; j < count - (i == 0 ? 1 : 0); ++j)
            if (meeting(points[i], points[i + 1], points[j], points[(j + 1) % count]) == how)
                return meetingPoint(points[i], points[i + 1], points[j], points[(j + 1) % count]);
    }
    return {};
}

bool finite(const Rail& rail, const Part& part)
{
    const auto points = indicesWhere(rail.points.size(), [&](std::size_t i) {
        return !std::isfinite(rail.points[i].x) || !std::isfinite(rail.points[i].y);
    });
    part.add(points, " has a coordinate that is no number.", " have coordinates that are no numbers.", "");
    const std::size_t count = rail.kind == RailKind::Step ? 1 : 3;
    const auto recesses = indicesWhere(count, [&](std::size_t i) { return !std::isfinite(rail.recess[i]); });
    if (!recesses.empty()) part.add(": the recess is no number.");
    return points.empty() && recesses.empty();
}

void checkRail(const Rail& rail, const Part& part, std::size_t walls)
{
    const auto missing = indicesWhere(rail.points.size(), [&](std::size_t i) {
        const int wall = rail.points[i].wall;
        return wall < 0 || static_cast<std::size_t>(wall) > walls;
    });
    part.add(missing, " names", " name",
             " a wall profile that does not exist; there " + (walls == 1 ? "is 1." : "are " + text(walls) + "."));
    const bool finiteRail = finite(rail, part);
    if (rail.points.size() < 3)
        return part.add(" has " + text(rail.points.size()) + (rail.points.size() == 1 ? " corner" : " corners") +
                        "; it needs three or more.");
    if (!finiteRail) return;

    const RailPoint& first = rail.points[0];
    const double area = std::abs(cross(first, rail.points[1], rail.points[2]));
    const double reach = std::max(distance(first, rail.points[1]), distance(first, rail.points[2]));
    if (rail.kind == RailKind::Ramp && area <= straight * reach * reach)
        part.add(": the first three corners lie on a line, so that no ramp goes through them.");
    const std::vector<RailPoint> points = withoutRepetitions(rail.points);
    double size = 0.0;
    for (const RailPoint& p : points) size = std::max(size, distance(points[0], p));
    if (const auto at = meetsItself(points, Meeting::Crossing))
        part.add(": the outline crosses itself.", {*at});
    else if (std::abs(signedArea(points)) <= 1e-12 * size * size)
        part.add(" has no area.", {{first.x, first.y}});
}

void checkWall(const WallProfile& wall, const Part& part)
{
    const std::size_t count = wall.distance.size();
    if (wall.recess.size() != count)
        return part.add(" has " + text(count) + " distances but " + text(wall.recess.size()) + " recesses.");
    if (count < 2)
        return part.add(" has " + text(count) + (count == 1 ? " point" : " points") + "; it needs two or more.");
    const auto bad = indicesWhere(
        count, [&](std::size_t i) { return !std::isfinite(wall.distance[i]) || !std::isfinite(wall.recess[i]); });
    part.add(bad, " has a value that is no number.", " have values that are no numbers.", "");
    const auto back =
        indicesWhere(count, [&](std::size_t i) { return i > 0 && wall.distance[i] < wall.distance[i - 1]; });
    part.add(back, " lies", " lie", " before the point ahead of it.", ": the distances must ascend; ");
}

void warnOfRail(const Rail& rail, const Part& part, double baseRecess, double length, double width)
{
    const std::size_t count = rail.points.size();
    const auto next = [&](std::size_t i) -> const RailPoint& { return rail.points[(i + 1) % count]; };
    const auto outside = indicesWhere(count, [&](std::size_t i) {
        const RailPoint& p = rail.points[i];
        return p.x < -touching || p.x > length + touching || p.y < -touching || p.y > width + touching;
    });
    part.add(outside, " lies", " lie", " outside the slider.");
    const auto repeated =
        indicesWhere(count, [&](std::size_t i) { return distance(rail.points[i], next(i)) <= touching; });
    part.add(repeated, " is", " are", " repeated by the corner after.");
    const std::vector<RailPoint> points = withoutRepetitions(rail.points);
    if (points.size() < 3) return;
    // The index in the list without repetitions would be of no use to the reader.
    const auto indexOf = [&](const RailPoint& p) {
        return static_cast<std::size_t>(std::find(rail.points.begin(), rail.points.end(), p) - rail.points.begin());
    };
    Indices collinear, reversing;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const RailPoint& before = points[(i + points.size() - 1) % points.size()];
        const RailPoint& after = points[(i + 1) % points.size()];
        const double lengths = distance(before, points[i]) * distance(points[i], after);
        if (std::abs(cross(before, points[i], after)) > straight * lengths) continue;
        const double along =
            (points[i].x - before.x) * (after.x - points[i].x) + (points[i].y - before.y) * (after.y - points[i].y);
        (along > 0.0 ? collinear : reversing).push_back(indexOf(points[i]));
    }
    part.add(collinear, " lies", " lie", " on the line between the corners before and after.");
    part.add(reversing, "", "", " the outline turns back on itself.", ": at ");
    if (const auto at = meetsItself(points, Meeting::Touching); at && reversing.empty())
        part.add(": the outline touches itself.", {*at});
    const bool hasWalls = std::any_of(points.begin(), points.end(), [](const RailPoint& p) { return p.wall > 0; });
    if (hasWalls && rail.kind == RailKind::Ramp)
        part.add(" is a ramp: its walls are not used.");
    else if (hasWalls && rail.recess[0] >= baseRecess)
        part.add(" does not rise above the base recess: its walls are not used.");
}

Part railPart(const AirBearingSurface& surface, std::size_t index, Problems& problems)
{
    return {"Rail " + text(index + 1), "abs.rail[" + text(index + 1) + "]", problems, &surface.rails[index].points};
}

} // namespace

std::vector<SurfaceProblem> surfaceProblems(const AirBearingSurface& surface)
{
    Problems problems;
    for (std::size_t i = 0; i < surface.rails.size(); ++i)
        checkRail(surface.rails[i], railPart(surface, i, problems), surface.walls.size());
    for (std::size_t i = 0; i < surface.walls.size(); ++i)
        checkWall(surface.walls[i], {"Wall profile " + text(i + 1), "abs.wall[" + text(i + 1) + "]", problems});
    const std::pair<std::string_view, double> numbers[] = {
        {"base recess", surface.baseRecess},
        {"crown", surface.crown},
        {"camber", surface.camber},
        {"twist", surface.twist},
        {"taper length", surface.taperLength},
        {"taper angle", surface.taperAngle},
    };
    for (const auto& [name, value] : numbers)
        if (!std::isfinite(value)) problems.push_back({"abs", "The " + std::string(name) + " is no number."});
    return problems;
}

std::vector<SurfaceProblem> surfaceWarnings(const AirBearingSurface& surface, double length, double width)
{
    Problems warnings;
    for (std::size_t i = 0; i < surface.rails.size(); ++i)
        warnOfRail(surface.rails[i], railPart(surface, i, warnings), surface.baseRecess, length, width);
    const auto outside = indicesWhere(surface.pointsOfInterest.size(), [&](std::size_t i) {
        const SurfacePoint& p = surface.pointsOfInterest[i];
        return !(p.x >= 0.0 && p.x <= length && p.y >= 0.0 && p.y <= width);
    });
    Part{"Points of interest", "abs", warnings}.add(outside, " lies", " lie", " outside the slider.");
    return warnings;
}

} // namespace touchdown
