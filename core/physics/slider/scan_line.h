// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes on the slider, and lines across it parallel to an axis.
#pragma once

namespace touchdown {

struct SurfaceBox {
    double x0, x1, y0, y1; // ends included [m]

    double centreX() const { return 0.5 * (x0 + x1); }
    double centreY() const { return 0.5 * (y0 + y1); }
    double halfX() const { return 0.5 * (x1 - x0); }
    double halfY() const { return 0.5 * (y1 - y0); }
};

enum class ScanAxis { X, Y };

/// From `from` to `to` along one axis, the other coordinate fixed.
struct ScanLine {
    ScanAxis along;
    double fixed;    // the other coordinate [m]
    double from, to; // [m]

    /// The component along the line of (x, y), and the one across it.
    double runs(double x, double y) const { return along == ScanAxis::X ? x : y; }
    double stays(double x, double y) const { return along == ScanAxis::X ? y : x; }
};

} // namespace touchdown
