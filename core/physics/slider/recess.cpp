// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/recess.h"

#include <algorithm>
#include <iterator>

#include "core/physics/slider/surface_bins.h"

namespace touchdown {

namespace {

constexpr double boxSlack = 1e-11; // [m] a box is smooth only this far from anything that is not

/// The plane through the recesses at the first three points.
RailTop topOf(const Rail& rail)
{
    if (rail.kind == RailKind::Step) return {rail.recess[0], 0.0, 0.0};
    const RailPoint& p = rail.points[0];
    const double x1 = rail.points[1].x - p.x, y1 = rail.points[1].y - p.y, r1 = rail.recess[1] - rail.recess[0];
    const double x2 = rail.points[2].x - p.x, y2 = rail.points[2].y - p.y, r2 = rail.recess[2] - rail.recess[0];
    const double area = x1 * y2 - x2 * y1;
    const double cx = (r1 * y2 - r2 * y1) / area;
    const double cy = (x1 * r2 - x2 * r1) / area;
    return {rail.recess[0] - cx * p.x - cy * p.y, cx, cy};
}

SurfaceParts partsOf(const AirBearingSurface& surface, double length, double width)
{
    SurfaceParts parts{length, width, surface.baseRecess, {}, {}, {}, {}};
    for (const WallProfile& profile : surface.walls) parts.shapes.emplace_back(profile);
    for (const Rail& rail : surface.rails) {
        const int index = static_cast<int>(parts.tops.size());
        parts.tops.push_back(topOf(rail));
        parts.outlines.emplace_back(rail.points, SurfaceBins::rows, width);
        std::ranges::move(railWalls(rail, index, surface.baseRecess, parts.shapes), std::back_inserter(parts.walls));
    }
    return parts;
}

} // namespace

struct Recess::Prepared {
    SurfaceParts parts;
    SurfaceBins bins;
    double crown, camber, twist;    // [m]
    double taperLength, taperAngle; // [m], [rad]
    std::vector<double> taperEnds;  // x where the taper ends, at its length or in a level top; ascending [m]

    Prepared(const AirBearingSurface& surface, double length, double width);

    int topRail(std::size_t bin, double x, double y) const;
    double raised(std::size_t bin, double x, double y) const;
    bool smooth(std::size_t bin, const SurfaceBox& box, int row) const;
    void breaks(std::size_t bin, const ScanLine& line, int row, std::vector<double>& out) const;
    void breaksAlong(const ScanLine& line, std::vector<double>& out) const;
    double form(double x, double y) const;

