// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/spectrum.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>

#include "core/numerics/fourier.h"

namespace touchdown {
namespace {

constexpr std::size_t shortestSegment = 8;

// w_i = a_0 - a_1 cos(2 pi i/n) + a_2 cos(4 pi i/n) - ...: periodic ("DFT-even"), so that the window's
// own spectrum has its zeros on the bins. Coefficients: Harris 1978; flat top: D'Antona & Ferrero 2006.
std::vector<double> cosineWindow(std::size_t n, std::initializer_list<double> coefficients)
{
    std::vector<double> w(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        double harmonic = 0.0;
        double sign = 1.0;
        for (double a : coefficients) {
            w[i] += sign * a * std::cos(harmonic * angle);
            harmonic += 1.0;
            sign = -sign;
        }
    }
    return w;
}

std::vector<double> makeWindow(SpectrumWindow window, std::size_t n)
{
    switch (window) {
    case SpectrumWindow::Rectangular: return cosineWindow(n, {1.0});
    case SpectrumWindow::Hann: return cosineWindow(n, {0.5, 0.5});
    case SpectrumWindow::Hamming: return cosineWindow(n, {0.54, 0.46});
    case SpectrumWindow::Blackman: return cosineWindow(n, {0.42, 0.5, 0.08});
    case SpectrumWindow::FlatTop:
        return cosineWindow(n, {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368});
    }
    return cosineWindow(n, {1.0});
}

// Whether the power falls to `base` between bin `top` and anything higher, or the end, in one direction.
bool fallsTo(double base, const std::vector<double>& power, std::size_t top, std::ptrdiff_t direction)
{
    const auto end = direction > 0 ? static_cast<std::ptrdiff_t>(power.size()) : std::ptrdiff_t{-1};
    for (std::ptrdiff_t k = static_cast<std::ptrdiff_t>(top) + direction; k != end; k += direction) {
        const double p = power[static_cast<std::size_t>(k)];
        if (p <= base) return true;
        if (p > power[top]) return false;
    }
    return false;
}

// A parabola through the logarithms of three bins: its top in bins from the middle one, and its value.
} // namespace

struct WelchEstimator::Plan {
    std::vector<double> window;
    double sum = 0.0;     // of w
    double squares = 0.0; // of w^2
    double* signal = nullptr;
    fftw_complex* transform = nullptr;
    fftw_plan forward = nullptr;

