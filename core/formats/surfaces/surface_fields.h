// SPDX-License-Identifier: GPL-3.0-or-later
//
// Heights on equally spaced points whose file describes itself.
//
//   GSF, Gwyddion Simple Field 1.0   lines "XRes = 80", XReal, YReal, XYUnits, ZUnits; zero bytes up to a multiple of
//                                    four; XRes * YRes floats, low byte first
//   SDF, ISO 25178-71, as text       "aBCR-1.0" or "aISO-1.0"; lines "NumPoints = 80", NumProfiles, Xscale, Yscale,
//                                    Zscale in m; "*"; integers or decimals, each times Zscale a height; "*"
//
// Both become the lines of a matrix (core/formats/surfaces/header_values.h).
#pragma once

#include <string_view>

#include "core/formats/surfaces/map_table.h"

namespace touchdown {

bool isSimpleField(std::string_view bytes);
bool isSdf(std::string_view text);

/// Throws CmlError where the bytes are cut off or a point is missing.
MapTable readSimpleField(std::string_view bytes);
MapTable readSdf(std::string_view text);

} // namespace touchdown
