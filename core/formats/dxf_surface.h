// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface as a drawing of the CAD format DXF (AutoCAD 2000), and rails from the outlines of a drawing.
//
// Millimetres, x from the leading edge, y from the inner edge. The border of the slider and each rail are one closed
// polyline on a layer of their own, whose name tells the recess: "slider base 2500 nm", "rail 1 recess 0 nm",
// "rail 2 ramp 0 1500 0 nm". A drawing has no walls, crown, camber, twist or taper.
#pragma once

#include <string>
#include <vector>

#include "core/formats/dxf_drawing.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// The text of a file; `length` and `width` of the slider [m]. Throws std::runtime_error where the system gives no
/// memory for it.
std::string dxfText(const AirBearingSurface& surface, double length, double width);

/// A sentence about what this surface has and a drawing has not, or "".
std::string lostInDrawing(const AirBearingSurface& surface);

struct DrawnRails {
    std::vector<Rail> rails;
    bool tooManyOpenLines = false; // more than 5000: they were not joined to outlines
};

/// Each closed outline as a step with vertical edges, or the ramp that its layer tells; a recess that no layer tells,
/// or of more than 1 m, is zero. The border of the slider is left out, unless its layer tells a rail. Lines and arcs on
/// one layer whose ends meet are one outline. `paths` in m on a slider of this length and width [m].
DrawnRails railsOfDrawing(const std::vector<DrawnPath>& paths, double length, double width);

} // namespace touchdown
