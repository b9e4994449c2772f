// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/surface_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>

#include <fftw3.h>

#include "core/numerics/fourier.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

using std::numbers::pi;

constexpr double sameWave = 1e-9; // of a wave number, or of the number of waves in a length

bool isWhole(double count) { return std::abs(count - std::round(count)) < sameWave * std::max(1.0, std::abs(count)); }

using RowSource = std::function<void(int, std::span<double>)>;

/// Power of the waves along the rows, summed over them.
class RowPower {
public:
    RowPower(int points, bool periodic)
        : n_(static_cast<std::size_t>(points)), window_(n_, 1.0), row_(n_), half_(n_ / 2 + 1)
    {
        if (!periodic)
            for (std::size_t i = 0; i < n_; ++i)
                window_[i] = 0.5 - 0.5 * std::cos(2.0 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n_));
        power_.assign(half_.size(), 0.0);
        const std::lock_guard guard(fourierPlanner());
        auto* half = reinterpret_cast<fftw_complex*>(half_.data());
        constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
        forwards_ = fftw_plan_dft_r2c_1d(points, row_.data(), half, flags);
        back_ = fftw_plan_dft_c2r_1d(points, half, row_.data(), flags);
    }
    ~RowPower()
    {
        const std::lock_guard guard(fourierPlanner());
        fftw_destroy_plan(forwards_);
        fftw_destroy_plan(back_);
    }
    RowPower(const RowPower&) = delete;
    RowPower& operator=(const RowPower&) = delete;

    void add(std::span<const double> heights, double mean)
    {
        for (std::size_t i = 0; i < n_; ++i) row_[i] = (heights[i] - mean) * window_[i];
        fftw_execute(forwards_);
        for (std::size_t k = 0; k < half_.size(); ++k) power_[k] += std::norm(half_[k]);
    }

    /// One-sided, so that the sum times 2 pi/length is the variance.
    ProfilePsd density(double step, int rows) const
    {
        double weight = 0.0; // of the window
        for (const double w : window_) weight += w * w;
        ProfilePsd psd;
        for (std::size_t k = 1; k < half_.size(); ++k) {
            const double sides = 2 * k == n_ ? 1.0 : 2.0;
            psd.waveNumber.push_back(2.0 * pi * static_cast<double>(k) / (static_cast<double>(n_) * step));
            psd.density.push_back(sides * power_[k] * step / (2.0 * pi * weight * rows));
            psd.modes.push_back(1);
        }
        return psd;
    }

    /// Where the autocorrelation falls to 1/e; 0 if it does not within half the length [points]. The rows have this
    /// variance, waves that they leave out another: `waves` over the distance in points.
    double correlationLength(double variance, const std::function<double(double)>& waves)
    {
        std::ranges::copy(power_, half_.begin());
        fftw_execute(back_);
        const std::vector<double> covariance = row_;
        // What the window itself does to the products of points so far apart.
        for (std::size_t k = 0; k < n_; ++k) row_[k] = window_[k];
        fftw_execute(forwards_);
        for (auto& h : half_) h = std::norm(h);
        fftw_execute(back_);
        const double all = variance + waves(0.0);
        const auto at = [&](std::size_t m) {
            const double share = variance > 0.0 ? covariance[m] / row_[m] / (covariance[0] / row_[0]) : 0.0;
            return (variance * share + waves(static_cast<double>(m))) / all;
        };
        constexpr double level = 1.0 / std::numbers::e;
        for (std::size_t m = 1; m <= n_ / 2; ++m)
            if (at(m) < level) return static_cast<double>(m) - (level - at(m)) / (at(m - 1) - at(m));
        return 0.0;
    }

private:
    std::size_t n_;
    std::vector<double> window_, row_, power_;
    std::vector<std::complex<double>> half_;
    fftw_plan forwards_ = nullptr, back_ = nullptr;
};

/// Sums of powers of height and slope.
struct Moments {
    double second = 0.0, third = 0.0, fourth = 0.0, slopeX = 0.0, slopeY = 0.0;

    void addHeights(std::span<const double> row, double mean)
    {
        for (const double h : row) {
            const double d = h - mean;
            second += d * d;
            third += d * d * d;
            fourth += d * d * d * d;
        }
    }
    static double squaredDifferences(std::span<const double> a, std::span<const double> b)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += (b[i] - a[i]) * (b[i] - a[i]);
        return sum;
    }
};

