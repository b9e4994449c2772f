// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of the disk that a case asks for, made and measured, for its page: heights, statistics, and the spectrum
// beside the one that was asked for.
#pragma once

#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/roughness.h"
#include "core/physics/disk/surface_statistics.h"

namespace touchdown {

struct DiskSurfacePreview {
    std::string problem; // a sentence; then there is nothing else
    DiskSurface asked;
    DiskTopography topography;
    SurfaceStatistics statistics;
    ProfilePsd psd;                      // averaged, for a plot
    std::vector<RequestedPsd> requested; // at the same wave numbers; empty where no spectrum is asked for, or not alone
};

/// Takes a second for a long track. Any thread.
DiskSurfacePreview previewOf(const Case& c);

/// A piece of one period from `x0` on [m], across all of it, with at most so many cells, each the mean of the heights
/// in it where there are more points than that.
struct DiskSurfacePiece {
    CellGrid grid;
    std::vector<double> heights; // [m], row by row
};
DiskSurfacePiece pieceOf(const DiskTopography& surface, double x0, double length);

/// The length that a piece in the proportions of a picture has [m], at most the period.
double pieceLength(const DiskTopography& surface);

} // namespace touchdown