    // To the nearest point of the slider. A number that is none stays so.
    double onSliderX(double x) const { return std::min(std::max(x, 0.0), parts.length); }
    double onSliderY(double y) const { return std::min(std::max(y, 0.0), parts.width); }
};

Recess::Prepared::Prepared(const AirBearingSurface& s, double length, double width)
    : parts(partsOf(s, length, width)),
      bins(parts),
      crown(s.crown),
      camber(s.camber),
      twist(s.twist),
      taperLength(s.taperLength),
      taperAngle(s.taperAngle)
{
    if (taperLength <= 0.0 || taperAngle == 0.0) return;
    // angle (length - x) = recess
    const auto add = [&](double recess) { taperEnds.push_back(taperLength - recess / taperAngle); };
    taperEnds.push_back(taperLength);
    add(parts.baseRecess);
    for (const RailTop& top : parts.tops)
        if (top.cx == 0.0 && top.cy == 0.0) add(top.c);
    std::erase_if(taperEnds, [&](double x) { return x < 0.0 || x > taperLength; });
    std::sort(taperEnds.begin(), taperEnds.end());
    taperEnds.erase(std::unique(taperEnds.begin(), taperEnds.end()), taperEnds.end());
}

int Recess::Prepared::topRail(std::size_t bin, double x, double y) const
{
    const int cover = bins.cover(bin);
    for (const int rail : bins.rails(bin)) {
        if (rail < cover) break;
        if (parts.outlines[static_cast<std::size_t>(rail)].contains(x, y)) return rail;
    }
    return cover;
}

/// The tops, then the walls.
double Recess::Prepared::raised(std::size_t bin, double x, double y) const
{
    const int rail = topRail(bin, x, y);
    double recess = rail < 0 ? parts.baseRecess : parts.tops[static_cast<std::size_t>(rail)].at(x, y);

    bool cut = false; // by a wall inside its own polygon: the deepest holds
    for (const SurfaceBins::WallPart& part : bins.walls(bin)) {
        const RailWall& wall = parts.walls[part.wall];
        if (part.side == WallSide::Inside) {
            if (wall.rail() != rail) continue;
            if (const auto inside = wall.recessInside(x, y)) {
                recess = cut ? std::max(recess, *inside) : *inside;
                cut = true;
            }
            continue;
        }
        if (part.lowest >= recess) break; // nor do the parts that follow
        if (wall.rail() == rail) continue;
        const double outside = wall.recessOutside(x, y);
        if (outside >= recess) continue;
        if (part.certain || !parts.outlines[static_cast<std::size_t>(wall.rail())].contains(x, y)) recess = outside;
    }
    return recess;
}

double Recess::Prepared::form(double x, double y) const
{
    const double X = x / parts.length;
    const double Y = y / parts.width;
    return 4.0 * (crown * X * (1.0 - X) + camber * Y * (1.0 - Y) + twist * (X - 0.5) * (Y - 0.5));
}

void Recess::Prepared::breaks(std::size_t bin, const ScanLine& line, int row, std::vector<double>& out) const
{
    for (const int rail : bins.rails(bin)) parts.outlines[static_cast<std::size_t>(rail)].breaks(line, row, out);
    for (const SurfaceBins::WallPart& part : bins.walls(bin)) parts.walls[part.wall].breaks(line, part.side, out);
}

void Recess::Prepared::breaksAlong(const ScanLine& line, std::vector<double>& out) const
{
    const auto before = static_cast<std::ptrdiff_t>(out.size());
    const bool alongX = line.along == ScanAxis::X;
    const int across = alongX ? bins.row(line.fixed) : bins.column(line.fixed);
    const int last = alongX ? bins.column(line.to) : bins.row(line.to);
    for (int bin = alongX ? bins.column(line.from) : bins.row(line.from); bin <= last; ++bin) {
        const int column = alongX ? bin : across, row = alongX ? across : bin;
        const SurfaceBox box = bins.box(column, row);
        const ScanLine part{line.along, line.fixed, std::max(line.from, alongX ? box.x0 : box.y0),
                            std::min(line.to, alongX ? box.x1 : box.y1)};
        breaks(SurfaceBins::index(column, row), part, row, out);
    }
    if (alongX)
        for (const double x : taperEnds)
            if (x > line.from && x < line.to) out.push_back(x);
    std::sort(out.begin() + before, out.end());
    out.erase(std::unique(out.begin() + before, out.end()), out.end());
}

bool Recess::Prepared::smooth(std::size_t bin, const SurfaceBox& box, int row) const
{
    for (const int rail : bins.rails(bin)) {
        for (const OutlineEdge& edge : parts.outlines[static_cast<std::size_t>(rail)].edges(row))
            if (edge.meets(box)) return false;
    }
    for (const SurfaceBins::WallPart& part : bins.walls(bin))
        if (parts.walls[part.wall].meets(box, part.side)) return false;
    return true;
}

Recess::Recess(const AirBearingSurface& surface, double length, double width)
    : prepared_(std::make_shared<const Prepared>(surface, length, width))
{}

double Recess::length() const { return prepared_->parts.length; }
double Recess::width() const { return prepared_->parts.width; }

double Recess::at(double x, double y) const
{
    const Prepared& p = *prepared_;
    x = p.onSliderX(x);
    y = p.onSliderY(y);
    double recess = p.raised(SurfaceBins::index(p.bins.column(x), p.bins.row(y)), x, y);
    if (x < p.taperLength) recess = std::max(recess, p.taperAngle * (p.taperLength - x));
    return recess - p.form(x, y);
}

void Recess::breaksAlongX(double y, double x0, double x1, std::vector<double>& out) const
{
    prepared_->breaksAlong({ScanAxis::X, prepared_->onSliderY(y), x0, x1}, out);
}

void Recess::breaksAlongY(double x, double y0, double y1, std::vector<double>& out) const
{
    prepared_->breaksAlong({ScanAxis::Y, prepared_->onSliderX(x), y0, y1}, out);
}

Recess::Slopes Recess::formSlopes(double x, double y) const
{
    const Prepared& p = *prepared_;
    const double X = x / length(), Y = y / width();
    return {-4.0 * (p.crown * (1.0 - 2.0 * X) + p.twist * (Y - 0.5)) / length(),
            -4.0 * (p.camber * (1.0 - 2.0 * Y) + p.twist * (X - 0.5)) / width()};
}

double Recess::taperLength() const { return prepared_->taperLength; }

bool Recess::isSmooth(double x0, double x1, double y0, double y1) const
{
    const Prepared& p = *prepared_;
    const SurfaceBox box{p.onSliderX(x0) - boxSlack, p.onSliderX(x1) + boxSlack, p.onSliderY(y0) - boxSlack,
                         p.onSliderY(y1) + boxSlack};
    const auto end = std::lower_bound(p.taperEnds.begin(), p.taperEnds.end(), box.x0);
    if (end != p.taperEnds.end() && *end <= box.x1) return false;
    const int lastRow = p.bins.row(box.y1);
    const int lastColumn = p.bins.column(box.x1);
    for (int row = p.bins.row(box.y0); row <= lastRow; ++row) {
        for (int column = p.bins.column(box.x0); column <= lastColumn; ++column) {
            const std::size_t bin = SurfaceBins::index(column, row);
            if (!p.smooth(bin, box, row)) return false;
            const int top = p.bins.cover(bin);
            const bool level = top < 0 || (p.parts.tops[static_cast<std::size_t>(top)].cx == 0.0 &&
                                           p.parts.tops[static_cast<std::size_t>(top)].cy == 0.0);
            if (!level && box.x0 < p.taperLength) return false;
        }
    }
    return true;
}

} // namespace touchdown
