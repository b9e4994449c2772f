// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far one trajectory lies from another that was sampled at the same times. With e_n = x_n - r_n over N samples:
//
//   final |e_N|,   L2 = sqrt(sum e_n^2 / N),   worst = max |e_n|
//
// and of the last tenth of the run the difference of the means and of the standard deviations; of the spectrum of the
// minimum spacing, that of its largest peak. The final error alone says little: where a motion settles, every method
// ends at rest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace touchdown {

struct MeasuredRun;

enum class ErrorMeasure : std::uint8_t { Final, L2, Worst, Mean, Deviation, PeakFrequency, PeakAmplitude };
inline constexpr std::size_t errorMeasures = 7;
/// "worst", as a study's file names it; "Largest error", as a chart does.
std::string_view name(ErrorMeasure measure);
std::string_view title(ErrorMeasure measure);

/// Magnitudes [unit of the quantity; a frequency Hz, a peak m]; one is missing where the samples do not tell it.
class TrajectoryError {
public:
    std::optional<double> at(ErrorMeasure measure) const { return values_[static_cast<std::size_t>(measure)]; }
    void set(ErrorMeasure measure, double value) { values_[static_cast<std::size_t>(measure)] = value; }

private:
    std::array<std::optional<double>, errorMeasures> values_;
};

/// Of column `column` of both, over the first `samples` samples, or as many as both have. Statistics and spectrum are
/// those of whole runs: they are missing where fewer are compared.
TrajectoryError trajectoryError(const MeasuredRun& run, const MeasuredRun& reference, std::size_t column,
                                std::size_t samples = std::numeric_limits<std::size_t>::max());

/// The first sample at which column 0 of the two is further apart than `distance`; none where they stay together as
/// long as both last.
std::optional<std::size_t> firstApart(const MeasuredRun& a, const MeasuredRun& b, double distance);

} // namespace touchdown
