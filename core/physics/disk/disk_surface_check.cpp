// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_surface_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/numerics/moments.h"

namespace touchdown {

namespace {

/// In shorter periods the heights at both ends are correlated.
constexpr double correlationLengthsInPeriod = 8.0;
constexpr double roughestDisk = 10e-6, farthestPoints = 1e-3; // [m]
constexpr double steepestDisk = 0.1, steepestRead = 1.0;      // rms slope [-]
/// A multiple of the cell as people write it, "1 mm" of "0.25 um", is off by rounding only.
constexpr double wholeness = 1e-6;

std::string micrometres(double length)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g um", length * 1e6);
    return text;
}

std::string slopeText(double slope)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", slope);
    return std::string("has an rms slope of ") + text +
           ", and a disk has less than 0.1: the units of x and height are swapped or wrong";
}

class Check {
public:
    explicit Check(const DiskSurface& surface) : s_(surface) {}
    std::vector<DiskSurfaceProblem> problems;

    void waves()
    {
        if (s_.waveAmplitudes.empty()) add("wave_amplitudes", "must name at least one wave");
        if (s_.waveAmplitudes.size() > mostWaves)
            add("wave_amplitudes", "must name at most " + std::to_string(mostWaves) + " waves");
        listLength("wave_lengths", s_.waveLengths, s_.waveAmplitudes, "wave_amplitudes", false);
        listLength("wave_angles", s_.waveAngles, s_.waveAmplitudes, "wave_amplitudes", true);
        listLength("wave_phases", s_.wavePhases, s_.waveAmplitudes, "wave_amplitudes", true);
        finite("wave_amplitudes", s_.waveAmplitudes);
        finite("wave_angles", s_.waveAngles);
        finite("wave_phases", s_.wavePhases);
        positive("wave_lengths", s_.waveLengths);
        sampledTrack();
    }

    void roughness()
    {
        if (!(s_.rms > 0.0) || !std::isfinite(s_.rms)) add("rms", "must be above 0 where the disk is rough");
        if (!sampledTrack()) return;
        wholeCells("track", s_.track);
        wholeCells("track_width", s_.trackWidth);
        if (s_.track / s_.cell * (s_.trackWidth / s_.cell) > mostMapPoints) {
            char count[80];
            std::snprintf(count, sizeof count, "%.0f million of them; at most %.0f million fit",
                          s_.track / s_.cell * (s_.trackWidth / s_.cell) / 1e6, mostMapPoints / 1e6);
            add("cell", std::string("must be larger, or the track shorter or narrower: the map would have ") + count);
        }
        s_.spectrum == RoughnessSpectrum::SelfAffine ? selfAffine() : correlated();
    }

    void file()
    {
        if (s_.file.empty()) add("file", "must name a profile or a map where the surface comes from a file");
    }

    void bumps()
    {
        const auto& heights = s_.bumpHeights;
        if (heights.empty()) add("bump_heights", "must name at least one bump");
        if (heights.size() > mostBumps)
            add("bump_heights", "must name at most " + std::to_string(mostBumps) + " bumps");
        listLength("bump_lengths", s_.bumpLengths, heights, "bump_heights", false);
        listLength("bump_widths", s_.bumpWidths, heights, "bump_heights", true);
        listLength("bump_x", s_.bumpX, heights, "bump_heights", false);
        listLength("bump_y", s_.bumpY, heights, "bump_heights", false);
        finite("bump_heights", heights);
        finite("bump_x", s_.bumpX);
        finite("bump_y", s_.bumpY);
        const bool sized = positive("bump_lengths", s_.bumpLengths) && positive("bump_widths", s_.bumpWidths);
        if (!sampledTrack() || !sized) return;
        fits("bump_lengths", s_.bumpLengths, s_.track, "the track");
        fits(s_.bumpWidths.empty() ? "bump_lengths" : "bump_widths",
             s_.bumpWidths.empty() ? s_.bumpLengths : s_.bumpWidths, s_.trackWidth, "track_width");
    }

private:
    void add(const std::string& key, const std::string& sentence)
    {
        const auto same = [&](const DiskSurfaceProblem& p) { return p.key == key && p.sentence == sentence; };
        if (std::ranges::none_of(problems, same)) problems.push_back({key, sentence});
    }

