// SPDX-License-Identifier: GPL-3.0-or-later
//
// The recess by the letter of its rules: every rail and every wall is looked at for every point, offset lines are met
// by Cramer's rule. Without form and taper. For points that lie on no line of the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown::test {

class PlainRecess {
public:
    explicit PlainRecess(const AirBearingSurface& surface) : surface_(surface) {}

    double at(double x, double y) const
    {
        const Rail* top = nullptr;
        for (const Rail& rail : surface_.rails) {
            if (inside(rail, x, y)) top = &rail;
        }
        double recess = top ? height(*top, x, y) : surface_.baseRecess;
        if (top) {
            std::optional<double> cut;
            for (std::size_t i = 0; i < top->points.size(); ++i) {
                if (const auto value = wall(*top, i, x, y, -1)) cut = std::max(cut.value_or(*value), *value);
            }
            recess = cut.value_or(recess);
        }
        for (const Rail& rail : surface_.rails) {
            if (inside(rail, x, y)) continue;
            for (std::size_t i = 0; i < rail.points.size(); ++i) {
                if (const auto value = wall(rail, i, x, y, +1)) recess = std::min(recess, *value);
            }
        }
        return recess;
    }

private:
    struct Vector {
        double x, y;
    };
    static double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
    static double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

    static Vector corner(const Rail& rail, std::size_t i)
    {
        const RailPoint& p = rail.points[i % rail.points.size()];
        return {p.x, p.y};
    }
    /// The winding number by the sum of the angles under which the edges are seen.
    static bool inside(const Rail& rail, double x, double y)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < rail.points.size(); ++i) {
            const Vector a{corner(rail, i).x - x, corner(rail, i).y - y};
            const Vector b{corner(rail, i + 1).x - x, corner(rail, i + 1).y - y};
            sum += std::atan2(cross(a, b), dot(a, b));
        }
        return std::abs(sum) > 1.0;
    }
    /// In the barycentric coordinates of the first three points.
    static double height(const Rail& rail, double x, double y)
    {
        if (rail.kind == RailKind::Step) return rail.recess[0];
        const Vector p = corner(rail, 0), a = corner(rail, 1), b = corner(rail, 2);
        const Vector u{a.x - p.x, a.y - p.y}, v{b.x - p.x, b.y - p.y}, w{x - p.x, y - p.y};
        const double s = cross(w, v) / cross(u, v), t = cross(u, w) / cross(u, v);
        return (1.0 - s - t) * rail.recess[0] + s * rail.recess[1] + t * rail.recess[2];
    }
    const WallProfile* profile(const Rail& rail, std::size_t i) const
    {
        const int wall = rail.points[i % rail.points.size()].wall;
        return wall > 0 ? &surface_.walls[static_cast<std::size_t>(wall - 1)] : nullptr;
    }
    /// The outward normal of an edge, of unit length.
    static Vector normal(const Rail& rail, std::size_t i)
    {
        double area = 0.0;
        for (std::size_t k = 0; k < rail.points.size(); ++k) area += cross(corner(rail, k), corner(rail, k + 1));
        const Vector a = corner(rail, i), b = corner(rail, i + 1);
        const double size = std::hypot(b.x - a.x, b.y - a.y) * (area > 0.0 ? 1.0 : -1.0);
        return {(b.y - a.y) / size, -(b.x - a.x) / size};
    }
    /// Where the offset lines of edges i - 1 and i meet, from their corner: those of the outer (side 1) or inner ends.
    Vector meetingPoint(const Rail& rail, std::size_t i, int side) const
    {
        const std::size_t before = i + rail.points.size() - 1;
        const auto offset = [&](const WallProfile* p) {
            if (!p) return 0.0;
            return side > 0 ? std::max(0.0, p->distance.back()) : std::min(0.0, p->distance.front());
        };
        const Vector m = normal(rail, before), n = normal(rail, i);
        const double d = offset(profile(rail, before)), e = offset(profile(rail, i)), det = cross(m, n);
        return {(d * n.y - e * m.y) / det, (m.x * e - n.x * d) / det};
    }
    std::optional<double> wall(const Rail& rail, std::size_t i, double x, double y, int side) const
    {
        const WallProfile* p = profile(rail, i);
        if (!p || rail.kind == RailKind::Ramp || rail.recess[0] >= surface_.baseRecess) return {};
        const double end = side > 0 ? p->distance.back() : p->distance.front();
        if (end * side <= 0.0) return {};
        const Vector a = corner(rail, i), b = corner(rail, i + 1), n = normal(rail, i);
        const Vector fromA{x - a.x, y - a.y}, fromB{x - b.x, y - b.y}, edge{b.x - a.x, b.y - a.y};
        const double height = dot(fromA, n);
        if (height * side < 0.0 || std::abs(height) > std::abs(end)) return {};
        // The point must be on the same side of each border as the edge.
        const Vector first = meetingPoint(rail, i, side), last = meetingPoint(rail, i + 1, side);
        if (cross(first, edge) * cross(first, fromA) < 0.0) return {};
        if (cross(last, {-edge.x, -edge.y}) * cross(last, fromB) < 0.0) return {};
        double distance = std::abs(height);
        if (dot(fromA, edge) < 0.0) distance = std::hypot(fromA.x, fromA.y);
        if (dot(fromB, edge) > 0.0) distance = std::hypot(fromB.x, fromB.y);
        distance *= side;
        for (std::size_t k = p->distance.size() - 1; k > 0; --k) {
            const double from = p->distance[k - 1], to = p->distance[k];
            if (distance >= from && distance < to)
                return p->recess[k - 1] + (p->recess[k] - p->recess[k - 1]) * (distance - from) / (to - from);
        }
        return {};
    }

    const AirBearingSurface& surface_;
};

} // namespace touchdown::test
