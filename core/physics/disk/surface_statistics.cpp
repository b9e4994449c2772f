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

namespace touchdown {

namespace {

using std::numbers::pi;

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

    /// Where the autocorrelation falls to 1/e; 0 if it does not within half the length [points].
    double correlationLength()
    {
        std::ranges::copy(power_, half_.begin());
        fftw_execute(back_);
        const std::vector<double> covariance = row_;
        // What the window itself does to the products of points so far apart.
        for (std::size_t k = 0; k < n_; ++k) row_[k] = window_[k];
        fftw_execute(forwards_);
        for (auto& h : half_) h = std::norm(h);
        fftw_execute(back_);
        const auto at = [&](std::size_t m) { return covariance[m] / row_[m] / (covariance[0] / row_[0]); };
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

SurfaceStatistics statisticsOf(const UniformGrid& grid, const RowSource& source, bool periodic,
                               const std::function<bool()>& goOn = {})
{
    assert(grid.cells() > 0);
    SurfaceStatistics s;
    const auto columns = static_cast<std::size_t>(grid.nx);
    const double points = static_cast<double>(grid.cells());
    std::vector<double> row(columns), before(columns), first(columns);
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
    if (s.maximum == s.minimum) return s;

    Moments sums;
    RowPower power(grid.nx, periodic);
    for (int j = 0; j < grid.ny; ++j) {
        if (goOn && !goOn()) return {};
        source(j, row);
        sums.addHeights(row, s.mean);
        power.add(row, s.mean);
        sums.slopeX += Moments::squaredDifferences(std::span(row).first(columns - 1), std::span(row).subspan(1));
        if (periodic) sums.slopeX += (row.front() - row.back()) * (row.front() - row.back());
        if (j > 0) sums.slopeY += Moments::squaredDifferences(before, row);
        if (j == 0) first = row;
        before.swap(row);
    }
    if (periodic) sums.slopeY += Moments::squaredDifferences(before, first);

    const double variance = sums.second / points;
    s.rms = std::sqrt(variance);
    s.skewness = sums.third / points / (variance * s.rms);
    s.kurtosis = sums.fourth / points / (variance * variance);
    const double pairsX = periodic ? points : points - grid.ny, pairsY = periodic ? points : points - grid.nx;
    if (pairsX > 0.0) s.slopeX = std::sqrt(sums.slopeX / pairsX) / grid.dx;
    if (pairsY > 0.0) s.slopeY = std::sqrt(sums.slopeY / pairsY) / grid.dy;
    s.psd = power.density(grid.dx, grid.ny);
    s.correlationLength = power.correlationLength() * grid.dx;
    return s;
}

} // namespace

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

SurfaceStatistics surfaceStatistics(const DiskTopography& surface, const std::function<bool()>& goOn)
{
    const UniformGrid grid = surface.measured();
    return statisticsOf(
        grid,
        [&](int j, std::span<double> row) {
            const UniformGrid line{grid.nx, 1, grid.dx, grid.dy, grid.x0, grid.y0 + j * grid.dy};
            surface.heights(line, 0.0, 0.0, row);
        },
        surface.measuredRepeats(), goOn);
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
