// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_symmetry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/physics/slider/corner_numbers.h"
#include "core/physics/slider/rail_outline.h"

namespace touchdown {

namespace {

using CornerRow = std::vector<RailPoint>;

double turnedOver(double y, double width)
{
    AirBearingSurface surface;
    surface.pointsOfInterest = {{0.0, y}};
    return mirrored(surface, {{PartKind::Interest, 0}}, width).pointsOfInterest[0].y;
}

RailPoint imageOf(const RailPoint& corner, double width, int wall)
{
    return {corner.x, turnedOver(corner.y, width), wall};
}

/// The outline with corners where its edges cross y = centre; corners within 1e-12 m of it are on it.
CornerRow cutAt(const CornerRow& points, double centre)
{
    constexpr double onLine = 1e-12; // [m]
    CornerRow corners = points, cut;
    for (RailPoint& p : corners)
        if (std::abs(p.y - centre) < onLine) p.y = centre;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const RailPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
        cut.push_back(a);
        if ((a.y - centre) * (b.y - centre) >= 0.0) continue;
        const double x = a.x + (centre - a.y) / (b.y - a.y) * (b.x - a.x);
        cut.push_back({a.x == b.x ? a.x : std::round(x * 1e15) / 1e15, centre, a.wall});
    }
    return cut;
}

/// The corners above the centre line (side 1) or below it (-1), from a corner on the line to the other one on it;
/// nothing where there is not one such row.
std::optional<CornerRow> half(const CornerRow& cut, double centre, double side)
{
    const std::size_t count = cut.size();
    const auto within = [&](std::size_t i) { return side * (cut[i % count].y - centre) > 0.0; };
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < count; ++i) {
        if (within(i) || !within(i + 1)) continue;
        if (first) return {};
        first = i;
    }
    if (!first) return {};
    CornerRow row{cut[*first]};
    std::size_t i = *first + 1;
    for (; within(i); ++i) row.push_back(cut[i % count]);
    row.push_back(cut[i % count]);
    if (row.front().y != centre || row.back().y != centre) return {};
    return row;
}

/// The row and its image as one outline. CornerRow on the line are left out where the outline runs straight on.
CornerRow closedByImage(const CornerRow& row, double width)
{
    const std::size_t last = row.size() - 1;
    CornerRow outline;
    if (row[0].x != row[1].x) outline.push_back(row[0]);
    outline.insert(outline.end(), row.begin() + 1, row.begin() + static_cast<std::ptrdiff_t>(last));
    if (row[last].x != row[last - 1].x) {
        outline.push_back(row[last]);
        outline.back().wall = row[last - 1].wall;
    }
    for (std::size_t k = last; k-- > 1;) outline.push_back(imageOf(row[k], width, row[k - 1].wall));
    return outline;
}

/// Nothing where the rail cannot be made so.
std::optional<Rail> symmetricFromHalf(const Rail& rail, double width)
{
    if (rail.kind == RailKind::Ramp) return {};
    const double centre = 0.5 * width;
    const CornerRow cut = cutAt(rail.points, centre);
    const auto above = half(cut, centre, 1.0), below = half(cut, centre, -1.0);
    if (!above || !below) return {};
    const bool upper = std::abs(signedArea(*above)) >= std::abs(signedArea(*below));
    Rail result = rail;
    result.points = closedByImage(upper ? *above : *below, width);
    return result;
}

} // namespace

AirBearingSurface madeSymmetric(AirBearingSurface surface, const PartSelection& rails, double width, double reach)
{
    const double centre = 0.5 * width;
    const auto images = mirrorImages(surface, width, reach);
    CornerNumbers numbers(surface);
    // From the last to the first, so that the numbers of the others hold.
    for (auto part = rails.rbegin(); part != rails.rend(); ++part) {
        if (part->kind != PartKind::Rail || !has(surface, *part) || images[part->item]) continue;
        Rail& rail = surface.rails[part->item];
        const auto [low, high] = std::ranges::minmax(rail.points, {}, &RailPoint::y);
        if (low.y < centre - reach && high.y > centre + reach) {
            if (auto symmetric = symmetricFromHalf(rail, width)) {
                rail = std::move(*symmetric);
                numbers.rails()[part->item].assign(rail.points.size(), {});
            }
            continue;
        }
        AirBearingSurface image;
        image.rails = {rail};
        image = mirrored(std::move(image), {{PartKind::Rail, 0}}, width);
        const auto next = static_cast<std::ptrdiff_t>(part->item) + 1;
        surface.rails.insert(surface.rails.begin() + next, image.rails[0]);
        numbers.rails().insert(numbers.rails().begin() + next, {image.rails[0].points.size(), CornerNumbers::Old{}});
    }
    numbers.apply(surface);
    return surface;
}

} // namespace touchdown
