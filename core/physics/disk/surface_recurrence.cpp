// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_recurrence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double sliderFrequency = 300e3;          // f0: oscillations of sliders on air have 50 kHz to 1 MHz [Hz]
constexpr double steadyShare = 0.2;                // RMS deviation of a mean square that counts as steady [-]
constexpr double strongBump = 0.6, farPlace = 0.8; // of the largest one [-]
constexpr double closeTracks = 0.25;               // of a bump's width [-]
constexpr double leastHeight = 1e-13;              // that counts, of its share that moves the slider [m]
constexpr double mostTracks = 1e6, mostPlaces = 1 << 20, mostHeights = 1e7;

double square(double x) { return x * x; }

/// The share of a height that moves the slider, of a feature that passes with this frequency [Hz].
double sliderShare(double frequency)
{
    const double ratio = square(frequency / sliderFrequency);
    return ratio / (1.0 + ratio);
}

double periodOf(double length, double speed) { return speed != 0.0 ? length / std::abs(speed) : infinity; }

/// The first multiple of the longest period that is one of all; periods without end stand still and do not count.
double commonPeriod(std::vector<double> periods)
{
    std::erase_if(periods, [](double period) { return !std::isfinite(period); });
    if (periods.empty()) return 0.0;
    const double longest = *std::ranges::max_element(periods);
    for (int n = 1; n <= 1000; ++n) {
        const auto fits = [&](double period) {
            const double count = n * longest / period;
            return std::abs(count - std::round(count)) < 1e-6;
        };
        if (std::ranges::all_of(periods, fits)) return n * longest;
    }
    return infinity;
}

struct Tone {
    double power, frequency; // [m^2], [Hz]
};

/// RMS deviation of the mean square of tones over a time T, of random phase, from its long mean [-]. Each pair of tones
/// adds a product at their difference and one at their sum, whose mean over T is at most 1/(pi f T) of its amplitude.
double unsteadiness(const std::vector<Tone>& tones, double time)
{
    const auto left = [time](double frequency) {
        const double turns = std::numbers::pi * frequency * time;
        return turns > 1.0 ? 1.0 / square(turns) : 1.0;
    };
    double sum = 0.0, power = 0.0;
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const auto& [p, f] = tones[i];
        power += p;
        sum += 0.5 * square(p) * left(2.0 * f);
        for (std::size_t j = 0; j < i; ++j) {
            const double apart = std::abs(f - tones[j].frequency);
            const double beat = apart > 1e-9 * f ? left(apart) : 0.0; // of one frequency: a single wave
            sum += 2.0 * p * tones[j].power * (beat + left(f + tones[j].frequency));
        }
    }
    return std::sqrt(sum) / power;
}

double waitForWaves(std::vector<Tone> tones)
{
    double power = 0.0, rest = 0.0;
    for (Tone& tone : tones) power += tone.power *= square(sliderShare(tone.frequency));
    std::ranges::sort(tones, {}, &Tone::power);
    // The weakest, together a hundredth of all, are left out.
    std::erase_if(tones, [&](const Tone& tone) { return (rest += tone.power) < 0.01 * power; });
    if (power < 0.5 * square(leastHeight)) return 0.0;
    double time = 0.1 / std::ranges::max(tones, {}, &Tone::frequency).frequency;
    while (unsteadiness(tones, time) > steadyShare) time *= 1.1;
    return time;
}

double waitForRoughness(const DiskSurface& surface, const Velocity& velocity)
{
    double integral = 0.0; // I [m]
    switch (surface.spectrum) {
    case RoughnessSpectrum::Gaussian: integral = std::sqrt(0.5 * std::numbers::pi) * surface.correlationLength; break;
    case RoughnessSpectrum::Exponential: integral = surface.correlationLength; break;
    case RoughnessSpectrum::SelfAffine: integral = 0.5 * surface.rollOff; break; // of a flat spectrum
    }
    const double path = 2.0 * integral / square(steadyShare);
    const double period = velocity.y == 0.0 ? periodOf(surface.track, velocity.x) : infinity;
    return std::min(path / std::hypot(velocity.x, velocity.y), period);
}

