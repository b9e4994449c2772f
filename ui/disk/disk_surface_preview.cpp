// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/disk/disk_surface_preview.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/case/disk_setup.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

constexpr int perDecade = 12;             // points of the plotted spectrum
constexpr double mostCells = 1 << 17;     // of a piece
constexpr double proportions = 3.5;       // of a piece, length to width
constexpr double shortestInCells = 256.0; // of a piece of a narrow track

/// One period, with a width that can be drawn where there is only a profile.
UniformGrid drawnPeriod(const DiskTopography& surface)
{
    UniformGrid period = surface.period();
    if (period.ny == 1) period.dy = period.dx * std::min(period.nx, static_cast<int>(shortestInCells)) / proportions;
    return period;
}

} // namespace

DiskSurfacePreview previewOf(const Case& c)
{
    DiskSurfacePreview made;
    made.asked = c.diskSurface;
    for (const DiskSurfaceProblem& problem : diskSurfaceProblems(c.diskSurface)) {
        made.problem = "disk.surface." + problem.key + ' ' + problem.sentence;
        return made;
    }
    for (const InputProblem& problem : diskFileProblems(c)) {
        made.problem = "The file " + problem.file + (problem.line > 0 ? ", line " + std::to_string(problem.line) : "") +
                       ": " + problem.message;
        return made;
    }
    made.topography = diskTopography(c);
    if (made.topography.flat()) return made;
    made.statistics = surfaceStatistics(made.topography);
    made.psd = averaged(made.statistics.psd, perDecade);
    const bool rough =
        hasRoughness(c.diskSurface) && !hasWaves(c.diskSurface) && !hasFile(c.diskSurface) && !hasBumps(c.diskSurface);
    if (!rough) return made;
    // Averaged over the same bins: where it falls steeply, the mean of a bin is not its value in the middle.
    ProfilePsd asked = made.statistics.psd;
    const RequestedSpectrum request(c.diskSurface);
    for (std::size_t i = 0; i < asked.density.size(); ++i)
        asked.density[i] = request.profile(asked.waveNumber[i]).density;
    asked = averaged(asked, perDecade);
    double low = 0.0, high = 0.0; // against the density [-]
    for (std::size_t i = 0; i < asked.density.size(); ++i) {
        // In the middle of the bin where the spectrum is cut off there may be nothing: its band is that of the one
        // before.
        const RequestedPsd band = request.profile(asked.waveNumber[i], asked.modes[i]);
        if (band.density > 0.0) {
            low = band.low / band.density;
            high = band.high / band.density;
        }
        made.requested.push_back({asked.density[i], low * asked.density[i], high * asked.density[i]});
    }
    return made;
}

double pieceLength(const DiskTopography& surface)
{
    const UniformGrid period = drawnPeriod(surface);
    return std::min(period.nx * period.dx, std::max(proportions * period.ny * period.dy, shortestInCells * period.dx));
}

DiskSurfacePiece pieceOf(const DiskTopography& surface, double x0, double length)
{
    const UniformGrid period = drawnPeriod(surface);
    const double columns = std::max(1.0, std::round(length / period.dx));
    const double coarser = std::max(1.0, std::ceil(std::sqrt(columns * period.ny / mostCells)));
    const int nx = std::max(1, static_cast<int>(columns / coarser));
    const int ny = std::max(1, static_cast<int>(period.ny / coarser));
    const UniformGrid grid{nx, ny, length / nx, period.ny * period.dy / ny, x0, period.y0};
    DiskSurfacePiece piece;
    for (int i = 0; i <= nx; ++i) piece.grid.x.push_back(grid.x0 + i * grid.dx);
    for (int j = 0; j <= ny; ++j) piece.grid.y.push_back(grid.y0 + j * grid.dy);
    piece.heights.resize(grid.cells());
    if (coarser > 1.0)
        surface.cellMeans(piece.grid, 0.0, 0.0, piece.heights);
    else
        surface.heights(grid, 0.0, 0.0, piece.heights);
    return piece;
}

} // namespace touchdown
