// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_key.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "core/formats/nearest_name.h"
#include "core/formats/words.h"
#include "core/physics/slider/surface_relations.h"

namespace touchdown {

namespace {

using Answer = std::variant<Parameter, std::string>;
using Get = std::function<double(const Case&)>;
using Set = std::function<void(Case&, double)>;

constexpr double farthest = 1.0; // of any length [m]
constexpr const char* ofTheCase = "ours: a number of the case's own surface";

struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -low; // [m]
    double middle() const { return 0.5 * (low + high); }
    double size() const { return high - low; }
};

Extent extentOf(const Rail& rail, double RailPoint::*axis)
{
    Extent extent;
    for (const RailPoint& point : rail.points) {
        extent.low = std::min(extent.low, point.*axis);
        extent.high = std::max(extent.high, point.*axis);
    }
    return extent;
}

/// A key in its parts: "abs.rail[2].point[3].x" is rail, 2, point, 3 and x; what it lacks is empty or 0.
struct Place {
    std::string_view list, leaf, axis;
    std::size_t number = 0, index = 0;
    std::string form() const; // "abs.rail[N].point[K].x"
};

std::string Place::form() const
{
    std::string text = "abs." + std::string(list) + "[N]";
    if (!leaf.empty()) text += '.' + std::string(leaf);
    if (index > 0) text += "[K]";
    if (!axis.empty()) text += '.' + std::string(axis);
    return text;
}

/// "point[3]" gives 3 and leaves "point"; 0 where there is no number, nothing where it is none.
std::optional<std::size_t> takeIndex(std::string_view& name)
{
    const std::size_t open = name.find('[');
    if (open == std::string_view::npos) return 0;
    if (!name.ends_with(']')) return {};
    const std::string_view digits = name.substr(open + 1, name.size() - open - 2);
    if (digits.size() > 1 && digits.front() == '0') return {}; // each number has one name
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc() || end != digits.data() + digits.size()) return {};
    name = name.substr(0, open);
    return index;
}

std::optional<Place> placeOf(std::string_view key)
{
    if (!key.starts_with("abs.")) return {};
    if (key.ends_with('.') || key.find("..") != std::string_view::npos) return {};
    std::array<std::string_view, 3> parts{};
    std::string_view rest = key.substr(4);
    for (std::string_view& part : parts) {
        const std::size_t dot = std::min(rest.find('.'), rest.size());
        part = rest.substr(0, dot);
        rest.remove_prefix(std::min(dot + 1, rest.size()));
    }
    if (!rest.empty()) return {};
    Place place{parts[0], parts[1], parts[2]};
    const bool indexed = place.list.find('[') != std::string_view::npos;
    const bool inner = place.leaf.find('[') != std::string_view::npos;
    const auto number = takeIndex(place.list), index = takeIndex(place.leaf);
    if (!indexed || !number || !index || (inner && *index == 0)) return {};
    place.number = *number;
    place.index = *index;
    return place;
}

Parameter length(const char* displayUnit, const Get& get, const Set& set)
{
    Parameter parameter{.unit = "m", .displayUnit = displayUnit, .minimum = -farthest, .maximum = farthest};
    parameter.get = [get](const Case& c) { return ParameterValue(get(c)); };
    parameter.set = [set](Case& c, const ParameterValue& value) { set(c, std::get<double>(value) + 0.0); };
    return parameter;
}

/// A number that the case holds as it is.
template <class Member>
Parameter plainLength(const char* displayUnit, Member member)
{
    return length(
        displayUnit, [member](const Case& c) { return member(c); },
        [member](Case& c, double value) { member(c) = value; });
}

Answer railRecess(const Case&, const Place& at)
{
    const std::size_t rail = at.number - 1;
    return length(
        "um", [rail](const Case& c) { return c.surface.rails[rail].recess[0]; },
        [rail](Case& c, double value) {
            Rail& changed = c.surface.rails[rail];
            const double change = value - changed.recess[0];
            for (double& recess : changed.recess) recess += change;
            changed.recess[0] = value;
            if (changed.kind == RailKind::Step) changed.recess = {value, 0.0, 0.0};
        });
}

Answer rampRecess(const Case& c, const Place& at)
{
    const std::size_t rail = at.number - 1, point = at.index - 1;
    if (c.surface.rails[rail].kind != RailKind::Ramp)
        return "rail " + std::to_string(at.number) + " is a step, which has one recess";
    if (point >= 3) return std::string("a ramp has a recess at each of its first three points");
    return plainLength(
        "um", [ rail, point ](auto& any) -> auto& { return any.surface.rails[rail].recess[point]; });
}

double RailPoint::*axisOf(std::string_view name)
{
    return name == "x" || name == "length" ? &RailPoint::x : &RailPoint::y;
}