/// `waves`: which the source leaves out.
SurfaceStatistics statisticsOf(const UniformGrid& grid, const RowSource& source, bool periodic,
                               const std::function<bool()>& goOn = {}, const OtherWaves& waves = {})
{
    assert(grid.cells() > 0);
    SurfaceStatistics s;
    const auto columns = static_cast<std::size_t>(grid.nx);
    const double points = static_cast<double>(grid.cells());
    std::vector<double> row(columns), before(columns), first(columns), whole;
    s.minimum = std::numeric_limits<double>::infinity();
    s.maximum = -s.minimum;
    for (int j = 0; j < grid.ny; ++j) {
        if (goOn && !goOn()) return {};
        source(j, row);
        for (const double h : row) {
            s.mean += h / points;
            s.minimum = std::min(s.minimum, h);
            s.maximum = std::max(s.maximum, h);
        }
    }
    if (s.maximum == s.minimum && waves.empty()) return s;

    Moments sums;
    RowPower power(grid.nx, periodic), withWaves(grid.nx, false);
    const Waves left = waves.heights();
    for (int j = 0; j < grid.ny; ++j) {
        if (goOn && !goOn()) return {};
        source(j, row);
        sums.addHeights(row, s.mean);
        power.add(row, s.mean);
        if (!waves.empty()) {
            whole = row;
            left.addHeights({grid.nx, 1, grid.dx, grid.dy, grid.x0, grid.y0 + j * grid.dy}, 0.0, 0.0, whole);
            withWaves.add(whole, s.mean);
        }
        sums.slopeX += Moments::squaredDifferences(std::span(row).first(columns - 1), std::span(row).subspan(1));
        if (periodic) sums.slopeX += (row.front() - row.back()) * (row.front() - row.back());
        if (j > 0) sums.slopeY += Moments::squaredDifferences(before, row);
        if (j == 0) first = row;
        before.swap(row);
    }
    if (periodic) sums.slopeY += Moments::squaredDifferences(before, first);

    const double variance = sums.second / points;
    s.rms = std::sqrt(variance + waves.variance());
    s.skewness = sums.third / points / (variance * s.rms);
    s.kurtosis = sums.fourth / points / (variance * variance);
    const double pairsX = periodic ? points : points - grid.ny, pairsY = periodic ? points : points - grid.nx;
    if (pairsX > 0.0) s.slopeX = std::sqrt(sums.slopeX / pairsX / (grid.dx * grid.dx) + waves.squaredSlopeX());
    if (pairsY > 0.0) s.slopeY = std::sqrt(sums.slopeY / pairsY / (grid.dy * grid.dy) + waves.squaredSlopeY());
    s.psd = (waves.empty() ? power : withWaves).density(grid.dx, grid.ny);
    s.correlationLength =
        power.correlationLength(variance, [&](double away) { return waves.covariance(away * grid.dx); }) * grid.dx;
    if (waves.empty()) return s;
    s.skewness = s.kurtosis = std::numeric_limits<double>::quiet_NaN();
    s.minimum -= waves.amplitude();
    s.maximum += waves.amplitude();
    s.boundsAlone = true;
    return s;
}

} // namespace

OtherWaves::OtherWaves(const DiskSurface& surface, const UniformGrid& period)
{
    if (!hasWaves(surface)) return;
    asked_.kind = DiskSurfaceKind::Waves;
    const auto entry = [](const std::vector<double>& list, std::size_t i) { return list.empty() ? 0.0 : list[i]; };
    for (std::size_t i = 0; i < surface.waveAmplitudes.size(); ++i) {
        const double k = 2.0 * pi / surface.waveLengths[i], angle = entry(surface.waveAngles, i);
        Wave wave{surface.waveAmplitudes[i], k * std::cos(angle), k * std::sin(angle), entry(surface.wavePhases, i)};
        const bool along = isWhole(wave.kx * period.nx * period.dx / (2.0 * pi));
        const bool across =
            period.ny > 1 ? isWhole(wave.ky * period.ny * period.dy / (2.0 * pi)) : std::abs(wave.ky) < sameWave * k;
        if (along && across) continue;
        asked_.waveAmplitudes.push_back(wave.amplitude);
        asked_.waveLengths.push_back(surface.waveLengths[i]);
        asked_.waveAngles.push_back(angle);
        asked_.wavePhases.push_back(wave.phase);
        const auto add = [&](const Wave& one) {
            for (Wave& other : waves_) {
                if (std::hypot(other.kx - one.kx, other.ky - one.ky) > sameWave * k) continue;
                const std::complex<double> both =
                    std::polar(1.0, other.phase) * other.amplitude + std::polar(1.0, one.phase) * one.amplitude;
                other.amplitude = std::abs(both);
                other.phase = std::arg(both);
                return true;
            }
            return false;
        };
        const Wave opposite{wave.amplitude, -wave.kx, -wave.ky, pi - wave.phase}; // sin(-u) = sin(u + pi)
        if (!add(wave) && !add(opposite)) waves_.push_back(wave);
    }
}

