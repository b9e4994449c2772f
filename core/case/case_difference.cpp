// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_difference.h"

#include "core/case/case_key.h"
#include "core/formats/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace touchdown {

namespace {

/// An item of a list: "abs.rail[2].point[4]", "rail 2, corner 4".
struct ChangePlace {
    std::string owner; // "abs.rail[2]."
    std::string list;  // "point"
    std::size_t number = 0;
    std::string label; // "rail 2, corner 4"

    /// The same item of another list: "abs.rail[2].wall[4]".
    std::string keyOf(const std::string& otherList) const
    {
        return owner + otherList + '[' + std::to_string(number) + ']';
    }
    std::string key() const { return keyOf(list); }
};

class SurfaceDifference {
public:
    SurfaceDifference(const Case& before, const Case& after, std::vector<CaseChange>& changes)
        : before_(before), after_(after), changes_(changes)
    {
        compareLists(before.surface.rails, after.surface.rails, {"abs.", "rail", 0, "rail"});
        compareLists(before.surface.walls, after.surface.walls, {"abs.", "wall", 0, "wall"});
        compareLists(before.surface.pointsOfInterest, after.surface.pointsOfInterest,
                     {"abs.", "points_of_interest", 0, "point of interest"});
        compareLists(before.surface.distances, after.surface.distances, {"abs.", "distance", 0, "kept distance"});
        compareLists(before.surface.symmetries, after.surface.symmetries, {"abs.", "symmetric", 0, "kept symmetry"});
    }

private:
    /// Equal items at the front and at the back are passed over; the items between them are compared in order.
    template <typename Item>
    void compareLists(const std::vector<Item>& before, const std::vector<Item>& after, const ChangePlace& list)
    {
        const auto front = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
        std::size_t back = 0;
        while (back < std::min(before.size(), after.size()) - front &&
               before[before.size() - 1 - back] == after[after.size() - 1 - back])
            ++back;
        const std::size_t oldEnd = before.size() - back;
        const std::size_t newEnd = after.size() - back;
        const auto place = [&](std::size_t i) {
            return ChangePlace{list.owner, list.list, i + 1, list.label + ' ' + std::to_string(i + 1)};
        };
        const auto at = [](const std::vector<Item>& items, std::size_t i) {
            return items.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (oldEnd == newEnd && oldEnd > front &&
            std::is_permutation(at(before, front), at(before, oldEnd), at(after, front))) {
            changes_.push_back(
                {CaseChangeKind::Order,
                 list.owner + list.list,
                 "order of " + list.label + "s " + std::to_string(front + 1) + " to " + std::to_string(newEnd),
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
            changes_.push_back({CaseChangeKind::Kind, rail.key(), rail.label, kindName(before), kindName(after)});
        else if (after.kind == RailKind::Step)
            compareValue(rail.key() + ".recess", rail.label + ": recess");
        else
            for (std::size_t i = 1; i <= after.recess.size(); ++i)
                compareValue(rail.key() + ".recess[" + std::to_string(i) + ']',
                             rail.label + ": recess at corner " + std::to_string(i));
        compareLists(before.points, after.points, {rail.key() + '.', "point", 0, rail.label + ", corner"});
    }

    void compareItems(const RailPoint&, const RailPoint&, const ChangePlace& point)
    {
        compareItems(SurfacePoint{}, SurfacePoint{}, point);
        compareValue(point.keyOf("wall"), point.label + ": wall");
    }

    void compareItems(const SurfacePoint&, const SurfacePoint&, const ChangePlace& point)
    {
        compareValue(point.key() + ".x", point.label + ": x");
        compareValue(point.key() + ".y", point.label + ": y");
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
        compareLists(points(before), points(after), {wall.key() + '.', "point", 0, wall.label + ", point"});
    }

    void compareItems(const WallPoint&, const WallPoint&, const ChangePlace& point)
    {
        compareValue(point.keyOf("distance"), point.label + ": distance");
        compareValue(point.keyOf("recess"), point.label + ": recess");
    }

    /// Of its own kind: to set the value would move a rail, and the places of rails are listed.
    void compareItems(const KeptDistance& before, const KeptDistance& after, const ChangePlace& distance)
    {
        if (before.value != after.value)
            changes_.push_back({CaseChangeKind::Kind, distance.key(), distance.label,
                                formatQuantity(before.value, "um"), formatQuantity(after.value, "um")});
    }
    void compareItems(const KeptSymmetry&, const KeptSymmetry&, const ChangePlace&) {} // its rails have other numbers

    void compareValue(const std::string& key, const std::string& label)
    {
        const auto found = caseKey(after_, key);
        assert(std::holds_alternative<Parameter>(found));
        const Parameter& parameter = std::get<Parameter>(found);
        if (parameter.get(before_) != parameter.get(after_))
            changes_.push_back(
                {CaseChangeKind::Value, key, label, toText(before_, parameter), toText(after_, parameter)});
    }

    void addItem(CaseChangeKind kind, const ChangePlace& place)
    {
        changes_.push_back({kind, place.key(), place.label, {}, {}});
    }

    const Case &before_, &after_;
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
    if (usesSliderSurface(before) || usesSliderSurface(after)) SurfaceDifference(before, after, changes);
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
