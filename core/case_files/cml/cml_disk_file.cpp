// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_disk_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"

namespace touchdown {

namespace {

constexpr int most = 1000; // of waves, zones or asperities
constexpr std::size_t waveNumbers = 9, zoneNumbers = 6, asperityNumbers = 7;
constexpr double degree = std::numbers::pi / 180.0;

bool isOn(CmlPart& part)
{
    const auto numbers = part.list(0);
    return !numbers.empty() && numbers.front().value != 0.0;
}

/// Position of a wave on the disk: under the whole slider, beside it, or ending under it.
enum class Cover : std::uint8_t { All, None, Part };

Cover coverOf(const Case& c, double start, double end)
{
    if (start == 0.0 && end == 0.0) return Cover::All;
    // Skew and length bring the slider's corners no farther from its centre than half its diagonal.
    const double reach = 0.5 * std::hypot(c.slider.length, c.slider.width);
    const double inner = c.disk.radius - reach, outer = c.disk.radius + reach;
    if (start <= inner && outer <= end) return Cover::All;
    return end < inner || outer < start ? Cover::None : Cover::Part;
}

/// Type, amplitude [m], angle [deg], wavelengths, sizes [m], start and end radius [m] of each.
void readWaves(CmlPart& part, std::span<const CmlNumber> numbers)
{
    std::vector<double> amplitudes, lengths, angles;
    for (std::size_t at = 0; at < numbers.size(); at += waveNumbers) {
        const auto wave = numbers.subspan(at, waveNumbers);
        const std::string name = "wave " + std::to_string(at / waveNumbers + 1);
        const Cover cover = coverOf(part.parameters().value(), wave[7].value, wave[8].value);
        if (wave[0].value != 0.0) {
            part.leaveOut(name + ", which is not a sine (type " + std::string(wave[0].text) + ")");
        } else if (!(wave[3].value > 0.0) || wave[4].value != 0.0) {
            part.leaveOut(name + ", which does not have the one wavelength x");
        } else if (cover == Cover::Part) {
            part.leaveOut(name + ", which begins or ends under the slider");
        } else if (cover == Cover::All && wave[1].value != 0.0) {
            amplitudes.push_back(wave[1].value);
            angles.push_back(wave[2].value * degree);
            lengths.push_back(wave[3].value);
        }
    }
    if (amplitudes.empty()) return;
    const int line = numbers.front().line;
    part.parameters().setNumbers("disk.surface.wave_amplitudes", amplitudes, line);
    part.parameters().setNumbers("disk.surface.wave_lengths", lengths, line);
    part.parameters().setNumbers("disk.surface.wave_angles", angles, line);
}

/// Type, amplitude [m], angle [deg], x, y, sizes x and y [m] of each.
void readAsperities(CmlPart& part, std::span<const CmlNumber> numbers)
{
    std::vector<double> heights, lengths, widths, x, y;
    double type = -1.0; // of the first that is taken
    for (std::size_t at = 0; at < numbers.size(); at += asperityNumbers) {
        const auto asperity = numbers.subspan(at, asperityNumbers);
        const std::string name = "asperity " + std::to_string(at / asperityNumbers + 1);
        const bool known = asperity[0].value == 0.0 || asperity[0].value == 1.0;
        if (!known || (type >= 0.0 && asperity[0].value != type)) {
            part.leaveOut(name + (known ? ", which has another form than the first"
                                        : ", which is neither sinusoidal nor ellipsoidal (type " +
                                              std::string(asperity[0].text) + ")"));
        } else if (asperity[2].value != 0.0 && asperity[5].value != asperity[6].value) {
            part.leaveOut(name + ", which is turned");
        } else if (!(asperity[5].value > 0.0) || !(asperity[6].value > 0.0)) {
            part.leaveOut(name + ", which has no size");
        } else {
            type = asperity[0].value;
            heights.push_back(asperity[1].value);
            x.push_back(asperity[3].value);
            y.push_back(asperity[4].value);
            lengths.push_back(asperity[5].value);
            widths.push_back(asperity[6].value);
        }
    }
    if (heights.empty()) return;
    CmlParameters& parameters = part.parameters();
    const int line = numbers.front().line;
    parameters.choose("disk.surface.bump_shape", type == 0.0 ? "cosine" : "ellipsoid", line);
    parameters.setNumbers("disk.surface.bump_heights", heights, line);
    parameters.setNumbers("disk.surface.bump_lengths", lengths, line);
    parameters.setNumbers("disk.surface.bump_widths", widths, line);
    parameters.setNumbers("disk.surface.bump_x", x, line);
    parameters.setNumbers("disk.surface.bump_y", y, line);
    // The bumps return after one turn of the disk and do not repeat across the slider.
    const Case& c = parameters.value();
    const double turn = 2.0 * std::numbers::pi * c.disk.radius;
    parameters.setNumber("disk.surface.track", std::min(turn, 1.0), line);
    parameters.setNumber("disk.surface.track_width", std::max(4.0 * c.slider.width, *std::ranges::max_element(widths)),
                         line);
    // Only plots and statistics of the surface look at its cells.
    parameters.setNumber("disk.surface.cell", *std::ranges::min_element(widths) / 8.0, line);
    part.parameters().addWarning(
        line, "Disk Surface: asperities are read with x from the leading edge at the start, y from the "
              "inner edge and full sizes");
}

} // namespace

void readCmlTrackProfile(CmlPart& part)
{
    if (!isOn(part)) return;
    const auto numbers = part.list(0);
    part.parameters().choose("disk.surface.file", "wave.def", numbers.front().line);
    if (numbers.size() > 2 && numbers[2].value != 0.0) part.leaveOut("where the profile starts (dinit)");
}

void readCmlDiskSurface(CmlPart& part)
{
    const auto counts = part.list(0);
    if (std::ranges::all_of(counts.first(std::min<std::size_t>(counts.size(), 3)),
                            [](const CmlNumber& n) { return n.value == 0.0; }))
        return;
    const auto count = [&](std::size_t i, const char* what) {
        return static_cast<std::size_t>(part.whole(0, i, what, 0, most));
    };
    const std::size_t waves = count(0, "the number of waves"), zones = count(1, "the number of zones"),
                      asperities = count(2, "the number of asperities");
    const std::vector<CmlNumber> all = part.sequence(3);
    const std::size_t needed = 6 + waveNumbers * waves + zoneNumbers * zones + asperityNumbers * asperities;
    if (all.size() != needed) {
        part.leaveOut("the whole section, which is switched on and has " + std::to_string(all.size()) +
                      " numbers, not " + std::to_string(needed));
        return;
    }
    const std::span<const CmlNumber> numbers(all);
    if (std::ranges::any_of(numbers.subspan(3, 3), [](const CmlNumber& n) { return n.value != 0.0; }))
        part.leaveOut("times (t1, t2, t3)");
    if (zones > 0) part.leaveOut("zones of the disk (nzone)");
    if (waves > 0) readWaves(part, numbers.subspan(6, waveNumbers * waves));
    if (asperities > 0) readAsperities(part, numbers.last(asperityNumbers * asperities));
}

void readCmlIntermolecular(CmlPart& part)
{
    if (!isOn(part)) return;
    const auto numbers = part.numbers(0, 4, "the mode, A, B and the potential");
    CmlParameters& parameters = part.parameters();
    const int line = numbers.front().line;
    parameters.choose("contact", "elastic", line);
    parameters.choose("adhesion.kind", "van-der-waals", line);
    parameters.set("adhesion.hamaker_a", numbers[1]);
    parameters.set("adhesion.hamaker_b", numbers[2]);
    parameters.set("adhesion.voltage", numbers[3]);
}

void readCmlAsperityContact(CmlPart& part)
{
    if (isOn(part))
        part.leaveOut("contact of a statistical surface (icmod = " + std::string(part.list(0).front().text) + ")");
}

void settleCmlDisk(CmlParameters& parameters)
{
    const DiskSurface& surface = parameters.value().diskSurface;
    const bool file = !surface.file.empty(), waves = !surface.waveAmplitudes.empty(),
               bumps = !surface.bumpHeights.empty();
    if (file + waves + bumps > 1) {
        parameters.choose("disk.surface.kind", "combined",
                          parameters.lineOf(bumps ? "disk.surface.bump_heights" : "disk.surface.wave_amplitudes"));
        parameters.setNumber("disk.surface.rms", 0.0, 0); // a combined surface would have some roughness
    } else if (file || waves || bumps) {
        parameters.choose("disk.surface.kind",
                          file    ? "file"
                          : waves ? "waves"
                                  : "bumps",
                          parameters.lineOf(file    ? "disk.surface.file"
                                            : waves ? "disk.surface.wave_amplitudes"
                                                    : "disk.surface.bump_heights"));
    }
    if (parameters.value().contact != ContactKind::Elastic) return;
    const int line = parameters.lineOf("adhesion.hamaker_a");
    parameters.setNumber("elastic.patch_pitch", parameters.value().initial.pitch, parameters.lineOf("initial.pitch"));
    const auto problems = checkCombinations(parameters.value());
    const auto ofPatch = std::ranges::find(problems, "elastic.patch_reach", &CaseProblem::key);
    if (ofPatch == problems.end()) return;
    parameters.choose("contact", "none", line);
    parameters.addWarning(line, "Intermolecular: not modelled: the forces, because " + ofPatch->message);
}

} // namespace touchdown
