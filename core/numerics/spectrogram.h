// SPDX-License-Identifier: GPL-3.0-or-later
//
// Power spectral density over time: the signal in windows that overlap by half, each with Welch's method
// (core/numerics/spectrum.h: Hann window, without its mean). Where there are more windows than columns are wanted,
// neighbours are averaged into one column; the last column has those that remain.
//
// The window length n decides both resolutions: n dt in time, and in frequency the equivalent noise bandwidth of the
// window, 1.5/(n dt) for Hann. Their product does not depend on n.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace touchdown {

struct Spectrogram {
    std::vector<double> frequency; // [Hz], from 0 to half the sampling rate
    std::vector<double> density;   // column after column, one value for each frequency [unit^2/Hz]
    std::size_t columns = 0;
    std::size_t window = 0;           // samples
    std::size_t averaged = 0;         // windows in each column
    double firstCentre = 0.0;         // of the first column, after the first sample [s]
    double step = 0.0;                // between columns [s]
    double timeResolution = 0.0;      // what one column covers [s]
    double frequencyResolution = 0.0; // equivalent noise bandwidth [Hz]

    bool empty() const { return columns == 0; }
    double at(std::size_t column, std::size_t bin) const { return density[column * frequency.size() + bin]; }
};

/// `signal` sampled every `interval` [s]; `window` samples, at least 8; at most `mostColumns`, at least 1. Empty where
/// the signal is shorter than the window.
Spectrogram spectrogram(std::span<const double> signal, double interval, std::size_t window, std::size_t mostColumns);

/// Copies the samples from `first` on; false: give up, the result is then empty.
using SampleReader = std::function<bool(std::size_t first, std::span<double> to)>;
/// The same of a signal of so many samples that is read column by column, so that the whole need not be in memory.
Spectrogram spectrogram(std::size_t samples, const SampleReader& read, double interval, std::size_t window,
                        std::size_t mostColumns);

} // namespace touchdown
