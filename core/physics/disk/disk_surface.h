// SPDX-License-Identifier: GPL-3.0-or-later
//
// The specification of the disk's surface: w(x, y), its height above its mean plane, in the disk's coordinates.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchdown {

enum class DiskSurfaceKind : std::uint8_t { Flat, Waves, Rough, File, Bumps, Combined };
enum class RoughnessSpectrum : std::uint8_t { Gaussian, Exponential, SelfAffine };
enum class SurfaceMotion : std::uint8_t { Moving, Still };
enum class BumpShape : std::uint8_t { Ellipsoid, Gaussian, Cosine };

struct DiskSurface {
    DiskSurfaceKind kind = DiskSurfaceKind::Flat;
    SurfaceMotion motion = SurfaceMotion::Moving; // through the interface with the disk, or held still inside it

    // Waves: sum of a sin(2 pi (x cos b + y sin b)/l + c); lists of one length, empty angles and phases are zero.
    std::vector<double> waveAmplitudes; // a [m]
    std::vector<double> waveLengths;    // l [m]
    std::vector<double> waveAngles;     // b [rad], of the direction in which the wave runs against the track
    std::vector<double> wavePhases;     // c [rad]

    // Rough: Gaussian heights with a given spectrum, periodic with `track` and `trackWidth`.
    RoughnessSpectrum spectrum = RoughnessSpectrum::Gaussian;
    double rms = 0.2e-9;             // [m]
    double correlationLength = 2e-6; // gaussian, exponential: the autocorrelation falls to 1/e [m]
    double hurst = 0.8;              // self-affine [-]
    double rollOff = 16e-6; // self-affine: longest wavelength of the power law; the spectrum is flat beyond [m]
    double cutOff = 1e-6;   // self-affine: shortest wavelength [m]
    int seed = 1;
    double cell = 0.25e-6;     // of the generated map [m]
    double track = 1e-3;       // period along the motion [m]
    double trackWidth = 32e-6; // period across [m]

    // File: a profile (along the track, the same across) or a map, columns of text, wave.def or HDF5.
    std::string file;
    std::string unit; // of its columns, "um, nm"; empty: as the file says

    // Bumps and pits: lists of one length; periodic with `track` and `trackWidth`.
    BumpShape bumpShape = BumpShape::Ellipsoid;
    std::vector<double> bumpHeights; // [m]; negative: a pit
    std::vector<double> bumpLengths; // full extent at the base along x [m]
    std::vector<double> bumpWidths;  // across; empty: as long [m]
    std::vector<double> bumpX;       // of the centre [m]
    std::vector<double> bumpY;       // [m]

    bool operator==(const DiskSurface&) const = default;
};

} // namespace touchdown
