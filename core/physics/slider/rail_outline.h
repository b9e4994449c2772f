// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outline of a rail, sorted into strips of equal width across y, so that a point is compared with few edges. A
// point on an edge or a corner is inside: exactly on edges parallel to an axis, to the rounding of the cross product on
// others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// A box on the slider.
struct SurfaceBox {
    double x0, x1, y0, y1; // ends included [m]

    double centreX() const { return 0.5 * (x0 + x1); }
    double centreY() const { return 0.5 * (y0 + y1); }
    double halfX() const { return 0.5 * (x1 - x0); }
    double halfY() const { return 0.5 * (y1 - y0); }
};

enum class ScanAxis { X, Y };

/// A line across the slider from `from` to `to` along one axis, the other coordinate fixed.
struct ScanLine {
    ScanAxis along;
    double fixed;    // the other coordinate [m]
    double from, to; // [m]

    /// The component along the line of (x, y), and the one across it.
    double runs(double x, double y) const { return along == ScanAxis::X ? x : y; }
    double stays(double x, double y) const { return along == ScanAxis::X ? y : x; }
};

/// An edge, turned so that it runs towards larger y.
struct OutlineEdge {
    double x, y;       // the lower end [m]
    double dx, dy;     // to the upper end, dy >= 0 [m]
    double xMin, xMax; // [m]
    double yMax;       // [m]

    bool meets(const SurfaceBox& box) const;
};

class RailOutline {
public:
    /// `strips` of equal width from y = 0 to y = `width` [m]; the first and the last extend to infinity.
    RailOutline(const std::vector<RailPoint>& points, int strips, double width);

    bool contains(double x, double y) const { return contains(x, y, edges(strip(y))); }
    std::span<const OutlineEdge> edges(int strip) const;
    const SurfaceBox& bounds() const { return bounds_; }

    /// Appends where the outline crosses the line.
    void breaks(const ScanLine& line, int strip, std::vector<double>& out) const;

private:
    int strip(double y) const;
    static bool contains(double x, double y, std::span<const OutlineEdge> edges);

    double stripsPerMetre_;
    int strips_;
    SurfaceBox bounds_{};
    std::vector<std::uint32_t> first_; // of each strip in edges_; one more for the end
    std::vector<OutlineEdge> edges_;
};

/// The points without repetitions of the one before, the wall of the last one kept: the edge that has a length.
std::vector<RailPoint> withoutRepetitions(const std::vector<RailPoint>& points);
/// Positive when the points run anticlockwise, x to the right and y up [m^2].
double signedArea(const std::vector<RailPoint>& points);

} // namespace touchdown
