// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/roughness.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>

#include <fftw3.h>

#include "core/numerics/fourier.h"

namespace touchdown {

namespace {

using std::numbers::pi;
/// Beyond so many correlation lengths the autocovariance, below 2e-9 of the variance, counts as none.
constexpr double exponentialReach = 20.0;
constexpr double gaussianReach = 6.5; // below 5e-19
/// 2.5 % of a normal variable lie beyond it.
constexpr double normalQuantile = 1.959963984540054;

/// Normal deviates in pairs (Box & Muller 1958): unlike the standard library's, the same everywhere.
class NormalPairs {
public:
    explicit NormalPairs(int seed) : engine_(static_cast<std::uint64_t>(static_cast<std::int64_t>(seed))) {}
    std::complex<double> operator()()
    {
        const double radius = std::sqrt(-2.0 * std::log(static_cast<double>((engine_() >> 11) + 1) * 0x1p-53));
        const double angle = 2.0 * pi * static_cast<double>(engine_() >> 11) * 0x1p-53;
        return {radius * std::cos(angle), radius * std::sin(angle)};
    }

private:
    std::mt19937_64 engine_;
};

using GoOn = std::function<bool()>;

bool stops(const GoOn& goOn) { return goOn && !goOn(); }

/// The map and its half spectrum in one array, each row of the map padded to that of the spectrum.
struct Array {
    int nx, ny;
    std::vector<double> values{};

    Array(int columns, int rows) : nx(columns), ny(rows), values(2 * halfRow() * static_cast<std::size_t>(rows)) {}
    std::size_t halfRow() const { return static_cast<std::size_t>(nx) / 2 + 1; }
    double* row(int j) { return values.data() + 2 * halfRow() * static_cast<std::size_t>(j); }
    std::complex<double>* spectrum(int j) { return reinterpret_cast<std::complex<double>*>(row(j)); }

