// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/spectrogram.h"

#include <algorithm>
#include <cassert>

#include "core/numerics/spectrum.h"

namespace touchdown {

Spectrogram spectrogram(std::span<const double> signal, double interval, std::size_t window, std::size_t mostColumns)
{
    const SampleReader read = [signal](std::size_t first, std::span<double> to) {
        std::ranges::copy(signal.subspan(first, to.size()), to.begin());
        return true;
    };
    return spectrogram(signal.size(), read, interval, window, mostColumns);
}

Spectrogram spectrogram(std::size_t samples, const SampleReader& read, double interval, std::size_t window,
                        std::size_t mostColumns)
{
    assert(window >= 8 && mostColumns >= 1);
    Spectrogram result;
    if (samples < window || !(interval > 0.0)) return result;
    const std::size_t hop = window / 2;
    const std::size_t windows = (samples - window) / hop + 1;
    result.window = window;
    result.averaged = (windows + mostColumns - 1) / mostColumns;
    result.columns = (windows + result.averaged - 1) / result.averaged;
    const auto samplesOf = [&](std::size_t count) { return window + (count - 1) * hop; };
    const std::size_t covered = samplesOf(result.averaged);
    result.firstCentre = 0.5 * static_cast<double>(covered - 1) * interval;
    result.step = static_cast<double>(result.averaged * hop) * interval;
    result.timeResolution = static_cast<double>(covered) * interval;

    WelchOptions options;
    options.segment = window;
    WelchEstimator estimator(options);
    std::vector<double> signal; // of a column
    for (std::size_t column = 0; column < result.columns; ++column) {
        const std::size_t first = column * result.averaged;
        const std::size_t count = std::min(result.averaged, windows - first);
        signal.resize(samplesOf(count));
        if (!read(first * hop, signal)) return {};
        const Spectrum spectrum = estimator(signal, interval);
        result.density.insert(result.density.end(), spectrum.power.begin(), spectrum.power.end());
        if (column > 0) continue;
        result.frequency = spectrum.frequency;
        result.frequencyResolution = spectrum.equivalentNoiseBandwidth;
    }
    return result;
}

} // namespace touchdown
