// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_recurrence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/roughness.h"

namespace touchdown {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double sliderFrequency = 300e3; // f0: oscillations of sliders on air have 50 kHz to 1 MHz [Hz]
constexpr double steadyShare = 0.2;       // RMS deviation of a mean square that counts as steady [-]
constexpr double likeHeight = 0.8;        // of the highest place [-]
constexpr double countedDepth = 0.25;     // of the deepest pit, and likewise of a height [-]
constexpr double closeTracks = 0.25;      // of a bump's width [-]
constexpr double leastHeight = 1e-13;     // that counts, of its share that moves the slider [m]
constexpr double mostTracks = 1e6, mostPlaces = 1 << 20, mostLines = 16, mostHeights = 1e7;

double square(double x) { return x * x; }

/// The limits f0 below which a slider may follow the surface, an octave apart [Hz].
std::vector<double> limitsOf(double speed, double length)
{
    std::vector<double> limits;
    const double lowest = speed / length;
    for (double limit = sliderFrequency; limit > lowest; limit *= 0.5) limits.push_back(limit);
    limits.push_back(std::min(lowest, sliderFrequency));
    return limits;
}

/// The share of a height that a slider does not follow, of a feature that passes with this frequency [Hz].
double shareNotFollowed(double frequency, double limit)
{
    const double ratio = square(frequency / limit);
    return ratio / (1.0 + ratio);
}

struct Passage {
    double time, height; // [s], [m]
};

/// The longest time until a height like the largest comes again, and likewise a depth, of passages in their order.
double longestGap(const std::vector<Passage>& passages, double around)
{
    const auto [deepest, highest] = std::ranges::minmax(passages, {}, &Passage::height);
    const double furthest = std::max(highest.height, -deepest.height);
    if (furthest < leastHeight) return 0.0;
    double longest = 0.0;
    for (const double extreme : {highest.height, deepest.height}) {
        const double sign = extreme < 0.0 ? -1.0 : 1.0;
        if (std::abs(extreme) < countedDepth * furthest) continue;
        const Passage *first = nullptr, *last = nullptr;
        for (const Passage& passage : passages) {
            if (sign * passage.height < likeHeight * std::abs(extreme)) continue;
            if (first == nullptr)
                first = &passage;
            else
                longest = std::max(longest, passage.time - last->time);
            last = &passage;
        }
        longest = std::max(longest, first->time + around - last->time);
    }
    return longest;
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

double waitForWaves(std::vector<Tone> tones, double limit)
{
    double power = 0.0, rest = 0.0;
    for (Tone& tone : tones) power += tone.power *= square(shareNotFollowed(tone.frequency, limit));
    std::ranges::sort(tones, {}, &Tone::power);
    // The weakest, together a hundredth of all, are left out.
    std::erase_if(tones, [&](const Tone& tone) { return (rest += tone.power) < 0.01 * power; });
    if (power < 0.5 * square(leastHeight)) return 0.0;
    double time = 0.1 / std::ranges::max(tones, {}, &Tone::frequency).frequency;
    while (unsteadiness(tones, time) > steadyShare) time *= 1.1;
    return time;
}

/// The places after which the mean square of these, which repeat, is steady: by sums up to each place.
double steadyAfter(const std::vector<double>& heights)
{
    const std::size_t count = heights.size();
    std::vector<double> sums(2 * count + 1);
    for (std::size_t i = 0; i < 2 * count; ++i) sums[i + 1] = sums[i] + square(heights[i % count]);
    const double mean = sums[count] / double(count);
    for (double length = 2.0; length < double(count); length = std::ceil(1.1 * length)) {
        const auto places = static_cast<std::size_t>(length), apart = places / 16 + 1; // begins that overlap enough
        double squares = 0.0, begins = 0.0;
        for (std::size_t i = 0; i < count; i += apart, ++begins)
            squares += square((sums[i + places] - sums[i]) / length - mean);
        if (squares <= square(steadyShare * mean) * begins) return length;
    }
    return double(count);
}

/// The heights above the local mean over a number of places, the path being closed.
std::vector<double> aboveLocalMean(const std::vector<double>& heights, double places)
{
    const std::size_t count = heights.size(), reach = std::min(std::size_t(0.5 * places), (count - 1) / 2);
    if (reach == 0) return heights;
    std::vector<double> above(count);
    double sum = 0.0;
    for (std::size_t i = 0; i < 2 * reach + 1; ++i) sum += heights[i];
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t middle = (i + reach) % count;
        above[middle] = heights[middle] - sum / double(2 * reach + 1);
        sum += heights[(i + 2 * reach + 1) % count] - heights[i];
    }
    return above;
}

/// Of a map with these points, along lines of the strip: over all of the path until its tracks are dense.
double waitForMap(const DiskTopography& topography, const UniformGrid& map, const Velocity& velocity,
                  const DiskStrip& strip, const std::vector<double>& limits)
{
    const bool askew = map.ny > 1 && velocity.y != 0.0;
    const double track = map.nx * map.dx, width = map.ny * map.dy;
    if (velocity.x == 0.0) return askew ? periodOf(width, velocity.y) : 0.0;
    const double apart = 2.0 * map.dy + (strip.outer - strip.inner);
    const double tracks = askew ? tracksUntilDense(track * velocity.y / velocity.x, width, apart) : 1.0;
    const double across = map.ny > 1 ? std::min(strip.outer - strip.inner, width) : 0.0;
    // The whole path has priority over further lines.
    const double most = std::min(mostLines - 1.0, across / (2.0 * map.dy)),
                 lines = 1.0 + std::floor(std::clamp(mostPlaces / (tracks * map.nx) - 1.0, 0.0, most));
    const auto count = std::size_t(std::clamp(tracks * map.nx, 1.0, mostPlaces / lines));
    const double interval = map.dx / std::abs(velocity.x), slope = askew ? velocity.y / velocity.x : 0.0;
    std::vector<std::vector<double>> heights; // the first line is the middle of the strip
    for (double line = 0.0; line < lines; ++line) {
        const double y = 0.5 * (strip.inner + strip.outer) + across * std::remainder(line / lines, 1.0);
        std::vector<double>& each = heights.emplace_back(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double x = double(i) * map.dx;
            each[i] = topography.height(x, y + slope * x);
        }
    }
    std::vector<Passage> passages(2 * count); // at each place the highest of the lines and the deepest
    double longest = 0.0;
    for (const double limit : limits) {
        double steady = 0.0;
        for (const std::vector<double>& each : heights) {
            const std::vector<double> above = aboveLocalMean(each, 1.0 / (limit * interval));
            const bool first = &each == &heights.front();
            if (first) steady = steadyAfter(above) * interval;
            for (std::size_t i = 0; i < count; ++i) {
                Passage &high = passages[2 * i], &deep = passages[2 * i + 1];
                high = {double(i) * interval, first ? above[i] : std::max(high.height, above[i])};
                deep = {double(i) * interval, first ? above[i] : std::min(deep.height, above[i])};
            }
        }
        const double gap = longestGap(passages, double(count) * interval);
        if (gap > 0.0) longest = std::max({longest, gap, steady});
    }
    return longest;
}

double waitForBumps(const DiskSurface& surface, const Velocity& velocity, const DiskStrip& strip,
                    const std::vector<double>& limits)
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
    struct BumpPassage {
        double time, height, frequency; // [s], [m], [Hz]
    };
    std::vector<BumpPassage> passages;
    for (std::size_t i = 0; i < widths.size(); ++i)
        for (double k = 0.0; k < tracks; ++k) {
            // The middle of the strip is over (x, y) = (0, middle) at the start and moves against the disk.
            const double behind = surface.bumpX[i] - surface.track * std::ceil(surface.bumpX[i] / surface.track);
            const double x = behind - k * surface.track; // <= 0
            const double y = middle + slope * x;
            const double beside = std::remainder(y - surface.bumpY[i], surface.trackWidth);
            const double off = std::copysign(std::max(0.0, std::abs(beside) - reach), beside);
            passages.push_back({-x / std::abs(velocity.x), bumps.height(surface.bumpX[i], surface.bumpY[i] + off),
                                std::abs(velocity.x) / surface.bumpLengths[i]});
        }
    std::ranges::sort(passages, {}, &BumpPassage::time);
    std::vector<Passage> left(passages.size()); // what the slider does not follow
    double longest = 0.0;
    for (const double limit : limits) {
        std::ranges::transform(passages, left.begin(), [limit](const BumpPassage& each) {
            return Passage{each.time, each.height * shareNotFollowed(each.frequency, limit)};
        });
        longest = std::max(longest, longestGap(left, tracks * turn));
    }
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
    const double speed = std::hypot(velocity.x, velocity.y);
    if (speed == 0.0) return found;
    const std::vector<double> limits = limitsOf(speed, strip.length);
    std::vector<double> periods;
    const auto wait = [&](double time) {
        if (std::isfinite(time)) found.wait = std::max(found.wait, time);
    };
    if (hasWaves(surface)) {
        std::vector<Tone> tones;
        for (std::size_t i = 0; i < surface.waveLengths.size(); ++i) {
            const double angle = surface.waveAngles.empty() ? 0.0 : surface.waveAngles[i];
            const double passing = std::abs(velocity.x * std::cos(angle) + velocity.y * std::sin(angle));
            // A wave across the track that does not pass: cos 90 degrees is not exactly zero.
            if (passing < 1e-9 * speed) continue;
            tones.push_back({0.5 * square(surface.waveAmplitudes[i]), passing / surface.waveLengths[i]});
            periods.push_back(1.0 / tones.back().frequency);
        }
        for (const double limit : limits) wait(waitForWaves(tones, limit));
    }
    const auto repeats = [&](double along, double across) {
        periods.push_back(periodOf(along, velocity.x));
        periods.push_back(periodOf(across, velocity.y));
    };
    if (hasRoughness(surface) && surface.rms > 0.0) {
        const UniformGrid map{
            .nx = mapColumns(surface), .ny = mapRows(surface), .dx = surface.cell, .dy = surface.cell};
        wait(waitForMap(topography, map, velocity, strip, limits));
        repeats(surface.track, surface.trackWidth);
    }
    if (hasFile(surface)) {
        const UniformGrid map = topography.period();
        wait(waitForMap(topography, map, velocity, strip, limits));
        repeats(map.nx * map.dx, map.ny > 1 ? map.ny * map.dy : infinity);
    }
    if (hasBumps(surface)) {
        wait(waitForBumps(surface, velocity, strip, limits));
        repeats(surface.track, surface.trackWidth);
    }
    if (found.moves()) found.period = commonPeriod(std::move(periods));
    return found;
}

} // namespace touchdown
