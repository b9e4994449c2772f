// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of the disk.
#include "core/case/field_builders.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

using namespace field_builders;

namespace {

constexpr double longestTrack = 1.0; // [m]
constexpr const char* ours = "ours";
constexpr const char* none = "ours: none";

bool withKind(const Case& c, DiskSurfaceKind kind) { return withDiskSurface(c) && c.diskSurface.kind == kind; }
bool combined(const Case& c) { return withKind(c, DiskSurfaceKind::Combined); }
bool notFlat(const Case& c) { return withDiskSurface(c) && c.diskSurface.kind != DiskSurfaceKind::Flat; }
bool withWaves(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::Waves); }
bool withRough(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::Rough); }
bool withFile(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::File); }
bool withBumps(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::Bumps); }
/// Of waves alone the statistics look at one track.
bool withTrack(const Case& c) { return withRough(c) || withBumps(c) || withWaves(c); }
bool withCorrelation(const Case& c) { return withRough(c) && c.diskSurface.spectrum != RoughnessSpectrum::SelfAffine; }
bool selfAffine(const Case& c) { return withRough(c) && c.diskSurface.spectrum == RoughnessSpectrum::SelfAffine; }

Field lengths(const char* key, const char* label, const char* unit, std::size_t most, const char* help,
              std::vector<double> DiskSurface::*member, bool (*used)(const Case&), bool positive)
{
    return list({.key = key,
                 .label = label,
                 .unit = "m",
                 .displayUnit = unit,
                 .minimum = positive ? 0.0 : -longestTrack,
                 .maximum = longestTrack,
                 .minimumAllowed = !positive,
                 .maximumCount = most,
                 .help = help,
                 .source = none},
                at(&Case::diskSurface, member), used);
}

Field angles(const char* key, const char* label, const char* help, std::vector<double> DiskSurface::*member)
{
    return list({.key = key,
                 .label = label,
                 .unit = "rad",
                 .displayUnit = "deg",
                 .minimum = -10,
                 .maximum = 10,
                 .maximumCount = mostWaves,
                 .help = help,
                 .source = none},
                at(&Case::diskSurface, member), withWaves);
}

Field length(const char* key, const char* label, const char* unit, const char* help, const char* source,
             double DiskSurface::*member, bool (*used)(const Case&))
{
    return number({.key = key,
                   .label = label,
                   .unit = "m",
                   .displayUnit = unit,
                   .minimum = 0,
                   .maximum = longestTrack,
                   .minimumAllowed = false,
                   .help = help,
                   .source = source},
                  at(&Case::diskSurface, member), used);
}

std::vector<Field> kindFields()
{
    return {
        choice(
            {.key = "disk.surface.kind",
             .label = "surface",
             .choices = {"flat", "waves", "rough", "file", "bumps", "combined"},
             .help =
                 "Surface of the disk: flat, waves = a sum of sines, rough = random heights of a given spectrum, file "
                 "= "
                 "a measured profile or map, bumps = single bumps and pits, combined = the sum of all that is given.",
             .source = "paper, section 3: rough, and flat for comparison"},
            at(&Case::diskSurface, &DiskSurface::kind), withDiskSurface),
        choice({.key = "disk.surface.motion",
                .label = "motion",
                .choices = {"moving", "still"},
                .help = "Whether the surface moves through the contact with the disk, or is held still inside it.",
                .source = "paper, section 3: both, cases II and III"},
               at(&Case::diskSurface, &DiskSurface::motion), notFlat),
    };
}

std::vector<Field> waveFields()
{
    return {
        lengths("disk.surface.wave_amplitudes", "wave amplitudes", "nm", mostWaves,
                "Amplitude of each wave; empty = no waves.", &DiskSurface::waveAmplitudes, withWaves, false),
        lengths("disk.surface.wave_lengths", "wavelengths", "um", mostWaves,
                "Wavelength of each wave, one to each amplitude.", &DiskSurface::waveLengths, withWaves, true),
        angles("disk.surface.wave_angles", "wave angles",
               "Angle between the motion of the disk and the direction in which each wave runs; empty = 0 for all.",
               &DiskSurface::waveAngles),
        angles("disk.surface.wave_phases", "wave phases", "Phase of each wave at the origin; empty = 0 for all.",
               &DiskSurface::wavePhases),
    };
}

