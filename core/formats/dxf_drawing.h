// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of a drawing of the CAD format DXF (text, any version): lines, polylines with bulges, arcs and circles.
// Arcs are cut into straight pieces of at most 4 degrees, which lie within 0.0006 of the radius of them.
//
// The library (dxflib) trusts a file, so a second process reads it (core/formats/reader_process.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/formats/passed_values.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

struct DrawnPath {
    std::string layer;
    bool closed = false;              // the last point leads to the first
    std::vector<SurfacePoint> points; // two or more, in units of the drawing
};

struct Drawing {
    std::vector<DrawnPath> paths;
    double unit = 0.0;   // length of a unit of the drawing [m]; 0: the file does not tell
    std::string remark;  // what it holds beside, in a sentence: "3 texts and 1 block are not shown."; or ""
    std::string problem; // why there is no drawing, in a sentence without the name of the file; else ""
};

/// Never throws.
Drawing readDxf(const std::filesystem::path& file);
/// The same in this process.
Drawing readDxfDirectly(const std::filesystem::path& file);

void pass(auto& stream, Passed<DrawnPath> auto& path) { stream(path.layer, path.closed, path.points); }
void pass(auto& stream, Passed<Drawing> auto& drawing)
{
    stream(drawing.paths, drawing.unit, drawing.remark, drawing.problem);
}

} // namespace touchdown
