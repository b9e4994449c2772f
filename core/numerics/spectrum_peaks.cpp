// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/spectrum.h"

#include <algorithm>
#include <cmath>

namespace touchdown {
namespace {

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
struct Top {
    double offset = 0.0;
    double power = 0.0;
};
Top interpolate(double left, double middle, double right)
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

} // namespace

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

        const Top top = interpolate(power[k - 1], power[k], power[k + 1]);
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
