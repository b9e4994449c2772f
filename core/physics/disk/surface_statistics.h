// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of a surface, from its heights. Power spectral densities are one-sided, over the wave number q = 2
// pi/wavelength along the track: the integral of the density over q > 0 is the variance.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/physics/disk/disk_topography.h"

namespace touchdown {

struct ProfilePsd {
    std::vector<double> waveNumber; // q [rad/m], ascending, > 0
    std::vector<double> density;    // [m^3], the mean of all rows
    std::vector<int> modes;         // number of wave numbers of the period in the value
};

struct SurfaceStatistics {
    double mean = 0.0;                   // [m]
    double rms = 0.0;                    // about the mean [m]
    double skewness = 0.0;               // [-]; 0 of Gaussian heights
    double kurtosis = 0.0;               // [-]; 3 of Gaussian heights
    double slopeX = 0.0, slopeY = 0.0;   // RMS, between neighbouring points [-]
    double minimum = 0.0, maximum = 0.0; // [m]
    double correlationLength = 0.0; // along the track, where the autocorrelation first falls to 1/e [m]; 0: it does not
    ProfilePsd psd;
};

/// Of heights on the cells of `grid`, row by row. `periodic`: they repeat in both directions; else the spectrum has a
/// Hann window. Skewness, kurtosis, correlation length and density are 0 or empty where all heights are equal.
SurfaceStatistics surfaceStatistics(const UniformGrid& grid, std::span<const double> heights, bool periodic);

/// Of one period of a surface; of a measured one alone, those of the points of its file. If `goOn`, asked at each row,
/// returns false the statistics are invalid.
SurfaceStatistics surfaceStatistics(const DiskTopography& surface, const std::function<bool()>& goOn = {});

/// For plots: the density averaged over bins of equal ratio, at most `perDecade` in each decade.
ProfilePsd averaged(const ProfilePsd& psd, int perDecade);

} // namespace touchdown