/// The places after which the mean square of these, which repeat, is steady: by sums up to each place.
double steadyAfter(const std::vector<double>& heights)
{
    const std::size_t count = heights.size();
    std::vector<double> sums(2 * count + 1);
    for (std::size_t i = 0; i < 2 * count; ++i) sums[i + 1] = sums[i] + square(heights[i % count]);
    const double mean = sums[count] / double(count);
    for (double length = 2.0; length < double(count); length = std::ceil(1.1 * length)) {
        const auto places = static_cast<std::size_t>(length);
        double squares = 0.0;
        for (std::size_t i = 0; i < count; ++i) squares += square((sums[i + places] - sums[i]) / length - mean);
        if (squares <= square(steadyShare * mean) * double(count)) return length;
    }
    return double(count);
}

/// Along the middle of the strip. The local mean is that over the time 1/f0.
double waitForFile(const DiskTopography& topography, const Velocity& velocity, double y)
{
    const UniformGrid grid = topography.period();
    const bool askew = grid.ny > 1 && velocity.y != 0.0;
    const double track = grid.nx * grid.dx, width = grid.ny * grid.dy;
    if (velocity.x == 0.0) return askew ? periodOf(width, velocity.y) : 0.0;
    const double tracks = askew ? tracksUntilDense(track * velocity.y / velocity.x, width, 2.0 * grid.dy) : 1.0;
    const auto count = std::size_t(std::clamp(tracks * grid.nx, 1.0, mostPlaces));
    const double interval = grid.dx / std::abs(velocity.x);
    const double slope = askew ? velocity.y / velocity.x : 0.0;
    std::vector<double> heights(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = double(i) * grid.dx;
        heights[i] = topography.height(x, y + slope * x);
    }
    const auto reach = std::min(std::size_t(0.5 / (sliderFrequency * interval)), (count - 1) / 2);
    if (reach > 0) {
        std::vector<double> local(count);
        double sum = 0.0;
        for (std::size_t i = 0; i < 2 * reach + 1; ++i) sum += heights[i];
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t middle = (i + reach) % count;
            local[middle] = heights[middle] - sum / double(2 * reach + 1);
            sum += heights[(i + 2 * reach + 1) % count] - heights[i];
        }
        heights.swap(local);
    }
    const double steady = steadyAfter(heights) * interval;
    const auto [least, most] = std::ranges::minmax(heights);
    const double furthest = std::max(most, -least);
    if (furthest < leastHeight) return 0.0;
    std::size_t first = count, last = 0, longest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (std::abs(heights[i]) < farPlace * furthest) continue;
        if (first == count)
            first = i;
        else
            longest = std::max(longest, i - last);
        last = i;
    }
    longest = std::max(longest, first + count - last);
    return std::max(steady, double(std::min(count, longest + 2 * reach)) * interval);
}

double waitForBumps(const DiskSurface& surface, const Velocity& velocity, const DiskStrip& strip)
{
    if (velocity.x == 0.0) return periodOf(surface.trackWidth, velocity.y);
    const Bumps bumps(surface);
    const auto& widths = surface.bumpWidths.empty() ? surface.bumpLengths : surface.bumpWidths;
    const double reach = 0.5 * (strip.outer - strip.inner), middle = 0.5 * (strip.outer + strip.inner);
    const double slope = velocity.y / velocity.x, turn = periodOf(surface.track, velocity.x);
    double tracks = 1.0;
    if (velocity.y != 0.0)
        for (const double width : widths)
            tracks = std::max(
                tracks, tracksUntilDense(surface.track * slope, surface.trackWidth, closeTracks * width + 2.0 * reach));
    if (tracks > 1.0 && tracks * square(double(widths.size())) > mostHeights) return tracks * turn;
    struct Passage {
        double time, strength; // [s], [m]
    };
    std::vector<Passage> passages;
    for (std::size_t i = 0; i < widths.size(); ++i)
        for (double k = 0.0; k < tracks; ++k) {
            // The middle of the strip is over (x, y) = (0, middle) at the start and moves against the disk.
            const double behind = surface.bumpX[i] - surface.track * std::ceil(surface.bumpX[i] / surface.track);
            const double x = behind - k * surface.track; // <= 0
            const double y = middle + slope * x;
            const double beside = std::remainder(y - surface.bumpY[i], surface.trackWidth);
            const double off = std::copysign(std::max(0.0, std::abs(beside) - reach), beside);
            const double height = bumps.height(surface.bumpX[i], surface.bumpY[i] + off);
            passages.push_back({-x / std::abs(velocity.x),
                                std::abs(height) * sliderShare(std::abs(velocity.x) / surface.bumpLengths[i])});
        }
    const double strongest = std::ranges::max(passages, {}, &Passage::strength).strength;
    if (strongest < leastHeight) return 0.0;
    std::erase_if(passages, [&](const Passage& passage) { return passage.strength < strongBump * strongest; });
    std::ranges::sort(passages, {}, &Passage::time);
    double longest = passages.front().time + tracks * turn - passages.back().time;
    for (std::size_t i = 1; i < passages.size(); ++i)
        longest = std::max(longest, passages[i].time - passages[i - 1].time);
    return longest;
}

} // namespace

