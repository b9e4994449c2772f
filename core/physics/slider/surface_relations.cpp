// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_relations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>

#include "core/physics/slider/tied_numbers.h"

namespace touchdown {

namespace {

constexpr double holds = 1e-14; // within which a relation is obeyed [m]

using Axis = double RailPoint::*;

/// For each corner of a rail the corner of its image: in the same or in the opposite order around, as both shapes fit
/// best. Of a rail that is its own image the order is opposite. A shift of a rail does not change what fits best.
std::vector<std::size_t> mirrorOrder(const Rail& rail, const Rail& image, bool itself)
{
    const std::size_t count = rail.points.size();
    RailPoint a, b; // sums
    for (std::size_t k = 0; k < count; ++k) {
        a.x += rail.points[k].x / static_cast<double>(count), a.y += rail.points[k].y / static_cast<double>(count);
        b.x += image.points[k].x / static_cast<double>(count), b.y += image.points[k].y / static_cast<double>(count);
    }
    std::vector<std::size_t> best, order(count);
    double least = std::numeric_limits<double>::infinity();
    constexpr double exact = 1e-26; // [m²]
    for (int opposite = itself ? 1 : 0; opposite < 2; ++opposite)
        for (std::size_t first = 0; first < count && least > exact; ++first) {
            double misfit = 0.0;
            for (std::size_t k = 0; k < count && misfit < least; ++k) {
                order[k] = (opposite == 1 ? first + count - k : first + k) % count;
                const RailPoint &p = rail.points[k], &q = image.points[order[k]];
                const double x = (p.x - a.x) - (q.x - b.x), y = (p.y - a.y) + (q.y - b.y);
                misfit += x * x + y * y;
            }
            if (misfit < least) least = misfit, best = order;
        }
    return best;
}

/// The corners of a place: of an edge two.
std::vector<std::size_t> cornersAt(const AirBearingSurface& surface, const RailPlace& place)
{
    if (!place.edge) return {place.corner};
    return {place.corner, (place.corner + 1) % surface.rails[place.rail].points.size()};
}

struct RelationMisfit {
    SurfacePart relation;
    double contradicts = 0.0; // relations before it, by [m]
    double drawn = 0.0;       // by how much the shape does not obey it [m]
};

/// The relations of the rails `bound`, as equations along one axis. The numbers are a shift of each rail and the places
/// of all corners.
class AxisRelations {
public:
    /// Mirror images are found in `before`.
    AxisRelations(const AirBearingSurface& drawn, Axis axis, double width, const std::vector<bool>& bound,
                  const AirBearingSurface& before)
        : drawn_(drawn), axis_(axis), bound_(bound), numbers_(numberCorners())
    {
        for (std::size_t i = 0; i < drawn.symmetries.size(); ++i) tieSymmetry(i, width, before);
        // Edges before distances, so that both corners of an edge get the same bits.
        std::vector<double> slants(drawn.distances.size());
        for (std::size_t i = 0; i < drawn.distances.size(); ++i)
            if (binds(drawn.distances[i])) slants[i] = tieEdges(drawn.distances[i]);
        for (std::size_t i = 0; i < drawn.distances.size(); ++i)
            if (binds(drawn.distances[i])) tieDistance(i, slants[i]);
    }

    const std::vector<RelationMisfit>& misfits() const { return misfits_; }

