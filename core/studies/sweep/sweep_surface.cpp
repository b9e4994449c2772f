// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/studies/sweep/sample_points.h"

namespace touchdown {

namespace {

constexpr double sides = 1.5; // from the middle to a point on an axis, in standard deviations [-]

/// Standard deviation of an even distribution, or of a normal one before it is cut off.
double deviationOf(const SweepAxis& axis)
{
    return axis.deviation > 0.0 ? axis.deviation : (axis.to - axis.from) / (2.0 * std::numbers::sqrt3);
}

} // namespace

std::vector<std::vector<double>> surfaceDesign(const std::vector<SweepAxis>& axes, int seed)
{
    std::vector<double> middle, upper;
    for (const SweepAxis& axis : axes) {
        const bool hasMean = axis.deviation > 0.0 && axis.mean > axis.from && axis.mean < axis.to;
        middle.push_back(hasMean ? axis.mean : axis.at(0.5).number);
        upper.push_back(std::min(middle.back() + sides * deviationOf(axis), axis.to));
    }
    std::vector<std::vector<double>> design{middle};
    for (std::size_t k = 0; k < axes.size(); ++k) {
        design.insert(design.end(), 2, middle);
        (design.end() - 2)->at(k) = std::max(middle[k] - sides * deviationOf(axes[k]), axes[k].from);
        design.back()[k] = upper[k];
    }
    for (std::size_t i = 0; i < axes.size(); ++i)
        for (std::size_t j = i + 1; j < axes.size(); ++j) {
            std::vector<double>& corner = design.emplace_back(middle);
            corner[i] = upper[i];
            corner[j] = upper[j];
        }
    // Other points than those of the samples.
    for (const std::vector<double>& shares :
         samplePoints(SampleMethod::Random, axes.size(), surfaceChecks, ~std::uint64_t(seed))) {
        std::vector<double>& item = design.emplace_back();
        for (std::size_t k = 0; k < axes.size(); ++k) item.push_back(axes[k].at(shares[k]).number);
    }
    return design;
}

ResponseSurface::ResponseSurface(const std::vector<std::vector<double>>& design, std::span<const double> values)
    : middle_(design.front()), there_(values[0])
{
    const std::size_t axes = middle_.size();
    std::vector<double> above, rise; // of the upper points: d, y - y0
    for (std::size_t k = 0; k < axes; ++k) {
        const double low = design[1 + 2 * k][k] - middle_[k], high = design[2 + 2 * k][k] - middle_[k],
                     atLow = values[1 + 2 * k] - there_, atHigh = values[2 + 2 * k] - there_;
        const double determinant = low * high * (low - high);
        slope_.push_back((atHigh * low * low - atLow * high * high) / determinant);
        bend_.push_back((high * atLow - low * atHigh) / determinant);
        above.push_back(high);
        rise.push_back(atHigh);
    }
    std::size_t at = 1 + 2 * axes;
    for (std::size_t i = 0; i < axes; ++i)
        for (std::size_t j = i + 1; j < axes; ++j, ++at)
            mixed_.push_back((values[at] - there_ - rise[i] - rise[j]) / (above[i] * above[j]));
}

double ResponseSurface::at(std::span<const double> x) const
{
    double sum = there_;
    auto mixed = mixed_.begin();
    for (std::size_t i = 0; i < middle_.size(); ++i) {
        const double d = x[i] - middle_[i];
        sum += d * (slope_[i] + bend_[i] * d);
        for (std::size_t j = i + 1; j < middle_.size(); ++j) sum += *mixed++ * d * (x[j] - middle_[j]);
    }
    return sum;
}

} // namespace touchdown
