// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the film's cells and steps know of the disk's surface. The film sees the mean over each cell: of a wave of n
// cells along one axis it keeps sin(pi/n)/(pi/n) of the height, 95 % at n = 6, 64 % at n = 2, nothing at n = 1; and the
// flow between the cells knows such waves less. Cells count by area/gap^2, as waves change a film's pressure in
// proportion to 1/gap.
//
//   waves, bumps   known by their lengths; at least six cells span a wave, or the base of a bump
//   maps           by the RMS height that means over three cells lose: half of the height of a wave of six cells
//
// Waves of zero mean and RMS height s change the mean force of a film by about 3 (s/gap)^2: what a map loses matters
// where that is above 1 %. A wave or bump matters where its height is above 1 % of the least gap, as the film answers
// to it in proportion. A step is at most a sixteenth of the time in which the shortest wave that the cells know, and
// that matters in that sense, passes: as for springs (core/physics/disk/disk_passage.h).
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/slider/attitude.h"
#include "core/physics/slider/recess.h"

namespace touchdown {

struct Case;

struct DiskOnCells {
    /// Of waves and bumps, that with the fewest cells.
    struct Feature {
        bool isWave = true;  // else a bump
        double length = 0.0; // wavelength, or base of a bump [m]
        double cells = 0.0;  // that span it
        double kept = 1.0;   // share of its height in the means over the cells
    };
    std::optional<Feature> coarsest;
    bool hasMap = false;          // generated or measured
    double rms = 0.0, lost = 0.0; // of a surface with a map; of that in waves below six cells [m]
    double sixCells = 0.0;        // the longer side of six mean cells [m]
    double leastGap = 0.0;        // of the cells, to the mean plane [m]
    double longestStep = std::numeric_limits<double>::infinity(); // that resolves what passes [s]
    std::string passing; // what that is: "waves of 3.3 um", in which `longestStep` is a 16th

    bool isResolved() const;
};

/// Recess of the case's slider; the grid's film at an attitude.
DiskOnCells diskOnCells(const Case& c, const DiskTopography& disk, const Recess& recess, const CellGrid& grid,
                        const Attitude& attitude);

/// Warnings: cells that do not resolve the surface, and steps that are longer; empty where all is resolved. `step` [s]:
/// the fixed length of the steps; zero where they follow longestStep.
std::vector<std::string> doubtsOnDisk(const DiskOnCells& disk, double step);

} // namespace touchdown
