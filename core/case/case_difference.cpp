// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_difference.h"

#include "core/case/parameters.h"
#include "core/formats/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace touchdown {

namespace {

/// A part of the surface in which changes are found: its key and its label.
struct ChangePlace {
    std::string key;   // "abs.rail[2]"
    std::string label; // "rail 2"
};

class SurfaceDifference {
public:
    explicit SurfaceDifference(std::vector<CaseChange>& changes) : changes_(changes) {}

    void compare(const AirBearingSurface& before, const AirBearingSurface& after)
    {
        compareLists(before.rails, after.rails, "abs.rail", "rail");
        compareLists(before.walls, after.walls, "abs.wall", "wall");
        compareLists(before.pointsOfInterest, after.pointsOfInterest, "abs.points_of_interest", "point of interest");
    }

private:
    /// Equal items at the front and at the back are passed over; the items between them are compared in order.
    template <typename Item>
    void compareLists(const std::vector<Item>& before, const std::vector<Item>& after, const std::string& key,
                      const std::string& label)
    {
        const auto front = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
        std::size_t back = 0;
        while (back < std::min(before.size(), after.size()) - front &&
               before[before.size() - 1 - back] == after[after.size() - 1 - back])
            ++back;
        const std::size_t oldEnd = before.size() - back;
        const std::size_t newEnd = after.size() - back;
        const auto place = [&](std::size_t i) {
            const std::string number = std::to_string(i + 1);
            return ChangePlace{key + '[' + number + ']', label + ' ' + number};
        };
        const auto at = [](const std::vector<Item>& list, std::size_t i) {
            return list.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (oldEnd == newEnd && oldEnd > front &&
            std::is_permutation(at(before, front), at(before, oldEnd), at(after, front))) {
            changes_.push_back(
                {CaseChangeKind::Order,
                 key,
                 "order of " + label + "s " + std::to_string(front + 1) + " to " + std::to_string(newEnd),
                 {},
                 {}});
            return;
        }
        const std::size_t both = std::min(oldEnd, newEnd);
        for (std::size_t i = front; i < both; ++i) compareItems(before[i], after[i], place(i));
        for (std::size_t i = both; i < oldEnd; ++i) addItem(CaseChangeKind::Removed, place(i));
        for (std::size_t i = both; i < newEnd; ++i) addItem(CaseChangeKind::Added, place(i));
    }

    void compareItems(const Rail& before, const Rail& after, const ChangePlace& rail)
    {
        const auto kindName = [](const Rail& each) { return each.kind == RailKind::Step ? "step" : "ramp"; };
        if (before.kind != after.kind)
            add(rail.key + ".recess", rail.label + ": kind", kindName(before), kindName(after));
        // A step has one recess.
        const std::size_t count = before.kind == RailKind::Step && after.kind == RailKind::Step ? 1 : 3;
        for (std::size_t i = 0; i < count; ++i)
            compareLengths(before.recess[i], after.recess[i], "um", rail.key + ".recess",
                           rail.label + ": recess" + (count == 1 ? "" : " at point " + std::to_string(i + 1)));
        compareLists(before.points, after.points, rail.key + ".points", rail.label + ", point");
    }

    void compareItems(const RailPoint& before, const RailPoint& after, const ChangePlace& point)
    {
        compareItems(SurfacePoint{before.x, before.y}, SurfacePoint{after.x, after.y}, point);
        const auto wallName = [](int wall) { return wall == 0 ? std::string("none") : std::to_string(wall); };
        if (before.wall != after.wall)
            add(point.key + ".wall", point.label + ": wall", wallName(before.wall), wallName(after.wall));
    }

    void compareItems(const SurfacePoint& before, const SurfacePoint& after, const ChangePlace& point)
    {
        compareLengths(before.x, after.x, "mm", point.key + ".x", point.label + ": x");
        compareLengths(before.y, after.y, "mm", point.key + ".y", point.label + ": y");
    }

    struct WallPoint {
        double distance = 0.0; // [m]
        double recess = 0.0;   // [m]
        bool operator==(const WallPoint&) const = default;
    };

    void compareItems(const WallProfile& before, const WallProfile& after, const ChangePlace& wall)
    {
        const auto points = [](const WallProfile& profile) {
            std::vector<WallPoint> result;
            for (std::size_t i = 0; i < std::min(profile.distance.size(), profile.recess.size()); ++i)
                result.push_back({profile.distance[i], profile.recess[i]});
            return result;
        };
        compareLists(points(before), points(after), wall.key + ".points", wall.label + ", point");
    }

    void compareItems(const WallPoint& before, const WallPoint& after, const ChangePlace& point)
    {
        compareLengths(before.distance, after.distance, "um", point.key + ".distance", point.label + ": distance");
        compareLengths(before.recess, after.recess, "um", point.key + ".recess", point.label + ": recess");
    }

    /// With as many digits as show a difference, at least four.
    void compareLengths(double before, double after, const char* unit, const std::string& key, const std::string& label)
    {
        if (before == after) return;
        for (int digits = 4; digits <= 17; ++digits) {
            const std::string then = formatQuantity(roundedTo(before, digits), unit);
            const std::string now = formatQuantity(roundedTo(after, digits), unit);
            if (then == now && digits < 17) continue;
            add(key, label, then, now);
            return;
        }
    }

    void add(const std::string& key, const std::string& label, const std::string& before, const std::string& after)
    {
        changes_.push_back({CaseChangeKind::Value, key, label, before, after});
    }

    void addItem(CaseChangeKind kind, const ChangePlace& place)
    {
        changes_.push_back({kind, place.key, place.label, {}, {}});
    }

    std::vector<CaseChange>& changes_;
};

constexpr double sameLength = 1e-12; // [m]

bool same(double a, double b) { return std::abs(a - b) < sameLength; }

/// One item for each shift; the rail is left open.
std::vector<MovedPoints> shifts(const std::vector<RailPoint>& then, const std::vector<RailPoint>& now)
{
    std::vector<MovedPoints> all;
    for (std::size_t k = 0; k < now.size(); ++k) {
        const auto shift = [](double from, double to) { return same(from, to) ? 0.0 : to - from; };
        const double x = shift(then[k].x, now[k].x), y = shift(then[k].y, now[k].y);
        if (x == 0.0 && y == 0.0) continue;
        const auto together =
            std::ranges::find_if(all, [x, y](const MovedPoints& each) { return same(each.x, x) && same(each.y, y); });
        if (together == all.end())
            all.push_back({0, {k}, MovedPoints::How::Points, x, y});
        else
            together->points.push_back(k);
    }
    if (all.size() == 1 && all.front().points.size() == now.size()) all.front().how = MovedPoints::How::Rail;
    return all;
}

bool isMirrored(const std::vector<RailPoint>& then, const std::vector<RailPoint>& now)
{
    for (std::size_t k = 0; k < now.size(); ++k)
        if (!same(now[k].x, then[k].x) || !same(now[k].y + then[k].y, now[0].y + then[0].y)) return false;
    return true;
}

/// The edge whose two ends are all that moved, by different shifts, with the edge parallel to itself.
std::optional<MovedPoints> movedEdge(const std::vector<MovedPoints>& moved, const std::vector<RailPoint>& then,
                                     const std::vector<RailPoint>& now)
{
    if (moved.size() != 2 || moved[0].points.size() != 1 || moved[1].points.size() != 1) return {};
    std::size_t first = moved[0].points[0], second = moved[1].points[0];
    if ((second + 1) % now.size() == first) std::swap(first, second);
    if ((first + 1) % now.size() != second) return {};
    const double x = then[second].x - then[first].x, y = then[second].y - then[first].y, length = std::hypot(x, y);
    const auto ahead = [&](std::size_t point) { // of the old edge's line [m]
        return ((now[point].y - then[first].y) * x - (now[point].x - then[first].x) * y) / length;
    };
    if (!(length > 0.0) || !same(ahead(first), ahead(second))) return {};
    return MovedPoints{
        0, {first, second}, MovedPoints::How::Edge, -ahead(first) * y / length, ahead(first) * x / length};
}

} // namespace

std::vector<CaseChange> caseChanges(const Case& before, const Case& after)
{
    std::vector<CaseChange> changes;
    for (const Parameter& parameter : parameters()) {
        if (parameter.key == "title" || parameter.group() == "about") continue;
        if (parameter.get(before) == parameter.get(after)) continue;
        if (!parameter.used(before) && !parameter.used(after)) continue;
        changes.push_back({CaseChangeKind::Value, parameter.key, parameter.label, toText(before, parameter),
                           toText(after, parameter)});
    }
    if (usesSliderSurface(before) || usesSliderSurface(after))
        SurfaceDifference(changes).compare(before.surface, after.surface);
    return changes;
}

std::vector<MovedPoints> movedPoints(const AirBearingSurface& before, const AirBearingSurface& after)
{
    std::vector<MovedPoints> all;
    if (before.rails.size() != after.rails.size()) return all;
    for (std::size_t i = 0; i < after.rails.size(); ++i) {
        const std::vector<RailPoint>&then = before.rails[i].points, &now = after.rails[i].points;
        if (then.size() != now.size()) continue;
        std::vector<MovedPoints> ofRail = shifts(then, now);
        if (!ofRail.empty() && isMirrored(then, now))
            ofRail = {{i, ofRail.front().points, MovedPoints::How::Mirrored}};
        else if (const auto edge = movedEdge(ofRail, then, now))
            ofRail = {*edge};
        for (MovedPoints& each : ofRail) {
            each.rail = i;
            all.push_back(each);
        }
    }
    return all;
}

} // namespace touchdown