double OtherWaves::covariance(double along) const
{
    double sum = 0.0;
    for (const Wave& w : waves_) sum += 0.5 * w.amplitude * w.amplitude * std::cos(w.kx * along);
    return sum;
}

double OtherWaves::squaredSlopeX() const
{
    double sum = 0.0;
    for (const Wave& w : waves_) sum += 0.5 * w.amplitude * w.amplitude * w.kx * w.kx;
    return sum;
}

double OtherWaves::squaredSlopeY() const
{
    double sum = 0.0;
    for (const Wave& w : waves_) sum += 0.5 * w.amplitude * w.amplitude * w.ky * w.ky;
    return sum;
}

double OtherWaves::amplitude() const
{
    double sum = 0.0;
    for (const Wave& w : waves_) sum += std::abs(w.amplitude);
    return sum;
}

Waves OtherWaves::heights(double sign) const
{
    DiskSurface signedWaves = asked_;
    for (double& amplitude : signedWaves.waveAmplitudes) amplitude *= sign;
    return Waves(signedWaves);
}

SurfaceStatistics surfaceStatistics(const UniformGrid& grid, std::span<const double> heights, bool periodic)
{
    assert(heights.size() == grid.cells());
    const auto columns = static_cast<std::size_t>(grid.nx);
    return statisticsOf(
        grid,
        [&](int j, std::span<double> row) {
            std::ranges::copy(heights.subspan(static_cast<std::size_t>(j) * columns, columns), row.begin());
        },
        periodic);
}

SurfaceStatistics surfaceStatistics(const DiskSurface& surface, const DiskTopography& topography,
                                    const std::function<bool()>& goOn)
{
    const UniformGrid grid = topography.measured();
    const OtherWaves others(surface, grid);
    const Waves away = others.heights(-1.0);
    // All but the waves of a surface with waves.
    const bool restRepeats = !hasFile(surface) || (!hasRoughness(surface) && !hasBumps(surface));
    return statisticsOf(
        grid,
        [&](int j, std::span<double> row) {
            const UniformGrid line{grid.nx, 1, grid.dx, grid.dy, grid.x0, grid.y0 + j * grid.dy};
            topography.heights(line, 0.0, 0.0, row);
            away.addHeights(line, 0.0, 0.0, row);
        },
        hasWaves(surface) ? restRepeats : topography.measuredRepeats(), goOn, others);
}

ProfilePsd averaged(const ProfilePsd& psd, int perDecade)
{
    ProfilePsd bins;
    double last = 0.0; // number of the bin
    for (std::size_t k = 0; k < psd.density.size(); ++k) {
        const double bin = std::floor(std::log10(psd.waveNumber[k] / psd.waveNumber.front()) * perDecade);
        if (k == 0 || bin != last) {
            bins.waveNumber.push_back(0.0);
            bins.density.push_back(0.0);
            bins.modes.push_back(0);
            last = bin;
        }
        bins.waveNumber.back() += psd.waveNumber[k] * psd.modes[k];
        bins.density.back() += psd.density[k] * psd.modes[k];
        bins.modes.back() += psd.modes[k];
    }
    for (std::size_t b = 0; b < bins.density.size(); ++b) {
        bins.waveNumber[b] /= bins.modes[b];
        bins.density[b] /= bins.modes[b];
    }
    return bins;
}

} // namespace touchdown