Answer railPlace(const Case&, const Place& at)
{
    const std::size_t rail = at.number - 1;
    const auto axis = axisOf(at.leaf);
    const auto get = [rail, axis](const Case& c) { return extentOf(c.surface.rails[rail], axis).middle(); };
    return length("mm", get, [rail, axis, get](Case& c, double value) {
        const double change = value - get(c);
        for (RailPoint& point : c.surface.rails[rail].points) point.*axis += change;
    });
}

Answer railSize(const Case& c, const Place& at)
{
    const std::size_t rail = at.number - 1;
    const auto axis = axisOf(at.leaf);
    if (!(extentOf(c.surface.rails[rail], axis).size() > 0.0)) return std::string("the rail has no extent to stretch");
    Parameter parameter = length(
        "mm", [rail, axis](const Case& from) { return extentOf(from.surface.rails[rail], axis).size(); },
        [rail, axis](Case& to, double value) {
            const Extent extent = extentOf(to.surface.rails[rail], axis);
            for (RailPoint& point : to.surface.rails[rail].points)
                point.*axis = extent.middle() + (point.*axis - extent.middle()) * (value / extent.size());
        });
    parameter.minimum = 0.0;
    parameter.minimumAllowed = false;
    return parameter;
}

/// "there is no point 7; rail 2 has 4", or nothing.
std::optional<std::string> missing(const char* what, std::size_t index, const std::string& owner, std::size_t count)
{
    if (index >= 1 && index <= count) return {};
    return "there is no " + std::string(what) + ' ' + std::to_string(index) + "; " + owner + " has " +
           std::to_string(count);
}

std::optional<std::string> missingPoint(const Case& c, const Place& at)
{
    return missing("point", at.index, "rail " + std::to_string(at.number),
                   c.surface.rails[at.number - 1].points.size());
}

Answer railPoint(const Case& c, const Place& at)
{
    if (auto problem = missingPoint(c, at)) return *problem;
    const std::size_t rail = at.number - 1, point = at.index - 1;
    const auto axis = axisOf(at.axis);
    return plainLength(
        "mm", [ rail, point, axis ](auto& any) -> auto& { return any.surface.rails[rail].points[point].*axis; });
}

Answer railWall(const Case& c, const Place& at)
{
    if (auto problem = missingPoint(c, at)) return *problem;
    const std::size_t rail = at.number - 1, point = at.index - 1;
    Parameter parameter{
        .kind = ParameterKind::Integer, .minimum = 0.0, .maximum = static_cast<double>(c.surface.walls.size())};
    parameter.get = [rail, point](const Case& from) {
        return ParameterValue(from.surface.rails[rail].points[point].wall);
    };
    parameter.set = [rail, point](Case& to, const ParameterValue& value) {
        to.surface.rails[rail].points[point].wall = std::get<int>(value);
    };
    return parameter;
}

Answer wallNumber(const Case& c, const Place& at, std::vector<double> WallProfile::*list)
{
    const std::size_t wall = at.number - 1, point = at.index - 1;
    if (auto problem =
            missing("point", at.index, "wall " + std::to_string(at.number), (c.surface.walls[wall].*list).size()))
        return *problem;
    return plainLength(
        "um", [ wall, point, list ](auto& any) -> auto& { return (any.surface.walls[wall].*list)[point]; });
}
Answer wallDistance(const Case& c, const Place& at) { return wallNumber(c, at, &WallProfile::distance); }
Answer wallRecess(const Case& c, const Place& at) { return wallNumber(c, at, &WallProfile::recess); }

Answer wallShift(const Case& c, const Place& at)
{
    const std::size_t wall = at.number - 1;
    if (c.surface.walls[wall].distance.empty()) return std::string("the wall has no points");
    return length(
        "um", [wall](const Case& from) { return from.surface.walls[wall].distance.front(); },
        [wall](Case& to, double value) {
            std::vector<double>& distances = to.surface.walls[wall].distance;
            const double change = value - distances.front();
            for (double& distance : distances) distance += change;
            distances.front() = value;
        });
}

Answer interestPlace(const Case&, const Place& at)
{
    const std::size_t point = at.number - 1;
    const auto axis = at.leaf == "x" ? &SurfacePoint::x : &SurfacePoint::y;
    return plainLength(
        "mm", [ point, axis ](auto& any) -> auto& { return any.surface.pointsOfInterest[point].*axis; });
}

Answer distanceValue(const Case&, const Place& at)
{
    const std::size_t distance = at.number - 1;
    return length(
        "um", [distance](const Case& from) { return from.surface.distances[distance].value; },
        [distance](Case& to, double value) {
            to.surface = withDistance(std::move(to.surface), distance, value, to.slider.width);
        });
}

