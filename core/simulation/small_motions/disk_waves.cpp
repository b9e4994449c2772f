// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/disk_waves.h"

#include <cmath>
#include <numbers>

#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

/// Each wave of the surface alone.
std::vector<DiskSurface> singleWaves(const DiskSurface& surface)
{
    std::vector<DiskSurface> waves;
    if (surface.kind != DiskSurfaceKind::Waves || surface.motion != SurfaceMotion::Moving) return waves;
    const auto one = [](const std::vector<double>& list, std::size_t k) {
        return std::vector<double>{list.empty() ? 0.0 : list[k]};
    };
    for (std::size_t k = 0; k < surface.waveAmplitudes.size(); ++k) {
        DiskSurface& wave = waves.emplace_back(surface);
        wave.waveAmplitudes = one(surface.waveAmplitudes, k);
        wave.waveLengths = one(surface.waveLengths, k);
        wave.waveAngles = one(surface.waveAngles, k);
        wave.wavePhases = one(surface.wavePhases, k);
    }
    return waves;
}

} // namespace

std::vector<DiskWave> diskWaves(const Case& c, const FilmGaps& gaps)
{
    std::vector<DiskWave> waves;
    for (const DiskSurface& surface : singleWaves(c.diskSurface)) {
        const DiskTopography topography(surface);
        DiskUnderFilm under(c, topography, gaps.grid, gaps.pad);
        const double number = 2.0 * std::numbers::pi / surface.waveLengths[0],
                     angle = surface.waveAngles[0]; // [rad/m], [rad]
        const double omega = number * (under.velocity().x * std::cos(angle) + under.velocity().y * std::sin(angle));
        if (omega == 0.0) continue;
        DiskWave& wave = waves.emplace_back(DiskWave{.omega = omega, .real = {}, .quarter = {}});
        wave.real.resize(gaps.pad.size());
        wave.quarter.resize(gaps.pad.size());
        under.at(0.0, wave.real);
        under.at(-0.5 * std::numbers::pi / omega, wave.quarter);
    }
    return waves;
}

} // namespace touchdown
