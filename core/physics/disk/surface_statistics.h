// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of a surface, from its heights. Power spectral densities are one-sided, over the wave number q = 2
// pi/wavelength along the track: the integral of the density over q > 0 is the variance.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/physics/disk/disk_surface.h"
#include "core/physics/disk/disk_topography.h"
#include "core/physics/disk/waves.h"

namespace touchdown {

struct ProfilePsd {
    std::vector<double> waveNumber; // q [rad/m], ascending, > 0
    std::vector<double> density;    // [m^3], the mean of all rows
    std::vector<int> modes;         // number of wave numbers of the period in the value
};

struct SurfaceStatistics {
    double mean = 0.0;                   // [m]
    double rms = 0.0;                    // about the mean [m]
    double skewness = 0.0;               // [-]; 0 of Gaussian heights; NaN: not known
    double kurtosis = 0.0;               // [-]; 3 of Gaussian heights; NaN: not known
    double slopeX = 0.0, slopeY = 0.0;   // RMS, between neighbouring points [-]
    double minimum = 0.0, maximum = 0.0; // [m]
    bool boundsAlone = false;            // minimum and maximum are bounds that may not be reached
    double correlationLength = 0.0; // along the track, where the autocorrelation first falls to 1/e [m]; 0: it does not
    ProfilePsd psd;
};

/// Waves of a surface that do not repeat with a length and a width, such as those of a map. Over the whole disk they
/// are independent of what does: variances, squared slopes and autocorrelations add. A wave a sin(k x + c) has the
/// variance a^2/2; waves of equal wave vectors add with their phases to one.
class OtherWaves {
public:
    OtherWaves() = default;
    /// Those that do not repeat with the length and width of `period`; where it is one row, that of a profile, also all
    /// that change across.
    OtherWaves(const DiskSurface& surface, const UniformGrid& period);

    bool empty() const { return waves_.empty(); }
    double variance() const { return covariance(0.0); } // of the heights [m^2]
    double covariance(double along) const;              // of two heights at this distance along x [m^2]
    double squaredSlopeX() const;                       // the mean [-]
    double squaredSlopeY() const;
    double amplitude() const; // the sum of all [m]
    /// The waves themselves, to be added to heights, or with `sign` -1 taken away.
    Waves heights(double sign = 1.0) const;

private:
    struct Wave {
        double amplitude, kx, ky, phase; // [m], [rad/m], [rad]
    };
    std::vector<Wave> waves_; // of different wave vectors
    DiskSurface asked_;       // as the case has them
};

/// Of heights on the cells of `grid`, row by row. `periodic`: they repeat in both directions; else the spectrum has a
/// Hann window. Skewness, kurtosis, correlation length and density are 0 or empty where all heights are equal.
SurfaceStatistics surfaceStatistics(const UniformGrid& grid, std::span<const double> heights, bool periodic);

/// Of a surface: one period of it is read; of a measured one alone, the points of its file. Waves that do not repeat
/// with that count as independent of the rest, over the whole disk: variances, squared slopes and autocorrelations add,
/// the extremes are bounds, and skewness and kurtosis are not known; the density is that of one period. If `goOn`,
/// asked at each row, returns false the statistics are invalid.
SurfaceStatistics surfaceStatistics(const DiskSurface& surface, const DiskTopography& topography,
                                    const std::function<bool()>& goOn = {});

/// For plots: the density averaged over bins of equal ratio, at most `perDecade` in each decade.
ProfilePsd averaged(const ProfilePsd& psd, int perDecade);

} // namespace touchdown
