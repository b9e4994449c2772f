// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rails, walls, relations and points of interest as TOML; core/case_files/surface_text.h reads them.
#pragma once

#include "core/physics/slider/air_bearing_surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// A key of a rail, a wall or a relation with its value as TOML, which may take several lines.
struct SurfaceRow {
    std::string key;
    std::string value;
};
std::vector<SurfaceRow> surfaceRows(const Rail& rail);
std::vector<SurfaceRow> surfaceRows(const WallProfile& wall);
std::vector<SurfaceRow> surfaceRows(const KeptDistance& distance);
std::vector<SurfaceRow> surfaceRows(const KeptSymmetry& symmetry);
/// The value of abs.points_of_interest.
std::string interestText(const std::vector<SurfacePoint>& points);
/// The whole surface, for the end of [abs].
std::string formatSurface(const AirBearingSurface& surface);
/// A table "[[abs.rail]]", "[[abs.wall]]", "[[abs.distance]]" or "[[abs.symmetric]]" with its rows.
std::string surfaceTable(std::string_view name, const std::vector<SurfaceRow>& rows);

} // namespace touchdown