    bool positive(const std::string& key, double value)
    {
        if (value > 0.0 && std::isfinite(value)) return true;
        add(key, "must be above 0");
        return false;
    }
    bool positive(const std::string& key, const std::vector<double>& values)
    {
        if (std::ranges::all_of(values, [](double v) { return v > 0.0 && std::isfinite(v); })) return true;
        add(key, "must all be above 0");
        return false;
    }
    void finite(const std::string& key, const std::vector<double>& values)
    {
        if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) add(key, "must all be finite");
    }
    /// The period of the surface, or the sampled part of a surface that does not repeat.
    bool sampledTrack()
    {
        const bool along = positive("track", s_.track);
        const bool across = positive("track_width", s_.trackWidth);
        return positive("cell", s_.cell) && along && across;
    }

    void listLength(const std::string& key, const std::vector<double>& list, const std::vector<double>& leader,
                    const std::string& leaderKey, bool mayBeEmpty)
    {
        if (list.size() == leader.size() || (mayBeEmpty && list.empty())) return;
        add(key, "must be as long as " + leaderKey + (mayBeEmpty ? ", or empty" : "") + ": " +
                     std::to_string(leader.size()) + ", not " + std::to_string(list.size()));
    }

    void fits(const std::string& key, const std::vector<double>& sizes, double length, const std::string& what)
    {
        if (std::ranges::any_of(sizes, [&](double size) { return size > length; }))
            add(key, "must be at most " + micrometres(length) + ", as long as " + what + ", with which bumps repeat");
    }

    void wholeCells(const std::string& key, double length)
    {
        const double cells = length / s_.cell;
        if (cells > 1e9 || std::abs(cells - std::round(cells)) <= wholeness * std::max(1.0, cells)) return;
        add(key, "must be a whole multiple of the map's cell of " + micrometres(s_.cell) + ", for example " +
                     micrometres(std::max(1.0, std::round(cells)) * s_.cell));
    }

    void correlated()
    {
        if (!positive("correlation_length", s_.correlationLength)) return;
        if (s_.correlationLength < s_.cell * (1.0 - wholeness))
            add("correlation_length", "must be at least " + micrometres(s_.cell) + ", one cell of the map");
        const double shortest = correlationLengthsInPeriod * s_.correlationLength;
        longEnough("track", s_.track, shortest, "eight correlation lengths");
        longEnough("track_width", s_.trackWidth, shortest, "eight correlation lengths");
    }

    void selfAffine()
    {
        if (!(s_.hurst > 0.0 && s_.hurst <= 1.0)) add("hurst", "must be above 0 and at most 1");
        const bool rollOff = positive("roll_off", s_.rollOff);
        if (!positive("cut_off", s_.cutOff) || !rollOff) return;
        if (s_.cutOff < 2.0 * s_.cell * (1.0 - wholeness))
            add("cut_off", "must be at least " + micrometres(2.0 * s_.cell) + ", two cells of the map");
        if (s_.rollOff < s_.cutOff)
            add("roll_off", "must be at least " + micrometres(s_.cutOff) + ", the cut-off wavelength");
        longEnough("track", s_.track, s_.rollOff, "the roll-off wavelength");
        longEnough("track_width", s_.trackWidth, s_.rollOff, "the roll-off wavelength");
    }

    void longEnough(const std::string& key, double length, double shortest, const std::string& what)
    {
        if (length < shortest * (1.0 - wholeness)) add(key, "must be at least " + micrometres(shortest) + ", " + what);
    }

    const DiskSurface& s_;
};

bool has(const DiskSurface& s, DiskSurfaceKind kind, bool isGiven)
{
    return s.kind == kind || (s.kind == DiskSurfaceKind::Combined && isGiven);
}

} // namespace

bool hasWaves(const DiskSurface& s) { return has(s, DiskSurfaceKind::Waves, !s.waveAmplitudes.empty()); }
bool hasRoughness(const DiskSurface& s) { return has(s, DiskSurfaceKind::Rough, s.rms != 0.0); }
bool hasFile(const DiskSurface& s) { return has(s, DiskSurfaceKind::File, !s.file.empty()); }
bool hasBumps(const DiskSurface& s) { return has(s, DiskSurfaceKind::Bumps, !s.bumpHeights.empty()); }

std::vector<DiskSurfaceProblem> diskSurfaceProblems(const DiskSurface& surface)
{
    Check check(surface);
    if (hasWaves(surface)) check.waves();
    if (hasRoughness(surface)) check.roughness();
    if (hasFile(surface)) check.file();
    if (hasBumps(surface)) check.bumps();
    return check.problems;
}

double rmsSlope(const HeightMap& map)
{
    const auto nx = static_cast<std::size_t>(map.nx), ny = static_cast<std::size_t>(map.ny);
    const auto mean = [&](std::size_t columns, std::size_t rows, std::size_t next, double step) {
        double sum = 0.0;
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t i = 0; i < columns; ++i) {
                const double rise = (map.heights[j * nx + i + next] - map.heights[j * nx + i]) / step;
                sum += rise * rise;
            }
        return columns * rows > 0 ? std::sqrt(sum / static_cast<double>(columns * rows)) : 0.0;
    };
    const double along = mean(nx - 1, ny, 1, map.dx);
    return ny > 1 ? std::max(along, mean(nx, ny - 1, nx, map.dy)) : along;
}

std::vector<DiskSurfaceProblem> heightMapProblems(const HeightMap& map)
{
    if (const double slope = rmsSlope(map); slope > steepestRead) return {{"file", slopeText(slope)}};
    return {};
}

std::vector<DiskSurfaceProblem> heightMapWarnings(const HeightMap& map)
{
    std::vector<DiskSurfaceProblem> warnings;
    if (const double slope = rmsSlope(map); slope > steepestDisk) warnings.push_back({"file", slopeText(slope)});
    if (const double rms = momentsOf(map.heights).deviation; rms > roughestDisk)
        warnings.push_back({"file", "has heights with an rms of " + micrometres(rms) +
                                        ", more than a disk has; check the units of the file"});
    if (const double step = map.ny > 1 ? std::max(map.dx, map.dy) : map.dx; step > farthestPoints)
        warnings.push_back({"file", "has points " + micrometres(step) + " apart; check the units of the file"});
    return warnings;
}

} // namespace touchdown
