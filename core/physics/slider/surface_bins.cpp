// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_bins.h"

#include <algorithm>
#include <tuple>

namespace touchdown {

namespace {

constexpr double binSlack = 1e-11; // [m] bins overlap by this much: more than the lists' own tolerance

/// The greatest recess of a plane in a box [m].
double greatest(const RailTop& top, const SurfaceBox& box)
{
    return top.at(top.cx > 0.0 ? box.x1 : box.x0, top.cy > 0.0 ? box.y1 : box.y0);
}

} // namespace

SurfaceBins::SurfaceBins(const SurfaceParts& parts)
    : length_(parts.length),
      width_(parts.width),
      perX_(columns / parts.length),
      perY_(rows / parts.width),
      bins_(static_cast<std::size_t>(columns * rows) + 1)
{
    std::vector<Place> places(bins_.size() - 1);
    std::vector<RailEntry> rails;
    std::vector<WallEntry> walls;
    std::uint32_t wall = 0;
    for (int rail = 0; rail < static_cast<int>(parts.tops.size()); ++rail) {
        placeRail(parts, rail, places);
        sortRail(places, rail, rails);
        for (; wall < parts.walls.size() && parts.walls[wall].rail() == rail; ++wall)
            sortWall(parts, wall, places, walls);
    }
    dropHidden(parts, rails, walls);
    fill(parts, rails, walls);
}

int SurfaceBins::column(double x) const
{
    return static_cast<int>(std::min(std::max(0.0, x * perX_), columns - 1.0)); // 0 for a number that is none
}

int SurfaceBins::row(double y) const { return static_cast<int>(std::min(std::max(0.0, y * perY_), rows - 1.0)); }

SurfaceBox SurfaceBins::box(int column, int row) const
{
    return {column / perX_ - binSlack, (column + 1) / perX_ + binSlack, row / perY_ - binSlack,
            (row + 1) / perY_ + binSlack};
}

std::span<const int> SurfaceBins::rails(std::size_t bin) const
{
    return {rails_.data() + bins_[bin].rails, rails_.data() + bins_[bin + 1].rails};
}

std::span<const SurfaceBins::WallPart> SurfaceBins::walls(std::size_t bin) const
{
    return {walls_.data() + bins_[bin].walls, walls_.data() + bins_[bin + 1].walls};
}

// Where no edge passes, a whole run of bins lies on the same side of the outline.
void SurfaceBins::placeRail(const SurfaceParts& parts, int rail, std::vector<Place>& places)
{
    const RailOutline& outline = parts.outlines[static_cast<std::size_t>(rail)];
    std::fill(places.begin(), places.end(), Place::Outside);
    const int firstRow = row(outline.bounds().y0 - binSlack);
    const int lastRow = row(outline.bounds().y1 + binSlack);
    const int firstColumn = column(outline.bounds().x0 - binSlack);
    const int lastColumn = column(outline.bounds().x1 + binSlack);
    for (int r = firstRow; r <= lastRow; ++r) {
        for (const OutlineEdge& edge : outline.edges(r)) {
            const int last = column(edge.xMax + binSlack);
            for (int c = column(edge.xMin - binSlack); c <= last; ++c)
                if (edge.meets(box(c, r))) places[index(c, r)] = Place::Crossed;
        }
        bool known = false;
        bool inside = false;
        for (int c = firstColumn; c <= lastColumn; ++c) {
            Place& place = places[index(c, r)];
            if (place == Place::Crossed) {
                known = false;
                continue;
            }
            if (!known) {
                const SurfaceBox b = box(c, r);
                inside = outline.contains(b.centreX(), b.centreY());
                known = true;
            }
            place = inside ? Place::Inside : Place::Outside;
        }
    }
}

void SurfaceBins::sortRail(const std::vector<Place>& places, int rail, std::vector<RailEntry>& entries)
{
    for (std::size_t bin = 0; bin < places.size(); ++bin) {
        if (places[bin] == Place::Inside) bins_[bin].cover = rail;
        if (places[bin] == Place::Crossed) entries.push_back({static_cast<std::uint32_t>(bin), rail});
    }
}

void SurfaceBins::sortWall(const SurfaceParts& parts, std::uint32_t wall, const std::vector<Place>& places,
                           std::vector<WallEntry>& entries) const
{
    const RailWall& w = parts.walls[wall];
    const SurfaceBox bounds = w.bounds();
    if (bounds.x1 < 0.0 || bounds.x0 > length_ || bounds.y1 < 0.0 || bounds.y0 > width_) return;
    const int lastRow = row(bounds.y1 + binSlack);
    const int lastColumn = column(bounds.x1 + binSlack);
    for (int r = row(bounds.y0 - binSlack); r <= lastRow; ++r) {
        for (int c = column(bounds.x0 - binSlack); c <= lastColumn; ++c) {
            const Place place = places[index(c, r)];
            const auto bin = static_cast<std::uint32_t>(index(c, r));
            const SurfaceBox b = box(c, r);
            const bool certain = place != Place::Crossed;
            if (place != Place::Inside && w.has(WallSide::Outside) && w.meets(b, WallSide::Outside))
                entries.push_back({bin, {wall, WallSide::Outside, certain, w.lowestOutside(b)}});
            if (place != Place::Outside && w.has(WallSide::Inside) && w.meets(b, WallSide::Inside))
                entries.push_back({bin, {wall, WallSide::Inside, certain, w.shape().minimumFrom(w.shape().inner())}});
        }
    }
}

// The inside of a wall is visible only in its own top; the outside only where it is shallower than the deepest other
// part that is visible in the bin.
void SurfaceBins::dropHidden(const SurfaceParts& parts, const std::vector<RailEntry>& rails,
                             std::vector<WallEntry>& walls) const
{
    std::erase_if(walls, [&](const WallEntry& entry) {
        return entry.part.side == WallSide::Inside && parts.walls[entry.part.wall].rail() < bins_[entry.bin].cover;
    });
    std::vector<double> deepest(bins_.size() - 1);
    for (std::size_t bin = 0; bin < deepest.size(); ++bin) {
        const int c = static_cast<int>(bin) % columns;
        const int r = static_cast<int>(bin) / columns;
        const int cover = bins_[bin].cover;
        deepest[bin] = cover < 0 ? parts.baseRecess : greatest(parts.tops[static_cast<std::size_t>(cover)], box(c, r));
    }
    const auto deepen = [&](std::uint32_t bin, double recess) { deepest[bin] = std::max(deepest[bin], recess); };
    for (const auto& [bin, rail] : rails) {
        if (rail <= bins_[bin].cover) continue;
        const SurfaceBox b = box(static_cast<int>(bin) % columns, static_cast<int>(bin) / columns);
        deepen(bin, greatest(parts.tops[static_cast<std::size_t>(rail)], b));
    }
    for (const auto& [bin, part] : walls)
        if (part.side == WallSide::Inside) deepen(bin, parts.walls[part.wall].shape().maximum());
    std::erase_if(walls, [&](const WallEntry& entry) {
        return entry.part.side == WallSide::Outside && entry.part.lowest >= deepest[entry.bin];
    });
}

void SurfaceBins::fill(const SurfaceParts& parts, const std::vector<RailEntry>& rails,
                       const std::vector<WallEntry>& walls)
{
    std::vector<std::uint32_t> next(bins_.size(), 0);
    for (const auto& [bin, part] : walls) ++next[bin + 1];
    for (std::size_t bin = 0; bin + 1 < bins_.size(); ++bin) next[bin + 1] += next[bin];
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) bins_[bin].walls = next[bin];
    walls_.resize(walls.size());
    for (const auto& [bin, part] : walls) walls_[next[bin]++] = part;
    for (std::size_t bin = 0; bin + 1 < bins_.size(); ++bin) {
        std::sort(walls_.begin() + bins_[bin].walls, walls_.begin() + bins_[bin + 1].walls,
                  [](const WallPart& a, const WallPart& b) {
                      return std::tuple(a.side == WallSide::Outside, a.lowest, a.wall) <
                             std::tuple(b.side == WallSide::Outside, b.lowest, b.wall);
                  });
    }

    // A rail hidden below the cover matters only for its walls outside.
    const auto shows = [&](const RailEntry& entry) {
        if (entry.rail > bins_[entry.bin].cover) return true;
        const auto of = this->walls(entry.bin);
        return std::any_of(of.begin(), of.end(),
                           [&](const WallPart& part) { return parts.walls[part.wall].rail() == entry.rail; });
    };
    std::vector<RailEntry> shown;
    std::copy_if(rails.begin(), rails.end(), std::back_inserter(shown), shows);
    std::vector<std::uint32_t> firstRail(bins_.size(), 0);
    for (const RailEntry& entry : shown) ++firstRail[entry.bin + 1];
    for (std::size_t bin = 0; bin + 1 < bins_.size(); ++bin) firstRail[bin + 1] += firstRail[bin];
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) bins_[bin].rails = firstRail[bin];
    rails_.resize(shown.size());
    for (auto entry = shown.rbegin(); entry != shown.rend(); ++entry) rails_[firstRail[entry->bin]++] = entry->rail;
}

} // namespace touchdown
