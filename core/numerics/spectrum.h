// SPDX-License-Identifier: GPL-3.0-or-later
//
// Power spectra by Welch's method (Welch 1967), one-sided, on FFTW's real transforms.
//
// Density: the integral over frequency is the mean square of the windowed, mean-free signal (Parseval).
// Amplitude: a sine of amplitude A that falls on a bin shows A^2/2 there (the power spectrum).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace touchdown {

enum class SpectrumWindow : std::uint8_t { Rectangular, Hann, Hamming, Blackman, FlatTop };
enum class SpectrumScaling : std::uint8_t { Density, Amplitude };

struct WelchOptions {
    SpectrumWindow window = SpectrumWindow::Hann;
    SpectrumScaling scaling = SpectrumScaling::Density;
    std::size_t segment = 2048; // samples, >= 8; cut to the length of the signal
    double overlap = 0.5;       // [0, 0.95]
    bool removeMean = true;     // of each segment
    bool operator==(const WelchOptions&) const = default;
};

struct Spectrum {
    std::vector<double> frequency;         // [Hz], from 0 to half the sampling rate
    std::vector<double> power;             // [unit^2/Hz] or [unit^2]
    std::size_t segment = 0;               // samples used for each segment
    std::size_t segments = 0;              // averaged
    double equivalentNoiseBandwidth = 0.0; // of the window [Hz]
    bool empty() const { return frequency.empty(); }
};

/// Keeps FFTW's plan, window and work arrays for spectra of one length. One thread at a time for each object.
class WelchEstimator {
public:
    explicit WelchEstimator(const WelchOptions& options);
    ~WelchEstimator();
    WelchEstimator(const WelchEstimator&) = delete;
    WelchEstimator& operator=(const WelchEstimator&) = delete;

    /// `signal` sampled every `interval` [s]. Empty when there are fewer than 8 samples.
    Spectrum operator()(std::span<const double> signal, double interval);

private:
    struct Plan;
    WelchOptions options_;
    std::unique_ptr<Plan> plan_;
};

Spectrum welch(std::span<const double> signal, double interval, const WelchOptions& options = {});

/// The top between a local maximum and its neighbours, by a parabola through the logarithms of their powers.
struct PeakTop {
    double offset = 0.0; // from the middle one, -0.5 to 0.5 [bins]
    double power = 0.0;  // [unit of the powers]
};
/// All positive; `middle` is the largest.
PeakTop topBetween(double left, double middle, double right);

/// A local maximum of a spectrum.
struct Peak {
    double frequency = 0.0; // [Hz], between bins by a parabola through the logarithms
    double amplitude = 0.0; // of a sine with that peak [unit]
};
/// The `most` largest peaks, largest first, that exceed their surroundings by at least `prominence` (ratio of powers).
std::vector<Peak> findPeaks(const Spectrum& spectrum, SpectrumScaling scaling, std::size_t most = 5,
                            double prominence = 10.0);

} // namespace touchdown
