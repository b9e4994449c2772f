// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of the disk.
#include "core/case/parameter_builders.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

using namespace parameter_builders;

namespace {

constexpr double longestTrack = 1.0; // [m]
constexpr const char* ours = "ours";

bool withKind(const Case& c, DiskSurfaceKind kind) { return withDiskSurface(c) && c.diskSurface.kind == kind; }
bool combined(const Case& c) { return withKind(c, DiskSurfaceKind::Combined); }
bool withWaves(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::Waves); }
bool withRough(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::Rough); }
bool withFile(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::File); }
bool withBumps(const Case& c) { return combined(c) || withKind(c, DiskSurfaceKind::Bumps); }
/// For waves only the statistics use the track.
bool withTrack(const Case& c) { return withRough(c) || withBumps(c) || withWaves(c); }
bool withCorrelation(const Case& c) { return withRough(c) && c.diskSurface.spectrum != RoughnessSpectrum::SelfAffine; }
bool selfAffine(const Case& c) { return withRough(c) && c.diskSurface.spectrum == RoughnessSpectrum::SelfAffine; }

} // namespace

std::vector<Parameter> diskSurfaceParameters()
{
    return {
        choice("disk.surface.kind", "surface", {"flat", "waves", "rough", "file", "bumps", "combined"},
               at(&Case::diskSurface, &DiskSurface::kind), withDiskSurface,
               "Surface of the disk: flat, waves = a sum of sines, rough = random heights of a given spectrum, file = "
               "a measured profile or map, bumps = single bumps and pits, combined = the sum of all given parts.",
               "paper, section 3: rough, and flat for comparison"),
        choice("disk.surface.motion", "motion", {"moving", "still"}, at(&Case::diskSurface, &DiskSurface::motion),
               withUnevenDisk, "moving = the surface moves with the disk; still = it stands still under the slider.",
               "paper, section 3: both, cases II and III"),
        list("disk.surface.wave_amplitudes", "wave amplitudes", nanometres, within(longestTrack), atMost(mostWaves),
             at(&Case::diskSurface, &DiskSurface::waveAmplitudes), withWaves,
             "Amplitude of each wave; empty = no waves.", none),
        list("disk.surface.wave_lengths", "wavelengths", micrometres, positive(longestTrack), atMost(mostWaves),
             at(&Case::diskSurface, &DiskSurface::waveLengths), withWaves,
             "Wavelength of each wave, one per amplitude.", none),
        list("disk.surface.wave_angles", "wave angles", degrees, within(10), atMost(mostWaves),
             at(&Case::diskSurface, &DiskSurface::waveAngles), withWaves,
             "Angle between the motion of the disk and the direction in which each wave runs; empty = 0 for all.",
             none),
        list("disk.surface.wave_phases", "wave phases", degrees, within(10), atMost(mostWaves),
             at(&Case::diskSurface, &DiskSurface::wavePhases), withWaves,
             "Phase of each wave at the origin; empty = 0 for all.", none),
        choice("disk.surface.spectrum", "spectrum", {"gaussian", "exponential", "self-affine"},
               at(&Case::diskSurface, &DiskSurface::spectrum), withRough,
               "Spectrum of the random heights: gaussian or exponential = by the form of the autocorrelation, "
               "self-affine = a power law between two wavelengths.",
               "ours: gaussian"),
        number("disk.surface.rms", "roughness", "", nanometres, notNegative(1e-3),
               at(&Case::diskSurface, &DiskSurface::rms), withRough,
               "Root mean square of the random heights; 0 only for a combined surface without roughness.",
               "paper, section 3: 0.2 nm"),
        number("disk.surface.correlation_length", "correlation length", "", micrometres, positive(longestTrack),
               at(&Case::diskSurface, &DiskSurface::correlationLength), withCorrelation,
               "Distance over which the autocorrelation falls to 1/e; at least disk.surface.cell.",
               "assumed: the paper gives the RMS alone"),
        number("disk.surface.hurst", "Hurst exponent", "H", noUnit, positive(1),
               at(&Case::diskSurface, &DiskSurface::hurst), selfAffine,
               "Exponent of the self-affine spectrum, which falls as 1/q^(2 H + 2) with the wave number q.",
               "the usual 0.8"),
        number("disk.surface.roll_off", "roll-off wavelength", "", micrometres, positive(longestTrack),
               at(&Case::diskSurface, &DiskSurface::rollOff), selfAffine,
               "Longest wavelength of the power law; the spectrum is flat beyond.", ours),
        number("disk.surface.cut_off", "cut-off wavelength", "", micrometres, positive(longestTrack),
               at(&Case::diskSurface, &DiskSurface::cutOff), selfAffine, "Shortest wavelength of the surface.", ours),
        integer("disk.surface.seed", "seed", notNegative(2147483647), at(&Case::diskSurface, &DiskSurface::seed),
                withRough, "Seed of the random heights; the same seed gives the same surface.", ours),
        number("disk.surface.cell", "surface cell", "", micrometres, positive(longestTrack),
               at(&Case::diskSurface, &DiskSurface::cell), withTrack,
               "Side of a cell of the height map; the shortest wave of the surface is two cells long.", ours),
        number(
            "disk.surface.track", "track", "", micrometres, positive(longestTrack),
            at(&Case::diskSurface, &DiskSurface::track), withTrack,
            "Length along the motion after which the surface repeats. A run over a moving surface tells how its motion "
            "ends once the rarest feature has passed twice.",
            ours),
        number("disk.surface.track_width", "track width", "", micrometres, positive(longestTrack),
               at(&Case::diskSurface, &DiskSurface::trackWidth), withTrack,
               "Width across the motion after which the surface repeats.", ours),
        text("disk.surface.file", "file", at(&Case::diskSurface, &DiskSurface::file), withFile,
             "File of a measured surface, relative to the folder of the case: columns or a matrix of text, "
             "a wave.def, GSF, SDF, or HDF5; empty = none. A file outside that folder is read only if allowed "
             "(--allow-paths). "
             "Its lengths have units, in the file or in disk.surface.unit.",
             none),
        text(
            "disk.surface.unit", "unit of the file", at(&Case::diskSurface, &DiskSurface::unit), withFile,
            "Units of the lengths in the file where it names none: one for each column, as \"um, nm\" for x and height "
            "or \"um, um, nm\" for x, y and height, or one for all. Units in the file must be the same; empty = those "
            "of "
            "the file.",
            none),
        choice("disk.surface.bump_shape", "bump shape", {"ellipsoid", "gaussian", "cosine"},
               at(&Case::diskSurface, &DiskSurface::bumpShape), withBumps, "Form of the bumps and pits.", none),
        list("disk.surface.bump_heights", "bump heights", nanometres, within(longestTrack), atMost(mostBumps),
             at(&Case::diskSurface, &DiskSurface::bumpHeights), withBumps,
             "Height of each bump, negative for a pit; empty = none.", none),
        list("disk.surface.bump_lengths", "bump lengths", micrometres, positive(longestTrack), atMost(mostBumps),
             at(&Case::diskSurface, &DiskSurface::bumpLengths), withBumps,
             "Full extent of each bump at its base along the motion, one per height.", none),
        list("disk.surface.bump_widths", "bump widths", micrometres, positive(longestTrack), atMost(mostBumps),
             at(&Case::diskSurface, &DiskSurface::bumpWidths), withBumps,
             "Full extent of each bump at its base across the motion; empty = the same as the lengths.", none),
        list("disk.surface.bump_x", "bump x", micrometres, within(longestTrack), atMost(mostBumps),
             at(&Case::diskSurface, &DiskSurface::bumpX), withBumps, "Centre of each bump along the motion.", none),
        list("disk.surface.bump_y", "bump y", micrometres, within(longestTrack), atMost(mostBumps),
             at(&Case::diskSurface, &DiskSurface::bumpY), withBumps, "Centre of each bump across the motion.", none),
    };
}

} // namespace touchdown
