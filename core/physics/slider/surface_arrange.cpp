// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_arrange.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

/// From the least to the largest x or y of a rail [m].
struct Extent {
    double low, high;
    double middle() const { return 0.5 * (low + high); }
};

Extent extentOf(const Rail& rail, bool alongX)
{
    const auto place = alongX ? &RailPoint::x : &RailPoint::y;
    const auto [low, high] = std::ranges::minmax(rail.points, {}, place);
    return {low.*place, high.*place};
}

std::vector<std::size_t> railsAmong(const AirBearingSurface& surface, const PartSelection& parts)
{
    std::vector<std::size_t> rails;
    for (const SurfacePart& part : parts)
        if (part.kind == PartKind::Rail && has(surface, part) && !surface.rails[part.item].points.empty())
            rails.push_back(part.item);
    return rails;
}

/// A rail that is there but for the rounding of places stays, so that the same edit once more changes nothing.
AirBearingSurface movedAlong(AirBearingSurface surface, std::size_t rail, bool alongX, double by)
{
    constexpr double rounding = 3e-15; // [m]
    if (std::abs(by) < rounding) return surface;
    return moved(std::move(surface), {{PartKind::Rail, rail}}, alongX ? SurfaceShift{by, 0.0} : SurfaceShift{0.0, by});
}

} // namespace

AirBearingSurface withMirroredCopies(AirBearingSurface surface, const PartSelection& parts, double width)
{
    PartSelection copies;
    const std::size_t count = surface.rails.size();
    surface = withCopies(std::move(surface), parts, {});
    for (std::size_t rail = count; rail < surface.rails.size(); ++rail) copies.insert({PartKind::Rail, rail});
    return mirrored(std::move(surface), copies, width);
}

AirBearingSurface aligned(AirBearingSurface surface, const PartSelection& parts, Alignment to)
{
    const std::vector<std::size_t> rails = railsAmong(surface, parts);
    if (rails.size() < 2) return surface;
    const bool alongX = to == Alignment::Left || to == Alignment::MiddleX || to == Alignment::Right;
    Extent all = extentOf(surface.rails[rails.front()], alongX);
    for (const std::size_t rail : rails) {
        const Extent one = extentOf(surface.rails[rail], alongX);
        all = {std::min(all.low, one.low), std::max(all.high, one.high)};
    }
    const auto placeOn = [to](const Extent& extent) {
        if (to == Alignment::Left || to == Alignment::Bottom) return extent.low;
        return to == Alignment::Right || to == Alignment::Top ? extent.high : extent.middle();
    };
    for (const std::size_t rail : rails) {
        const double by = placeOn(all) - placeOn(extentOf(surface.rails[rail], alongX));
        surface = movedAlong(std::move(surface), rail, alongX, by);
    }
    return surface;
}

AirBearingSurface distributed(AirBearingSurface surface, const PartSelection& parts, bool alongX)
{
    std::vector<std::size_t> rails = railsAmong(surface, parts);
    if (rails.size() < 3) return surface;
    const auto extent = [&](std::size_t rail) { return extentOf(surface.rails[rail], alongX); };
    std::ranges::stable_sort(rails, {}, [&](std::size_t rail) { return extent(rail).middle(); });
    double gap = extent(rails.back()).high - extent(rails.front()).low;
    for (const std::size_t rail : rails) gap -= extent(rail).high - extent(rail).low;
    gap /= static_cast<double>(rails.size() - 1);
    double at = extent(rails.front()).high + gap;
    for (std::size_t i = 1; i + 1 < rails.size(); ++i) {
        const Extent now = extent(rails[i]);
        surface = movedAlong(std::move(surface), rails[i], alongX, at - now.low);
        at += now.high - now.low + gap;
    }
    return surface;
}

AirBearingSurface withArray(AirBearingSurface surface, const PartSelection& parts, int count, SurfaceShift step)
{
    for (int k = 1; k <= count; ++k) surface = withCopies(std::move(surface), parts, {k * step.x, k * step.y});
    return surface;
}

} // namespace touchdown
