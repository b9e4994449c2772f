// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of the disk that a case asks for, made and measured for its page: heights, statistics, and the spectrum
// beside the requested one.
#pragma once

#include <string>
#include <vector>

#include <QLocale>
#include <QStringList>

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
    ProfilePsd psd;      // averaged, for a plot
    double repeat = 0.0; // time after which the surface repeats under the slider [s]; infinite: not known; 0: it rests
    std::vector<RequestedPsd> requested; // at the same wave numbers; empty unless the surface is roughness alone
};

/// Takes a second for a long track; may be called on any thread.
DiskSurfacePreview previewOf(const Case& c);

/// A piece of one period from `x0` on [m], across all of it, with at most so many cells, each the mean of the heights
/// in it where there are more points than that.
struct DiskSurfacePiece {
    CellGrid grid;
    std::vector<double> heights; // [m], row by row
};
DiskSurfacePiece pieceOf(const DiskTopography& surface, double x0, double length);

/// Rows of the table of statistics: quantity, value of this surface, requested value.
std::vector<QStringList> diskStatistics(const DiskSurfacePreview& preview, const QLocale& locale = QLocale());

/// A length along the track: "128 µm", "1 mm".
QString trackText(double metres, const QLocale& locale = QLocale());

/// The length that a piece in the proportions of a picture has [m], at most the period.
double pieceLength(const DiskTopography& surface);

} // namespace touchdown