    /// The places that the wishes lead to.
    void solve(const PartSelection& kept, AirBearingSurface& result)
    {
        const auto isKept = [&](std::size_t rail, std::size_t corner) {
            return kept.contains({PartKind::Rail, rail}) || kept.contains({PartKind::Corner, rail, corner});
        };
        std::vector<bool> holdsKept(drawn_.rails.size());
        const auto forCorners = [&](auto perform) {
            for (std::size_t i = 0; i < drawn_.rails.size(); ++i)
                for (std::size_t k = 0; bound_[i] && k < drawn_.rails[i].points.size(); ++k) perform(i, k);
        };
        const auto withShift = [&](std::size_t i, std::size_t k) { numbers_.tie(number(i, k), 1.0, i, place(i, k)); };
        forCorners([&](std::size_t i, std::size_t k) {
            if (!isKept(i, k)) return;
            holdsKept[i] = true;
            withShift(i, k);
        });
        for (std::size_t i = 0; i < holdsKept.size(); ++i)
            if (holdsKept[i]) numbers_.fix(i, 0.0);
        forCorners([&](std::size_t i, std::size_t k) {
            if (!holdsKept[i]) withShift(i, k);
        });
        forCorners([&](std::size_t i, std::size_t k) {
            if (holdsKept[i] && !isKept(i, k)) numbers_.fix(number(i, k), place(i, k));
        });
        for (std::size_t i = 0; i < holdsKept.size(); ++i)
            if (bound_[i]) numbers_.fix(i, 0.0);
        forCorners([&](std::size_t i, std::size_t k) {
            const double value = numbers_.value(number(i, k)).value_or(place(i, k));
            if (std::abs(value - place(i, k)) > TiedNumbers::reach) result.rails[i].points[k].*axis_ = tidy(value);
        });
    }

private:
    std::size_t numberCorners()
    {
        std::size_t next = drawn_.rails.size();
        for (const Rail& rail : drawn_.rails) {
            first_.push_back(next);
            next += rail.points.size();
        }
        return next;
    }
    std::size_t number(std::size_t rail, std::size_t corner) const { return first_[rail] + corner; }
    double place(std::size_t rail, std::size_t corner) const { return drawn_.rails[rail].points[corner].*axis_; }
    bool alongX() const { return axis_ == &RailPoint::x; }
    bool binds(const KeptDistance& distance) const
    {
        return distance.alongX == alongX() && exists(drawn_, distance) && bound_[distance.from.rail];
    }

    void tieSymmetry(std::size_t index, double width, const AirBearingSurface& before)
    {
        const auto [rail, image] = drawn_.symmetries[index];
        if (!exists(drawn_, drawn_.symmetries[index]) || !bound_[rail]) return;
        const std::vector<std::size_t> order = mirrorOrder(before.rails[rail], before.rails[image], rail == image);
        const double sign = alongX() ? 1.0 : -1.0, offset = alongX() ? 0.0 : width;
        RelationMisfit misfit{{PartKind::Symmetry, index}};
        for (std::size_t k = 0; k < order.size(); ++k) {
            larger(misfit.contradicts, numbers_.tie(number(image, order[k]), sign, number(rail, k), offset));
            larger(misfit.drawn, sign * place(rail, k) + offset - place(image, order[k]));
        }
        add(misfit);
    }

    double tieEdges(const KeptDistance& distance)
    {
        double slant = 0.0;
        for (const RailPlace& end : {distance.from, distance.to})
            larger(slant, numbers_.tie(number(end.rail, cornersAt(drawn_, end).back()), 1.0,
                                       number(end.rail, end.corner), 0.0));
        return slant;
    }

    void tieDistance(std::size_t index, double slant)
    {
        const auto& [from, to, along, value] = drawn_.distances[index];
        RelationMisfit misfit{{PartKind::Distance, index}, slant};
        larger(misfit.contradicts,
               numbers_.tie(number(to.rail, to.corner), 1.0, number(from.rail, from.corner), value));
        for (const std::size_t a : cornersAt(drawn_, from))
            for (const std::size_t b : cornersAt(drawn_, to))
                larger(misfit.drawn, place(to.rail, b) - place(from.rail, a) - value);
        add(misfit);
    }

    static void larger(double& most, double other)
    {
        if (std::abs(other) > std::abs(most)) most = other;
    }
    void add(RelationMisfit misfit)
    {
        for (double* each : {&misfit.contradicts, &misfit.drawn})
            if (std::abs(*each) <= holds) *each = 0.0;
        if (misfit.contradicts != 0.0 || misfit.drawn != 0.0) misfits_.push_back(misfit);
    }