double tracksUntilDense(double shift, double around, double apart)
{
    // The tracks lie one behind the other by turns of `shift`. Two lengths share the circle, the longer of which the
    // next tracks divide by the shorter: Euclid's algorithm on the two, with the number of tracks to each.
    double above = std::abs(std::remainder(shift, around)), below = around - above;
    if (below <= apart || above <= 1e-12 * around) return 1.0;
    double tracksAbove = 1.0, tracksBelow = 1.0;
    while (std::max(above, below) > apart && std::min(above, below) > 1e-12 * around &&
           tracksAbove + tracksBelow < mostTracks) {
        if (above < below) {
            below -= above;
            tracksBelow += tracksAbove;
        } else {
            above -= below;
            tracksAbove += tracksBelow;
        }
    }
    if (std::min(above, below) <= 1e-12 * around) return above < below ? tracksAbove : tracksBelow; // it has closed
    return std::min(tracksAbove + tracksBelow, mostTracks);
}

SurfaceRecurrence surfaceRecurrence(const DiskSurface& surface, const DiskTopography& topography,
                                    const Velocity& velocity, const DiskStrip& strip)
{
    SurfaceRecurrence found;
    if (velocity.x == 0.0 && velocity.y == 0.0) return found;
    std::vector<double> periods;
    const auto wait = [&](double time) {
        if (std::isfinite(time)) found.wait = std::max(found.wait, time);
    };
    if (hasWaves(surface)) {
        std::vector<Tone> tones;
        for (std::size_t i = 0; i < surface.waveLengths.size(); ++i) {
            const double angle = surface.waveAngles.empty() ? 0.0 : surface.waveAngles[i];
            const double speed = std::abs(velocity.x * std::cos(angle) + velocity.y * std::sin(angle));
            // A wave across the track that does not pass: cos 90 degrees is not exactly zero.
            if (speed < 1e-9 * std::hypot(velocity.x, velocity.y)) continue;
            tones.push_back({0.5 * square(surface.waveAmplitudes[i]), speed / surface.waveLengths[i]});
            periods.push_back(1.0 / tones.back().frequency);
        }
        wait(waitForWaves(std::move(tones)));
    }
    const auto repeats = [&](double along, double across) {
        periods.push_back(periodOf(along, velocity.x));
        periods.push_back(periodOf(across, velocity.y));
    };
    if (hasRoughness(surface) && surface.rms > 0.0) {
        wait(waitForRoughness(surface, velocity));
        repeats(surface.track, surface.trackWidth);
    }
    if (hasFile(surface)) {
        const UniformGrid grid = topography.period();
        wait(waitForFile(topography, velocity, 0.5 * (strip.inner + strip.outer)));
        repeats(grid.nx * grid.dx, grid.ny > 1 ? grid.ny * grid.dy : infinity);
    }
    if (hasBumps(surface)) {
        wait(waitForBumps(surface, velocity, strip));
        repeats(surface.track, surface.trackWidth);
    }
    if (found.moves()) found.period = commonPeriod(std::move(periods));
    return found;
}

} // namespace touchdown