std::vector<Field> roughFields()
{
    return {
        choice({.key = "disk.surface.spectrum",
                .label = "spectrum",
                .choices = {"gaussian", "exponential", "self-affine"},
                .help = "Spectrum of the random heights: gaussian or exponential = by the form of the autocorrelation, "
                        "self-affine = a power law between two wavelengths.",
                .source = "ours: gaussian"},
               at(&Case::diskSurface, &DiskSurface::spectrum), withRough),
        number({.key = "disk.surface.rms",
                .label = "roughness",
                .unit = "m",
                .displayUnit = "nm",
                .minimum = 0,
                .maximum = 1e-3,
                .help = "Root mean square of the random heights; 0 only where a combined surface has none.",
                .source = "paper, section 3: 0.2 nm"},
               at(&Case::diskSurface, &DiskSurface::rms), withRough),
        length("disk.surface.correlation_length", "correlation length", "um",
               "Distance over which the autocorrelation falls to 1/e; at least disk.surface.cell.",
               "assumed: the paper gives the RMS alone", &DiskSurface::correlationLength, withCorrelation),
        number({.key = "disk.surface.hurst",
                .label = "Hurst exponent",
                .symbol = "H",
                .minimum = 0,
                .maximum = 1,
                .minimumAllowed = false,
                .help = "Exponent of the self-affine spectrum, which falls as 1/q^(2 H + 2) with the wave number q.",
                .source = "the usual 0.8"},
               at(&Case::diskSurface, &DiskSurface::hurst), selfAffine),
        length("disk.surface.roll_off", "roll-off wavelength", "um",
               "Longest wavelength of the power law; the spectrum is flat beyond.", ours, &DiskSurface::rollOff,
               selfAffine),
        length("disk.surface.cut_off", "cut-off wavelength", "um", "Shortest wavelength of the surface.", ours,
               &DiskSurface::cutOff, selfAffine),
        plain(FieldKind::Integer,
              {.key = "disk.surface.seed",
               .label = "seed",
               .minimum = 0,
               .maximum = 2147483647,
               .help = "Seed of the random heights; the same seed gives the same surface.",
               .source = ours},
              at(&Case::diskSurface, &DiskSurface::seed), withRough),
        length("disk.surface.cell", "surface cell", "um",
               "Side of a cell of the map of heights; the surface has no wave shorter than two of them.", ours,
               &DiskSurface::cell, withTrack),
        length("disk.surface.track", "track", "um", "Length along the motion after which the surface repeats.", ours,
               &DiskSurface::track, withTrack),
        length("disk.surface.track_width", "track width", "um",
               "Width across the motion after which the surface repeats.", ours, &DiskSurface::trackWidth, withTrack),
    };
}

std::vector<Field> fileFields()
{
    return {
        plain(
            FieldKind::Text,
            {.key = "disk.surface.file",
             .label = "file",
             .help =
                 "File of a measured surface, from the folder of the case: columns of text with a profile or a map, a "
                 "wave.def, or HDF5; empty = none.",
             .source = none},
            at(&Case::diskSurface, &DiskSurface::file), withFile),
    };
}

std::vector<Field> bumpFields()
{
    return {
        choice({.key = "disk.surface.bump_shape",
                .label = "bump shape",
                .choices = {"ellipsoid", "gaussian", "cosine"},
                .help = "Form of the bumps and pits.",
                .source = none},
               at(&Case::diskSurface, &DiskSurface::bumpShape), withBumps),
        lengths("disk.surface.bump_heights", "bump heights", "nm", mostBumps,
                "Height of each bump, negative for a pit; empty = none.", &DiskSurface::bumpHeights, withBumps, false),
        lengths("disk.surface.bump_lengths", "bump lengths", "um", mostBumps,
                "Full extent of each bump at its base along the motion, one to each height.", &DiskSurface::bumpLengths,
                withBumps, true),
        lengths("disk.surface.bump_widths", "bump widths", "um", mostBumps,
                "Full extent of each bump across; empty = as long as they are.", &DiskSurface::bumpWidths, withBumps,
                true),
        lengths("disk.surface.bump_x", "bump x", "um", mostBumps, "Centre of each bump along the motion.",
                &DiskSurface::bumpX, withBumps, false),
        lengths("disk.surface.bump_y", "bump y", "um", mostBumps, "Centre of each bump across the motion.",
                &DiskSurface::bumpY, withBumps, false),
    };
}

} // namespace

std::vector<Field> diskSurfaceFields()
{
    std::vector<Field> all = kindFields();
    for (auto part : {waveFields, roughFields, fileFields, bumpFields})
        for (Field& field : part()) all.push_back(std::move(field));
    return all;
}

} // namespace touchdown
