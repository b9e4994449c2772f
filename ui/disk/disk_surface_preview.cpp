// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/disk/disk_surface_preview.h"

#include <algorithm>
#include <cmath>

#include "core/case/disk_setup.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/surface_recurrence.h"
#include "core/simulation/contact/disk_under_film.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

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
    for (const InputProblem& problem : checkDiskFile(c).problems) {
        made.problem = "The file " + problem.file + (problem.line > 0 ? ", line " + std::to_string(problem.line) : "") +
                       ": " + problem.message;
        return made;
    }
    made.topography = diskTopography(c);
    if (made.topography.flat()) return made;
    made.statistics = surfaceStatistics(c.diskSurface, made.topography);
    if (c.model != ModelKind::Contact) {
        const double middle = 0.5 * c.slider.width;
        DiskStrip strip{middle, middle, c.slider.length};
        if (c.model == ModelKind::Film) strip = {0.0, c.slider.width, c.slider.length};
        made.repeat =
            surfaceRecurrence(c.diskSurface, made.topography, surfaceVelocity(c, made.topography), strip).period;
    }
    made.psd = averaged(made.statistics.psd, perDecade);
    const bool rough =
        hasRoughness(c.diskSurface) && !hasWaves(c.diskSurface) && !hasFile(c.diskSurface) && !hasBumps(c.diskSurface);
    if (!rough) return made;
    // Averaged over the same bins: where the spectrum falls steeply, the mean of a bin is not its value in the middle.
    ProfilePsd asked = made.statistics.psd;
    const RequestedSpectrum request(c.diskSurface);
    for (std::size_t i = 0; i < asked.density.size(); ++i)
        asked.density[i] = request.profile(asked.waveNumber[i]).density;
    asked = averaged(asked, perDecade);
    double low = 0.0, high = 0.0; // against the density [-]
    for (std::size_t i = 0; i < asked.density.size(); ++i) {
        // The density may be zero in the middle of the bin at the cutoff: this bin takes the band of the one before.
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

std::vector<QStringList> diskStatistics(const DiskSurfacePreview& preview, const QLocale& locale)
{
    const SurfaceStatistics& s = preview.statistics;
    const DiskSurface& asked = preview.asked;
    const bool rough = !preview.requested.empty(); // and nothing else, so that the request is that of the whole
    const bool byLength = rough && asked.spectrum != RoughnessSpectrum::SelfAffine;
    const auto nanometres = [&locale](double value) { return readout(value, "nm", 4, locale); };
    const auto length = [&locale](double value) { return trackText(value, locale); };
    const auto shape = [&locale](double value) {
        if (std::isnan(value)) return tr("not known");
        return trueMinus(locale.toString(std::abs(value) < 5e-4 ? 0.0 : value, 'f', 3));
    };
    const auto slope = [&locale](double value) { return locale.toString(value, 'g', 3); };
    const UniformGrid period = preview.topography.period(), measured = preview.topography.measured();
    std::vector<QStringList> rows{
        {tr("RMS height"), nanometres(s.rms), rough ? nanometres(asked.rms) : QString()},
        {tr("Skewness"), shape(s.skewness), rough ? QStringLiteral("0") : QString()},
        {tr("Kurtosis"), shape(s.kurtosis), rough ? QStringLiteral("3") : QString()},
        {tr("RMS slope, x"), slope(s.slopeX), {}},
        {tr("RMS slope, y"), slope(s.slopeY), {}},
        {tr("Correlation"), s.correlationLength > 0.0 ? length(s.correlationLength) : QStringLiteral("–"),
         byLength ? length(asked.correlationLength) : QString()},
        {tr("Highest point"), (s.boundsAlone ? QStringLiteral("≤ ") : QString()) + nanometres(s.maximum), {}},
        {tr("Lowest point"), (s.boundsAlone ? QStringLiteral("≥ ") : QString()) + nanometres(s.minimum), {}},
        {tr("Track"), length(period.nx * period.dx), {}},
        {tr("Points"),
         period.ny > 1 ? QStringLiteral("%1 × %2").arg(measured.nx).arg(measured.ny) : QString::number(measured.nx),
         {}},
    };
    if (period.ny == 1) rows.erase(rows.begin() + 4); // a profile has no slope across
    if (preview.repeat > 0.0)
        rows.push_back(
            {tr("Repeats"), std::isfinite(preview.repeat) ? timeText(preview.repeat, locale) : tr("not known"), {}});
    if (rough && asked.seed >= 0) rows.push_back({tr("Seed"), QString::number(asked.seed), {}});
    return rows;
}

QString trackText(double metres, const QLocale& locale)
{
    if (metres == 0.0) return QStringLiteral("0");
    if (metres < 0.9999995e-3) return lengthText(metres, 4, locale);
    return locale.toString(metres / 1e-3, 'g', 5) + QChar(0x00A0) + QStringLiteral("mm");
}

} // namespace touchdown
