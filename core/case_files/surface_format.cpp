// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/surface_format.h"

#include "core/formats/toml_quantity.h"

#include <algorithm>

namespace touchdown {

namespace {

constexpr const char* alongUnit = "mm";
constexpr const char* recessUnit = "um";

/// A list, broken into several lines if one would be too long.
std::string list(const std::vector<std::string>& elements)
{
    constexpr std::size_t widest = 110;
    std::string text = "[";
    std::size_t column = 12; // about where a value begins
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (i > 0) text += ',';
        if (column + elements[i].size() > widest) {
            text += "\n    ";
            column = 4;
        } else if (i > 0) {
            text += ' ';
        }
        text += elements[i];
        column += elements[i].size() + 2;
    }
    return text + ']';
}

std::string quantities(const std::vector<double>& values, std::string_view unit)
{
    std::vector<std::string> elements;
    for (const double value : values) elements.push_back(formatTomlQuantity(value, unit));
    return list(elements);
}

std::string place(double x, double y)
{
    return '[' + formatTomlQuantity(x, alongUnit) + ", " + formatTomlQuantity(y, alongUnit) + ']';
}

template <typename Point>
std::string places(const std::vector<Point>& points)
{
    std::vector<std::string> elements;
    for (const Point& point : points) elements.push_back(place(point.x, point.y));
    return list(elements);
}

std::string walls(const Rail& rail)
{
    const auto& points = rail.points;
    const bool same = std::ranges::all_of(points, [&](const RailPoint& p) { return p.wall == points.front().wall; });
    if (same) return std::to_string(points.empty() ? 0 : points.front().wall);
    std::vector<std::string> elements;
    for (const RailPoint& point : points) elements.push_back(std::to_string(point.wall));
    return list(elements);
}

std::string placeText(const RailPlace& place)
{
    return (place.edge ? "\"edge " : "\"corner ") + std::to_string(place.corner + 1) + " of rail " +
           std::to_string(place.rail + 1) + '"';
}

} // namespace

std::vector<SurfaceRow> surfaceRows(const Rail& rail)
{
    const std::string recess = rail.kind == RailKind::Step
                                   ? formatTomlQuantity(rail.recess[0], recessUnit)
                                   : quantities({rail.recess.begin(), rail.recess.end()}, recessUnit);
    return {{"recess", recess}, {"points", places(rail.points)}, {"walls", walls(rail)}};
}

std::vector<SurfaceRow> surfaceRows(const WallProfile& wall)
{
    return {{"distance", quantities(wall.distance, recessUnit)}, {"recess", quantities(wall.recess, recessUnit)}};
}

std::vector<SurfaceRow> surfaceRows(const KeptDistance& distance)
{
    return {{"from", placeText(distance.from)},
            {"to", placeText(distance.to)},
            {"along", distance.alongX ? "\"x\"" : "\"y\""},
            {"value", formatTomlQuantity(distance.value, recessUnit)}};
}

std::vector<SurfaceRow> surfaceRows(const KeptSymmetry& symmetry)
{
    const std::string rail = std::to_string(symmetry.rail + 1), image = std::to_string(symmetry.image + 1);
    return {{"rails", symmetry.rail == symmetry.image ? '[' + rail + ']' : '[' + rail + ", " + image + ']'}};
}

std::string interestText(const std::vector<SurfacePoint>& points) { return places(points); }

std::string surfaceTable(std::string_view name, const std::vector<SurfaceRow>& rows)
{
    std::string text = "[[abs." + std::string(name) + "]]\n";
    for (const SurfaceRow& row : rows) text += row.key + " = " + row.value + "\n";
    return text;
}

std::string formatSurface(const AirBearingSurface& surface)
{
    std::string text;
    if (!surface.pointsOfInterest.empty())
        text += "points_of_interest = " + interestText(surface.pointsOfInterest) + "\n";
    for (const Rail& rail : surface.rails) text += "\n" + surfaceTable("rail", surfaceRows(rail));
    for (std::size_t i = 0; i < surface.walls.size(); ++i)
        text += "\n# wall " + std::to_string(i + 1) + "\n" + surfaceTable("wall", surfaceRows(surface.walls[i]));
    for (const KeptDistance& each : surface.distances) text += "\n" + surfaceTable("distance", surfaceRows(each));
    for (const KeptSymmetry& each : surface.symmetries) text += "\n" + surfaceTable("symmetric", surfaceRows(each));
    return text;
}

} // namespace touchdown
