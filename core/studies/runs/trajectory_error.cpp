// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/trajectory_error.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/numerics/moments.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

namespace {

struct MeasureText {
    std::string_view name, title;
};
constexpr std::array<MeasureText, errorMeasures> texts{{
    {"final", "Error at the end"},
    {"l2", "Root mean square error"},
    {"worst", "Largest error"},
    {"mean", "Error of the mean over the last tenth"},
    {"deviation", "Error of the standard deviation over the last tenth"},
    {"peak-frequency", "Error of the largest peak's frequency"},
    {"peak-amplitude", "Error of the largest peak's amplitude"},
}};

} // namespace

std::string_view name(ErrorMeasure measure) { return texts[static_cast<std::size_t>(measure)].name; }
std::string_view title(ErrorMeasure measure) { return texts[static_cast<std::size_t>(measure)].title; }

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
