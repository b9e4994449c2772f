// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/units.h"
#include "core/studies/study/study.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

// A band further away from the points is not shown: it would push them together.
constexpr double furthestDecades = 1.5; // on a logarithmic axis
constexpr double furthestShare = 0.5;   // of the width of the points, on a linear axis

constexpr double equalWithin = 1e-6; // of the value
constexpr double levelShare = 0.1;   // of the value, on each side of the line

AxisLabel labelOf(const ChartAxis& axis)
{
    const std::string& unit = axis.displayUnit.empty() ? axis.unit : axis.displayUnit;
    return {readable(axis.label), unitText(unit), axis.displayUnit.empty() ? 1.0 : unitFactor(axis.displayUnit),
            axis.logarithmic ? AxisScale::Logarithmic : AxisScale::Linear};
}

/// Values that one axis must show.
struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    void add(double value, bool logarithmic)
    {
        if (!std::isfinite(value) || (logarithmic && value <= 0.0)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool empty() const { return low > high; }
    /// Values that are equal but for rounding are a level line, in the middle of numbers that are easy to read.
    void widenLevel()
    {
        const double middle = 0.5 * (low + high), size = std::abs(middle);
        if (high - low <= equalWithin * size) *this = {middle - levelShare * size, middle + levelShare * size};
    }
};

PlotRange withMargin(const Extent& extent, const AxisLabel& label)
{
    if (extent.empty())
        return label.scale == AxisScale::Logarithmic ? PlotRange{0.1 * label.factor, 10.0 * label.factor}
                                                     : PlotRange{0.0, label.factor};
    if (label.scale != AxisScale::Logarithmic)
        return autoscaled({extent.low, extent.high}, {}, AxisScale::Linear, label.factor);
    const double low = std::log10(extent.low), high = std::log10(extent.high);
    const double margin = std::max(0.06 * (high - low), 0.15);
    return {std::pow(10.0, low - margin), std::pow(10.0, high + margin)};
}

void addBand(Extent& extent, const Extent& points, const ChartBand& band, bool logarithmic)
{
    for (const double end : {band.lower, band.upper}) {
        const double outside =
            points.empty() ? 0.0
            : logarithmic  ? std::max(std::log10(points.low / end), std::log10(end / points.high))
                           : std::max(points.low - end, end - points.high) / std::max(points.high - points.low, 1e-300);
        if (outside <= (logarithmic ? furthestDecades : furthestShare)) extent.add(end, logarithmic);
    }
}

} // namespace

PanelAxes panelAxes(const ChartPanel& panel, const std::optional<PanelRange>& zoomed)
{
    PanelAxes axes;
    axes.x.label = labelOf(panel.x);
    axes.y.label = labelOf(panel.y);
    if (zoomed) {
        axes.x.setRange(zoomed->x);
        axes.y.setRange(zoomed->y);
        return axes;
    }
    const bool logX = panel.x.logarithmic, logY = panel.y.logarithmic;
    Extent x, y;
    for (const ChartSeries& series : panel.series)
        for (const ChartPoint& point : series.points)
            for (const double side : {-1.0, 1.0}) {
                x.add(point.x + side * point.xError, logX);
                y.add(point.y + side * point.yError, logY);
            }
    if (panel.map) {
        for (const double edge : cellEdges(panel.map->x, logX)) x.add(edge, logX);
        for (const double edge : cellEdges(panel.map->y, logY)) y.add(edge, logY);
        // The cells reach to the edges of the panel.
        if (panel.series.empty() && !x.empty() && !y.empty()) {
            axes.x.setRange({x.low, x.high});
            axes.y.setRange({y.low, y.high});
            return axes;
        }
    }
    if (!logX) x.widenLevel();
    if (!logY) y.widenLevel();
    const Extent pointsX = x, pointsY = y;
    for (const ChartBand& band : panel.bands)
        band.alongX ? addBand(x, pointsX, band, logX) : addBand(y, pointsY, band, logY);
    axes.x.setRange(withMargin(x, axes.x.label));
    axes.y.setRange(withMargin(y, axes.y.label));
    return axes;
}

void equaliseScales(PanelAxes& axes, const QSizeF& area)
{
    if (axes.x.logarithmic() || axes.y.logarithmic() || area.isEmpty()) return;
    const PanelRange range = axes.range();
    const double unit = std::max(range.x.width() / area.width(), range.y.width() / area.height()); // [per px]
    const auto widened = [unit](const PlotRange& r, double pixels) {
        const double middle = 0.5 * (r.low + r.high);
        return PlotRange{middle - 0.5 * unit * pixels, middle + 0.5 * unit * pixels};
    };
    axes.x.setRange(widened(range.x, area.width()));
    axes.y.setRange(widened(range.y, area.height()));
}

std::vector<double> cellEdges(const std::vector<double>& middles, bool logarithmic)
{
    if (middles.empty()) return {};
    const auto to = [logarithmic](double value) { return logarithmic ? std::log(value) : value; };
    const auto from = [logarithmic](double value) { return logarithmic ? std::exp(value) : value; };
    if (middles.size() == 1) {
        const double only = middles.front();
        if (logarithmic) return {only / 2.0, only * 2.0};
        const double half = only == 0.0 ? 0.5 : 0.5 * std::abs(only);
        return {only - half, only + half};
    }
    std::vector<double> edges;
    edges.push_back(from(1.5 * to(middles[0]) - 0.5 * to(middles[1])));
    for (std::size_t i = 1; i < middles.size(); ++i) edges.push_back(from(0.5 * (to(middles[i - 1]) + to(middles[i]))));
    edges.push_back(from(1.5 * to(middles.back()) - 0.5 * to(middles[middles.size() - 2])));
    return edges;
}

} // namespace touchdown