    const AirBearingSurface& drawn_;
    Axis axis_;
    const std::vector<bool>& bound_;
    std::vector<std::size_t> first_; // number of the first corner of each rail
    TiedNumbers numbers_;
    std::vector<RelationMisfit> misfits_;
};

/// The rails that relations connect to rails of these parts, with them.
std::vector<bool> connected(const AirBearingSurface& surface, const PartSelection& parts)
{
    std::vector<bool> rails(surface.rails.size());
    for (const SurfacePart& part : parts)
        if (isOfRail(part) && has(surface, part)) rails[part.item] = true;
    bool more = true;
    const auto join = [&](std::size_t a, std::size_t b) {
        if (rails[a] == rails[b]) return;
        rails[a] = rails[b] = more = true;
    };
    while (more) {
        more = false;
        for (const KeptDistance& each : surface.distances)
            if (exists(surface, each)) join(each.from.rail, each.to.rail);
        for (const KeptSymmetry& each : surface.symmetries)
            if (exists(surface, each)) join(each.rail, each.image);
    }
    return rails;
}

bool exists(const AirBearingSurface& surface, const RailPlace& place)
{
    return has(surface, {PartKind::Corner, place.rail, place.corner});
}

std::string nanometres(double length)
{
    std::string text(24, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.6g nm", std::abs(length) * 1e9)));
    return text;
}

SurfaceProblem problemOf(const AirBearingSurface& surface, const RelationMisfit& misfit)
{
    const bool distance = misfit.relation.kind == PartKind::Distance;
    const std::string number = std::to_string(misfit.relation.item + 1);
    SurfaceProblem problem{distance ? "abs.distance[" + number + ']' : "abs.symmetric[" + number + ']',
                           (distance ? "Kept distance " : "Kept symmetry ") + number};
    if (misfit.contradicts != 0.0)
        problem.sentence += " contradicts the relations before it by " + nanometres(misfit.contradicts) +
                            ": edits leave the rails of both as drawn.";
    else
        problem.sentence += " is off by " + nanometres(misfit.drawn) + '.';
    if (distance) {
        const KeptDistance& kept = surface.distances[misfit.relation.item];
        problem.places = {middleOf(surface, kept.from), middleOf(surface, kept.to)};
    } else {
        const RailPoint& corner = surface.rails[surface.symmetries[misfit.relation.item].image].points.front();
        problem.places = {{corner.x, corner.y}};
    }
    return problem;
}

/// What a part offers as an end of a distance: upright edges of a rail, else its corners.
std::vector<RailPlace> endsOf(const AirBearingSurface& surface, const SurfacePart& part, Axis axis)
{
    if (part.kind == PartKind::Corner) return {{part.item, part.index, false}};
    const std::vector<RailPoint>& points = surface.rails[part.item].points;
    std::vector<RailPlace> edges, corners;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (part.kind == PartKind::Edge && k != part.index) continue;
        corners.push_back({part.item, k, false});
        if (std::abs(points[(k + 1) % points.size()].*axis - points[k].*axis) <= TiedNumbers::reach)
            edges.push_back({part.item, k, true});
    }
    return edges.empty() && part.kind == PartKind::Rail ? corners : edges;
}

} // namespace

bool exists(const AirBearingSurface& surface, const KeptDistance& distance)
{
    return exists(surface, distance.from) && exists(surface, distance.to);
}

bool exists(const AirBearingSurface& surface, const KeptSymmetry& symmetry)
{
    const auto [rail, image] = symmetry;
    return rail < surface.rails.size() && image < surface.rails.size() &&
           surface.rails[rail].points.size() == surface.rails[image].points.size() &&
           !surface.rails[rail].points.empty();
}

AirBearingSurface solved(const AirBearingSurface& drawn, const PartSelection& kept, double width,
                         const AirBearingSurface& before)
{
    const std::vector<bool> bound = connected(drawn, kept);
    AirBearingSurface result = drawn;
    for (const Axis axis : {&RailPoint::x, &RailPoint::y}) {
        AxisRelations relations(drawn, axis, width, bound, before);
        const auto contradicts = [](const RelationMisfit& misfit) { return misfit.contradicts != 0.0; };
        if (std::ranges::any_of(relations.misfits(), contradicts)) return drawn;
        if (!relations.misfits().empty()) relations.solve(kept, result);
    }
    return result;
}

AirBearingSurface keepingRelations(const AirBearingSurface& before, AirBearingSurface after, double width)
{
    std::erase_if(after.distances, [&](const KeptDistance& each) { return !exists(after, each); });
    std::erase_if(after.symmetries, [&](const KeptSymmetry& each) { return !exists(after, each); });
    if (after.distances != before.distances || after.symmetries != before.symmetries) return after;
    if (after.rails.size() != before.rails.size()) return after;
    PartSelection kept;
    for (std::size_t i = 0; i < after.rails.size(); ++i) {
        const std::vector<RailPoint>&then = before.rails[i].points, &now = after.rails[i].points;
        if (then.size() != now.size()) return after;
        for (std::size_t k = 0; k < now.size(); ++k)
            if (then[k].x != now[k].x || then[k].y != now[k].y) kept.insert({PartKind::Corner, i, k});
    }
    return kept.empty() ? after : solved(after, kept, width, before);
}

std::vector<SurfaceProblem> relationProblems(const AirBearingSurface& surface, double width)
{
    const std::vector<bool> all(surface.rails.size(), true);
    const AxisRelations alongX(surface, &RailPoint::x, width, all, surface);
    const AxisRelations alongY(surface, &RailPoint::y, width, all, surface);
    std::vector<RelationMisfit> misfits = alongX.misfits();
    for (const RelationMisfit& each : alongY.misfits()) {
        const auto same = std::ranges::find(misfits, each.relation, &RelationMisfit::relation);
        if (same == misfits.end())
            misfits.push_back(each);
        else if (std::abs(each.contradicts) + std::abs(each.drawn) >
                 std::abs(same->contradicts) + std::abs(same->drawn))
            *same = each;
    }
    std::ranges::stable_sort(misfits, std::greater(), [](const RelationMisfit& each) { return each.relation.kind; });
    std::vector<SurfaceProblem> problems;
    for (const RelationMisfit& each : misfits) problems.push_back(problemOf(surface, each));
    return problems;
}

SurfacePoint middleOf(const AirBearingSurface& surface, const RailPlace& place)
{
    const std::vector<RailPoint>& points = surface.rails[place.rail].points;
    const std::vector<std::size_t> corners = cornersAt(surface, place);
    const RailPoint &a = points[corners.front()], &b = points[corners.back()];
    return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}

std::optional<KeptDistance> drawnDistance(const AirBearingSurface& surface, const PartSelection& parts, bool alongX)
{
    if (parts.size() != 2 || !std::ranges::all_of(parts, isOfRail) ||
        !std::ranges::all_of(parts, [&](const SurfacePart& part) { return has(surface, part); }))
        return {};
    const Axis axis = alongX ? &RailPoint::x : &RailPoint::y;
    std::optional<KeptDistance> nearest;
    for (const RailPlace& a : endsOf(surface, *parts.begin(), axis))
        for (const RailPlace& b : endsOf(surface, *parts.rbegin(), axis)) {
            if (a == b) continue;
            const double value =
                tidy(surface.rails[b.rail].points[b.corner].*axis - surface.rails[a.rail].points[a.corner].*axis);
            if (nearest && std::abs(value) >= nearest->value) continue;
            nearest = value < 0.0 ? KeptDistance{b, a, alongX, -value} : KeptDistance{a, b, alongX, value};
        }
    return nearest;
}

AirBearingSurface withDistance(AirBearingSurface surface, std::size_t distance, double value, double width)
{
    KeptDistance& kept = surface.distances.at(distance);
    kept.value = value;
    const auto& [from, to, along, now] = kept;
    PartSelection parts;
    for (const std::size_t corner : cornersAt(surface, from)) parts.insert({PartKind::Corner, from.rail, corner});
    if (to.rail != from.rail) parts = {{PartKind::Rail, from.rail}};
    return solved(surface, parts, width, surface);
}

AirBearingSurface withSymmetry(AirBearingSurface surface, const KeptSymmetry& symmetry, double width)
{
    surface.symmetries.push_back(symmetry);
    return solved(surface, {{PartKind::Rail, symmetry.rail}}, width, surface);
}

} // namespace touchdown
