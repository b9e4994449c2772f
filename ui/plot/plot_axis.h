// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis: its range, the ticks at 1, 2 or 5 times a power of ten, and the text of their numbers.
#pragma once

#include "ui/plot/min_max_pyramid.h"

#include <vector>

#include <QString>

namespace touchdown {

/// Title and unit of an axis.
struct AxisLabel {
    QString title;       // "Flying height"; may be empty
    QString unit;        // the display unit, "nm"; may be empty
    double factor = 1.0; // of the display unit in SI: 1e-9 for nm
    AxisScale scale = AxisScale::Linear;
    bool operator==(const AxisLabel&) const = default;
};

struct AxisTick {
    double value = 0.0; // SI
    QString text;       // empty for a minor tick
    bool major = true;
};

class PlotAxis {
public:
    AxisLabel label;

    const PlotRange& range() const { return range_; }
    /// Refuses an empty, infinite or too small range, and zero or less on a logarithmic axis, by taking the nearest
    /// that can be drawn.
    void setRange(PlotRange range);

    bool logarithmic() const { return label.scale == AxisScale::Logarithmic; }
    /// 0 at the lower end, 1 at the upper. On a logarithmic axis a value of zero or less lies far below the lower end.
    double position(double value) const;
    double valueAt(double position) const;
    /// The range seen when [from, to] of the axis (0 to 1) fills it.
    PlotRange part(double from, double to) const;

    /// Not more than `most` major ticks, but at least two on a linear axis.
    std::vector<AxisTick> ticks(int most) const;
    /// "Flying height [nm]", or "Energy [10⁻⁶ J]" where the numbers need a common power, or "Time − 1.25 [ms]"
    /// far zoomed in.
    QString text() const;

    /// A number of this axis in its display unit with digits that resolve a thousandth of the range: "7.013".
    QString number(double value) const;
    /// The same with four digits of a value that is small beside the range, as long as it is above a millionth of it.
    QString reading(double value) const;

private:
    /// Keeps the numbers short: shown = value / (factor 10^exponent) - offset.
    struct Notation {
        int exponent = 0;    // a multiple of 3
        double offset = 0.0; // [display unit 10^exponent]
        int offsetDecimals = 0;
    };
    Notation notation() const;
    std::vector<AxisTick> linearTicks(int most) const;
    std::vector<AxisTick> logarithmicTicks(int most, double decades) const;

    PlotRange range_;
};

/// 10 to the power as "10⁻³".
QString powerOfTen(int exponent);

/// The smallest of 1, 2, 5 times a power of ten that is not below `value` > 0.
double niceStep(double value);

/// A range about the data that only moves when it must: kept while the data stay inside and fill more than half of it.
/// `unit` is the width for data that are zero all over.
PlotRange autoscaled(const PlotRange& data, const PlotRange& current, AxisScale scale, double unit);

} // namespace touchdown