struct Kind {
    SurfaceNumberForm form;
    Answer (*make)(const Case&, const Place&);
};

const std::vector<Kind>& kinds()
{
    static const std::vector<Kind> all{
        {{"abs.rail[N].recess", "Recess of rail N, at its first point; a ramp keeps its slopes."}, railRecess},
        {{"abs.rail[N].recess[K]", "Recess of a ramp at its point K, 1 to 3."}, rampRecess},
        {{"abs.rail[N].x", "Middle of the rectangle around rail N; the rail is moved."}, railPlace},
        {{"abs.rail[N].y", "Middle of the rectangle around rail N; the rail is moved."}, railPlace},
        {{"abs.rail[N].length", "Length of the rectangle around rail N; the rail is stretched about its middle."},
         railSize},
        {{"abs.rail[N].width", "Width of the rectangle around rail N; the rail is stretched about its middle."},
         railSize},
        {{"abs.rail[N].point[K].x", "Corner K of rail N, from the leading edge."}, railPoint},
        {{"abs.rail[N].point[K].y", "Corner K of rail N, from the inner edge."}, railPoint},
        {{"abs.rail[N].wall[K]", "Wall on the edge from corner K of rail N to the next one; 0 for none."}, railWall},
        {{"abs.wall[N].distance[K]", "Distance of point K of wall N from the edge; negative inside the rail."},
         wallDistance},
        {{"abs.wall[N].recess[K]", "Recess at point K of wall N, from the zero plane."}, wallRecess},
        {{"abs.wall[N].shift", "Distance of the first point of wall N; the others are moved by as much."}, wallShift},
        {{"abs.distance[N].value", "Kept distance N; its place `to` moves, with all that relations connect to it."},
         distanceValue},
        {{"abs.points_of_interest[N].x", "Point of interest N, from the leading edge."}, interestPlace},
        {{"abs.points_of_interest[N].y", "Point of interest N, from the inner edge."}, interestPlace},
    };
    return all;
}

struct List {
    const char* name;
    const char* item;
    std::size_t count;
};
std::array<List, 4> listsOf(const AirBearingSurface& surface)
{
    return {{{"rail", "rail", surface.rails.size()},
             {"wall", "wall", surface.walls.size()},
             {"distance", "kept distance", surface.distances.size()},
             {"points_of_interest", "point of interest", surface.pointsOfInterest.size()}}};
}

Answer surfaceNumber(const Case& c, const std::string& key, const List& list)
{
    const std::optional<Place> place = placeOf(key);
    const auto kind = place ? std::ranges::find(kinds(), place->form(), [](const Kind& each) { return each.form.key; })
                            : kinds().end();
    if (kind == kinds().end()) {
        std::vector<std::string> offered;
        for (const Kind& each : kinds())
            if (each.form.key.starts_with("abs." + std::string(list.name) + '[')) offered.push_back(each.form.key);
        return "is none of the numbers " + joined(offered);
    }
    if (auto problem = missing(list.item, place->number, "the case", list.count)) return *problem;
    Answer made = kind->make(c, *place);
    if (auto* parameter = std::get_if<Parameter>(&made)) {
        parameter->key = key;
        parameter->label = key.substr(4);
        parameter->help = kind->form.help;
        parameter->source = ofTheCase;
        parameter->used = usesSliderSurface;
    }
    return made;
}

} // namespace

std::variant<Parameter, std::string> caseKey(const Case& c, std::string_view key)
{
    if (const Parameter* parameter = findParameter(key)) return *parameter;
    for (const List& list : listsOf(c.surface))
        if (key.starts_with("abs." + std::string(list.name) + '[')) return surfaceNumber(c, std::string(key), list);
    return "is no key of a case" + didYouMean(nearestKey(key));
}

std::variant<Parameter, std::string> numberKey(const Case& c, std::string_view key)
{
    auto found = caseKey(c, key);
    if (const auto* parameter = std::get_if<Parameter>(&found)) {
        if (parameter->kind != ParameterKind::Number) return std::string("is no number with a range to search");
        if (!parameter->used(c)) return std::string("has no part in this case");
    }
    return found;
}

std::variant<Parameter, std::string> sceneKey(const Case& c, std::string_view key)
{
    auto found = numberKey(c, key);
    if (std::holds_alternative<Parameter>(found) && (key.starts_with("run.") || key.starts_with("spectrum.")))
        return std::string("belongs to the computation, not to the scene");
    return found;
}

std::span<const SurfaceNumberForm> surfaceNumberForms()
{
    static const std::vector<SurfaceNumberForm> forms = [] {
        std::vector<SurfaceNumberForm> all;
        for (const Kind& kind : kinds()) all.push_back(kind.form);
        return all;
    }();
    return forms;
}

} // namespace touchdown
