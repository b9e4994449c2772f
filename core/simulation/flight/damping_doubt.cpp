// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/damping_doubt.h"

#include <algorithm>
#include <cmath>

#include "core/case/case.h"
#include "core/formats/units.h"
#include "core/numerics/spectrum.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/disk_velocity.h"

namespace touchdown {

namespace {

constexpr double largeShare = 0.1;     // of the largest peak
constexpr double oftenUnfitted = 0.1;  // of a run's time
constexpr double enoughPerPeriod = 60; // steps with which BDF2OPT keeps a damping ratio to a twentieth or 5e-5

std::string kilohertz(double frequency) { return std::to_string(std::lround(frequency / 1e3)) + " kHz"; }

constexpr double sameFrequency = 0.03;
constexpr int harmonics = 3;

/// A motion that the waves of a moving disk force, and its harmonics: its size does not hang on damping.
bool isForced(const Case& c, double frequency, double duration)
{
    const DiskSurface& surface = c.diskSurface;
    if (!hasWaves(surface) || surface.motion != SurfaceMotion::Moving) return false;
    const Velocity velocity =
        diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width);
    const double same = std::max(sameFrequency * frequency, 1.0 / duration); // a spectrum tells no closer ones apart
    for (std::size_t k = 0; k < surface.waveLengths.size(); ++k) {
        if (surface.waveAmplitudes[k] == 0.0) continue;
        const double angle = surface.waveAngles.empty() ? 0.0 : surface.waveAngles[k];
        const double passing =
            std::abs(velocity.x * std::cos(angle) + velocity.y * std::sin(angle)) / surface.waveLengths[k];
        const double order = std::clamp(std::round(frequency / passing), 1.0, double{harmonics});
        if (std::abs(frequency - order * passing) <= same) return true;
    }
    return false;
}

std::string doubtOnSteps(const Case& c, double frequency, const UnfittedSteps& unfitted, double duration)
{
    const double perPeriod = static_cast<double>(unfitted.count) / (unfitted.time * frequency);
    if (!(unfitted.time > oftenUnfitted * duration) || perPeriod >= enoughPerPeriod) return {};
    const bool staggered = c.film.coupling == FilmCoupling::Staggered, fixed = c.run.steps == StepControl::Fixed;
    const std::string shorter = fewDigitsOfTime(1.0 / (enoughPerPeriod * frequency), 2);
    return "the steps in time change the damping of the motion at " + kilohertz(frequency) + ": in " +
           std::to_string(std::lround(100.0 * unfitted.time / duration)) + " % of the run there were " +
           std::to_string(std::lround(perPeriod)) + " steps a period, not fitted to it; " +
           (staggered ? "film.coupling = \"monolithic\" fits them, or "
            : fixed   ? "run.steps = \"adaptive\" fits them, or "
                      : "those that differ from the last one by more than a quarter are not; ") +
           "fixed steps of " + shorter + " are short enough";
}

} // namespace

std::vector<std::string> doubtsOnDamping(const Case& c, const std::vector<Peak>& peaks, double resolved,
                                         const UnfittedSteps& unfitted, double duration)
{
    std::vector<std::string> doubts;
    if (peaks.empty()) return doubts;
    double fastest = 0.0;
    for (const Peak& peak : peaks)
        if (peak.amplitude >= largeShare * peaks.front().amplitude && !isForced(c, peak.frequency, duration))
            fastest = std::max(fastest, peak.frequency);
    if (fastest > resolved && resolved > 0.0) // a disk at rest carries no waves
        doubts.push_back("the damping of the motion at " + kilohertz(fastest) + " depends on the grid: above " +
                         kilohertz(resolved) +
                         " a wave that the air carries along the slider spans fewer than six cells; the modes of the "
                         "case state the error of this grid, and more film.nodes along the slider make it smaller");
    if (fastest == 0.0) return doubts;
    if (std::string doubt = doubtOnSteps(c, fastest, unfitted, duration); !doubt.empty())
        doubts.push_back(std::move(doubt));
    return doubts;
}

} // namespace touchdown