    void transform(bool forwards)
    {
        auto* complex = reinterpret_cast<fftw_complex*>(values.data());
        // Estimated plans for any alignment, so that the same transform is done on every run.
        constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
        fftw_plan plan = nullptr;
        {
            const std::lock_guard guard(fourierPlanner());
            plan = forwards ? fftw_plan_dft_r2c_2d(ny, nx, values.data(), complex, flags)
                            : fftw_plan_dft_c2r_2d(ny, nx, complex, values.data(), flags);
        }
        fftw_execute(plan);
        const std::lock_guard guard(fourierPlanner());
        fftw_destroy_plan(plan);
    }
};

/// R(r)/sigma^2 of the spectra that are given by it, at r/lc.
double correlation(RoughnessSpectrum spectrum, double r)
{
    return spectrum == RoughnessSpectrum::Gaussian ? std::exp(-r * r) : std::exp(-r);
}

double reachOf(RoughnessSpectrum spectrum)
{
    return spectrum == RoughnessSpectrum::Gaussian ? gaussianReach : exponentialReach;
}

/// The autocovariance at a distance x, y of a surface with periods px (0: none) and py; all in correlation lengths.
double repeatedCorrelation(RoughnessSpectrum spectrum, double x, double y, double px, double py)
{
    const double reach = reachOf(spectrum);
    const double firstX = px > 0.0 ? std::ceil((-reach - x) / px) : 0.0;
    const double lastX = px > 0.0 ? std::floor((reach - x) / px) : 0.0;
    const double firstY = std::ceil((-reach - y) / py), lastY = std::floor((reach - y) / py);
    double sum = 0.0;
    for (double k = firstX; k <= lastX; k += 1.0)
        for (double l = firstY; l <= lastY; l += 1.0) {
            const double r = std::hypot(x + k * px, y + l * py);
            if (r < reach) sum += correlation(spectrum, r);
        }
    return sum;
}

/// The power of each mode, in any scale, into the real parts of the spectrum: the transform of the autocovariance.
void powerFromCovariance(const DiskSurface& s, Array& map, const GoOn& goOn)
{
    const double step = s.cell / s.correlationLength;
    for (int j = 0; j <= map.ny / 2; ++j) {
        if (stops(goOn)) return;
        for (int i = 0; i <= map.nx / 2; ++i) {
            const double value = repeatedCorrelation(s.spectrum, i * step, j * step, map.nx * step, map.ny * step);
            for (const int l : {j, (map.ny - j) % map.ny})
                for (const int k : {i, (map.nx - i) % map.nx}) map.row(l)[k] = value;
        }
    }
    map.transform(true);
}

void powerOfSelfAffine(const DiskSurface& s, Array& map)
{
    const double rollOff = 2.0 * pi / s.rollOff, cutOff = 2.0 * pi / s.cutOff;
    const double qx = 2.0 * pi / (map.nx * s.cell), qy = 2.0 * pi / (map.ny * s.cell);
    for (int j = 0; j < map.ny; ++j)
        for (std::size_t i = 0; i < map.halfRow(); ++i) {
            const double q = std::hypot(static_cast<double>(i) * qx, std::min(j, map.ny - j) * qy);
            // A wave of exactly the cut-off counts, whatever the rounding of the period.
            const bool within = q <= cutOff * (1.0 + 1e-9);
            map.spectrum(j)[i] = !within ? 0.0 : q <= rollOff ? 1.0 : std::pow(q / rollOff, -2.0 - 2.0 * s.hurst);
        }
}

/// A mode of the half spectrum and its number of copies in the whole one.
struct Mode {
    int mirrored;  // row of its conjugate in the same column; only in the first and the last one both are in the half
    bool real;     // is its own conjugate
    double copies; // in the whole spectrum; 0: the conjugate of one that has counted, or the mean
};

Mode modeAt(const Array& map, int j, std::size_t i)
{
    const bool both = i == 0 || 2 * i == static_cast<std::size_t>(map.nx);
    Mode mode{(map.ny - j) % map.ny, false, 2.0};
    if (!both) return mode;
    mode.real = mode.mirrored == j;
    mode.copies = mode.real ? 1.0 : mode.mirrored > j ? 2.0 : 0.0;
    if (i == 0 && j == 0) mode.copies = 0.0;
    return mode;
}

/// |a|^2 of a mode with the expected power 1.
double drawnPower(const Mode& mode, const std::complex<double>& pair)
{
    return mode.real ? pair.real() * pair.real() : 0.5 * std::norm(pair);
}

/// By how much alpha the power of each mode, expected P, is to be changed to P (1 + alpha P), for the total to be the
/// expected one. Given the total, the powers of normal modes are expected to be just that.
double correction(int seed, Array& map, const GoOn& goOn)
{
    NormalPairs normal(seed);
    double missing = 0.0, weighted = 0.0, largest = 0.0;
    for (int j = 0; j < map.ny; ++j) {
        if (stops(goOn)) return 0.0;
        for (std::size_t i = 0; i < map.halfRow(); ++i) {
            const std::complex<double> pair = normal();
            const Mode mode = modeAt(map, j, i);
            const double expected = std::max(0.0, map.spectrum(j)[i].real());
            const double drawn = expected * drawnPower(mode, pair);
            missing += mode.copies * (expected - drawn);
            weighted += mode.copies * expected * drawn;
            if (mode.copies > 0.0) largest = std::max(largest, expected);
        }
    }
    return std::clamp(missing / weighted, -0.5 / largest, 1.0 / largest);
}

/// From the power of each mode to one realisation of its amplitude, complex and normal, of a real surface.
void drawAmplitudes(int seed, Array& map, const GoOn& goOn)
{
    const double alpha = correction(seed, map, goOn);
    NormalPairs normal(seed);
    for (int j = 0; j < map.ny; ++j) {
        if (stops(goOn)) return;
        std::complex<double>* row = map.spectrum(j);
        for (std::size_t i = 0; i < map.halfRow(); ++i) {
            const std::complex<double> pair = normal();
            const Mode mode = modeAt(map, j, i);
            const double power = std::max(0.0, row[i].real());
            const double amplitude = std::sqrt(power * (1.0 + alpha * power));
            if (mode.copies == 0.0)
                row[i] = std::conj(map.spectrum(mode.mirrored)[i]);
            else
                row[i] = mode.real ? amplitude * pair.real() : amplitude / std::numbers::sqrt2 * pair;
        }
    }
    map.spectrum(0)[0] = 0.0;
}

} // namespace

int mapColumns(const DiskSurface& s) { return static_cast<int>(std::lround(s.track / s.cell)); }
int mapRows(const DiskSurface& s) { return static_cast<int>(std::lround(s.trackWidth / s.cell)); }

std::vector<double> generateRoughness(const DiskSurface& surface, const std::function<bool()>& goOn)
{
    Array map(mapColumns(surface), mapRows(surface));
    surface.spectrum == RoughnessSpectrum::SelfAffine ? powerOfSelfAffine(surface, map)
                                                      : powerFromCovariance(surface, map, goOn);
    drawAmplitudes(surface.seed, map, goOn);
    if (stops(goOn)) return {};
    map.transform(false);

    const auto columns = static_cast<std::size_t>(map.nx), rows = static_cast<std::size_t>(map.ny);
    for (int j = 0; j < map.ny; ++j)
        std::copy_n(map.row(j), columns, map.values.data() + static_cast<std::size_t>(j) * columns);
    map.values.resize(columns * rows);

    double sum = 0.0, squares = 0.0;
    for (const double h : map.values) sum += h;
    const double mean = sum / static_cast<double>(map.values.size());
    for (const double h : map.values) squares += (h - mean) * (h - mean);
    const double scale = surface.rms / std::sqrt(squares / static_cast<double>(map.values.size()));
    for (double& h : map.values) h = (h - mean) * scale;
    return std::move(map.values);
}

RequestedSpectrum::RequestedSpectrum(const DiskSurface& surface) : surface_(surface)
{
    // The mean has no height: the other waves of the period make up the variance.
    const int nx = mapColumns(surface), ny = mapRows(surface);
    const double qx = 2.0 * pi / (nx * surface.cell), qy = 2.0 * pi / (ny * surface.cell);
    if (surface.spectrum != RoughnessSpectrum::SelfAffine) {
        scale_ = surface.rms * surface.rms / (1.0 - density(0.0) * qx * qy);
        return;
    }
    const auto copies = [](int i, int n) { return i == 0 || 2 * i == n ? 1.0 : 2.0; }; // of wave i and wave n - i
    double sum = -density(0.0);
    for (int j = 0; j <= ny / 2; ++j)
        for (int i = 0; i <= nx / 2; ++i) sum += copies(i, nx) * copies(j, ny) * density(std::hypot(i * qx, j * qy));
    scale_ = surface.rms * surface.rms / (sum * qx * qy);
}

double RequestedSpectrum::density(double q) const
{
    const DiskSurface& s = surface_;
    const double u = q * s.correlationLength, area = s.correlationLength * s.correlationLength;
    switch (s.spectrum) {
    case RoughnessSpectrum::Gaussian: return scale_ * area / (4.0 * pi) * std::exp(-0.25 * u * u);
    case RoughnessSpectrum::Exponential: return scale_ * area / (2.0 * pi) * std::pow(1.0 + u * u, -1.5);
    case RoughnessSpectrum::SelfAffine: break;
    }
    const double rollOff = 2.0 * pi / s.rollOff, cutOff = 2.0 * pi / s.cutOff * (1.0 + 1e-9);
    return q > cutOff ? 0.0 : q <= rollOff ? scale_ : scale_ * std::pow(q / rollOff, -2.0 - 2.0 * s.hurst);
}

RequestedPsd RequestedSpectrum::profile(double q, int modes) const
{
    const DiskSurface& s = surface_;
    const int ny = mapRows(s);
    const double across = 2.0 * pi / (ny * s.cell);
    double sum = 0.0, squares = 0.0;
    for (int j = 0; j < ny; ++j) {
        const double c = density(std::hypot(q, std::min(j, ny - j) * across));
        sum += c;
        squares += c * c;
    }
    RequestedPsd psd;
    if (s.spectrum == RoughnessSpectrum::SelfAffine) {
        psd.density = 2.0 * across * sum;
    } else {
        // The transform of the autocovariance at the points along one row; all that is folded is in it.
        const double step = s.cell / s.correlationLength;
        const int reach = static_cast<int>(reachOf(s.spectrum) / step);
        double covariance = 0.0;
        for (int m = reach; m >= 0; --m)
            covariance += (m > 0 ? 2.0 : 1.0) * repeatedCorrelation(s.spectrum, m * step, 0.0, 0.0, ny * step) *
                          std::cos(q * s.cell * m);
        psd.density = scale_ * s.cell / pi * std::max(0.0, covariance);
    }
    if (squares == 0.0) return psd;
    const double spread = 2.0 / (9.0 * 2.0 * modes * sum * sum / squares);
    const auto quantile = [&](double normal) {
        return std::pow(std::max(0.0, 1.0 - spread + normal * std::sqrt(spread)), 3.0);
    };
    psd.low = psd.density * quantile(-normalQuantile);
    psd.high = psd.density * quantile(normalQuantile);
    return psd;
}

} // namespace touchdown
