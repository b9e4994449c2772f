// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_peak.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "core/numerics/spectrum.h"

namespace touchdown {

namespace {

const MinMaxPyramid* leadingData(const PlotWidget& plot)
{
    for (const PlotCurve& curve : plot.curves() | std::views::reverse)
        if (curve.visible && curve.leads && curve.data && !curve.xData && !curve.data->empty()) return curve.data;
    return nullptr;
}

/// Nothing where the sample is no local maximum.
std::optional<double> placeOfPeak(const MinMaxPyramid& data, std::size_t i)
{
    if (i == 0 || i + 1 >= data.size()) return std::nullopt;
    const double left = data.value(i - 1);
    const double middle = data.value(i);
    const double right = data.value(i + 1);
    if (!(left > 0.0) || !(right > 0.0) || !(middle > left) || !(middle >= right)) return std::nullopt;
    const double before = data.time(i) - data.time(i - 1);
    const double after = data.time(i + 1) - data.time(i);
    const bool even = std::abs(after - before) < 1e-3 * after; // else a sample without power was left out
    return data.time(i) + (even ? topBetween(left, middle, right).offset * after : 0.0);
}

} // namespace

std::optional<double> peakNear(const PlotWidget& plot, double x, double reach)
{
    const MinMaxPyramid* data = leadingData(plot);
    if (!data) return std::nullopt;
    const PlotAxis& axis = plot.xAxis();
    const double part = reach / plot.plotArea().width();
    const auto around = [&](double at) { return axis.part(axis.position(at) - part, axis.position(at) + part); };
    const PlotRange seen = around(x);
    const auto [within, beyond] = data->samplesWithin(seen.low, seen.high);
    // The top may lie between two samples, of which the higher one is out of reach.
    const std::size_t begin = within > 0 ? within - 1 : 0;
    const std::size_t end = std::min(beyond + 1, data->size());
    std::optional<double> nearest;
    for (std::size_t i = begin; i < end; ++i) {
        const std::optional<double> place = placeOfPeak(*data, i);
        if (!place || !seen.contains(*place)) continue;
        if (nearest &&
            std::abs(axis.position(*place) - axis.position(x)) >= std::abs(axis.position(*nearest) - axis.position(x)))
            continue;
        const PlotRange beside = around(data->time(i));
        const auto extremes = data->extremes(beside.low, beside.high);
        if (extremes && extremes->high <= data->value(i)) nearest = place;
    }
    return nearest;
}

bool isAtPeak(const PlotWidget& plot, double x)
{
    const MinMaxPyramid* data = leadingData(plot);
    return data && placeOfPeak(*data, data->nearest(x)) == x;
}

} // namespace touchdown
