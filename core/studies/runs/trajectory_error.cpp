// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/trajectory_error.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/numerics/moments.h"

namespace touchdown {

std::string_view name(ErrorMeasure measure)
{
    switch (measure) {
    case ErrorMeasure::Final: return "final";
    case ErrorMeasure::L2: return "l2";
    case ErrorMeasure::Worst: return "worst";
    case ErrorMeasure::Mean: return "mean";
    case ErrorMeasure::Deviation: return "deviation";
    case ErrorMeasure::PeakFrequency: return "peak-frequency";
    case ErrorMeasure::PeakAmplitude: return "peak-amplitude";
    }
    return {};
}

std::string_view title(ErrorMeasure measure)
{
    switch (measure) {
    case ErrorMeasure::Final: return "Error at the end";
    case ErrorMeasure::L2: return "Root mean square error";
    case ErrorMeasure::Worst: return "Largest error";
    case ErrorMeasure::Mean: return "Error of the mean over the last tenth";
    case ErrorMeasure::Deviation: return "Error of the standard deviation over the last tenth";
    case ErrorMeasure::PeakFrequency: return "Error of the largest peak's frequency";
    case ErrorMeasure::PeakAmplitude: return "Error of the largest peak's amplitude";
    }
    return {};
}

TrajectoryError trajectoryError(const MeasuredRun& run, const MeasuredRun& reference, std::size_t column,
                                std::size_t samples)
{
    const std::vector<double>& x = run.columns[column];
    const std::vector<double>& r = reference.columns[column];
    const std::size_t count = std::min({x.size(), r.size(), samples});
    TrajectoryError error;
    if (count == 0) return error;
    double squares = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double e = std::abs(x[i] - r[i]);
        squares += e * e;
        worst = std::max(worst, e);
    }
    error.set(ErrorMeasure::Final, std::abs(x[count - 1] - r[count - 1]));
    error.set(ErrorMeasure::L2, std::sqrt(squares / static_cast<double>(count)));
    error.set(ErrorMeasure::Worst, worst);
    if (count < r.size() || count < x.size()) return error;
    const std::size_t tail = std::max<std::size_t>(1, static_cast<std::size_t>(tailShare * static_cast<double>(count)));
    const Moments a = momentsOf(std::span(x).last(tail)), b = momentsOf(std::span(r).last(tail));
    error.set(ErrorMeasure::Mean, std::abs(a.mean - b.mean));
    error.set(ErrorMeasure::Deviation, std::abs(a.deviation - b.deviation));
    const auto &found = run.summary.peaks, &wanted = reference.summary.peaks;
    if (found.empty() || wanted.empty()) return error;
    error.set(ErrorMeasure::PeakFrequency, std::abs(found.front().frequency - wanted.front().frequency));
    error.set(ErrorMeasure::PeakAmplitude, std::abs(found.front().amplitude - wanted.front().amplitude));
    return error;
}

std::optional<std::size_t> firstApart(const MeasuredRun& a, const MeasuredRun& b, double distance)
{
    const std::vector<double>& x = a.columns[0];
    const std::vector<double>& y = b.columns[0];
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
        if (!(std::abs(x[i] - y[i]) <= distance)) return i;
    return {};
}

} // namespace touchdown