    Plan(SpectrumWindow kind, std::size_t n) : window(makeWindow(kind, n))
    {
        for (double w : window) {
            sum += w;
            squares += w * w;
        }
        const std::lock_guard lock(fourierPlanner());
        signal = fftw_alloc_real(n);
        transform = fftw_alloc_complex(n / 2 + 1);
        // Estimated, not measured: a measured plan, and with it the last digits, would differ from run to run.
        if (signal && transform) forward = fftw_plan_dft_r2c_1d(static_cast<int>(n), signal, transform, FFTW_ESTIMATE);
        if (!forward) {
            release();
            throw std::bad_alloc();
        }
    }
    ~Plan()
    {
        const std::lock_guard lock(fourierPlanner());
        release();
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;

    // signal = window * (x - mean)
    void load(std::span<const double> x, bool removeMean)
    {
        const std::size_t n = window.size();
        double mean = 0.0;
        if (removeMean) {
            for (double value : x) mean += value;
            mean /= static_cast<double>(n);
        }
        double largest = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double deviation = x[i] - mean;
            largest = std::max(largest, std::abs(deviation));
            signal[i] = window[i] * deviation;
        }
        // A constant leaves the rounding of its mean; as a spectrum it would show false peaks.
        const double rounding = static_cast<double>(n) * std::numeric_limits<double>::epsilon() * std::abs(mean);
        if (removeMean && largest <= rounding) std::fill_n(signal, n, 0.0);
    }

private:
    void release()
    {
        if (forward) fftw_destroy_plan(forward);
        fftw_free(signal);
        fftw_free(transform);
    }
};

WelchEstimator::WelchEstimator(const WelchOptions& options) : options_(options)
{
    options_.segment = std::max(options_.segment, shortestSegment);
    options_.overlap = std::clamp(options_.overlap, 0.0, 0.95);
}

WelchEstimator::~WelchEstimator() = default;

Spectrum WelchEstimator::operator()(std::span<const double> signal, double interval)
{
    Spectrum result;
    if (signal.size() < shortestSegment || !(interval > 0.0)) return result;

    const std::size_t n = std::min(options_.segment, signal.size());
    if (!plan_ || plan_->window.size() != n) plan_ = std::make_unique<Plan>(options_.window, n);
    Plan& plan = *plan_;

    const auto shared = static_cast<std::size_t>(std::floor(options_.overlap * static_cast<double>(n)));
    const std::size_t hop = n - shared;
    const std::size_t bins = n / 2 + 1;
    result.power.assign(bins, 0.0);
    for (std::size_t first = 0; first + n <= signal.size(); first += hop) {
        plan.load(signal.subspan(first, n), options_.removeMean);
        fftw_execute(plan.forward);
        for (std::size_t k = 0; k < bins; ++k) {
            const double re = plan.transform[k][0];
            const double im = plan.transform[k][1];
            result.power[k] += re * re + im * im;
        }
        ++result.segments;
    }

    // One-sided: every bin but the first, and the last of an even n, stands for +f and -f.
    const double scale =
        options_.scaling == SpectrumScaling::Density ? interval / plan.squares : 1.0 / (plan.sum * plan.sum);
    for (std::size_t k = 0; k < bins; ++k) {
        const bool single = k == 0 || 2 * k == n;
        result.power[k] *= (single ? 1.0 : 2.0) * scale / static_cast<double>(result.segments);
    }
    result.segment = n;
    result.equivalentNoiseBandwidth = plan.squares / (plan.sum * plan.sum * interval);
    result.frequency.resize(bins);
    const double length = static_cast<double>(n) * interval;
    for (std::size_t k = 0; k < bins; ++k) result.frequency[k] = static_cast<double>(k) / length;
    return result;
}

Spectrum welch(std::span<const double> signal, double interval, const WelchOptions& options)
{
    return WelchEstimator(options)(signal, interval);
}

PeakTop topBetween(double left, double middle, double right)
{
    // Beside a sine on a bin an unwindowed spectrum holds nothing but rounding, whose logarithm means nothing.
    const double floor = 1e-12 * middle;
    const double a = std::log(std::max(left, floor) / middle);
    const double c = std::log(std::max(right, floor) / middle);
    const double curvature = a + c;
    if (!(curvature < 0.0)) return {0.0, middle};
    const double offset = 0.5 * (a - c) / curvature;
    return {offset, middle * std::exp(-0.25 * (a - c) * offset)};
}

std::vector<Peak> findPeaks(const Spectrum& spectrum, SpectrumScaling scaling, std::size_t most, double prominence)
{
    const std::vector<double>& power = spectrum.power;
    std::vector<Peak> peaks;
    if (power.size() < 3) return peaks;
    // A transform rounds to about 1e-16 of its largest amplitude: what is below 1e-12 of it is no signal.
    const double rounding = 1e-24 * *std::max_element(power.begin(), power.end());
    for (std::size_t k = 1; k + 1 < power.size(); ++k) {
        const bool local = power[k] > power[k - 1] && power[k] >= power[k + 1];
        if (!local || power[k] <= rounding) continue;
        const double base = power[k] / prominence;
        if (!fallsTo(base, power, k, -1) || !fallsTo(base, power, k, 1)) continue;

        const PeakTop top = topBetween(power[k - 1], power[k], power[k + 1]);
        // A density counts the sine's power over the window's noise bandwidth.
        const double bandwidth = scaling == SpectrumScaling::Density ? spectrum.equivalentNoiseBandwidth : 1.0;
        peaks.push_back(
            {(static_cast<double>(k) + top.offset) * spectrum.frequency[1], std::sqrt(2.0 * top.power * bandwidth)});
    }
    std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.amplitude > b.amplitude; });
    if (peaks.size() > most) peaks.resize(most);
    return peaks;
}

} // namespace touchdown
