// SPDX-License-Identifier: GPL-3.0-or-later
//
// Content of a plot: curves, reference lines and marks, a picture behind them. Numbers are SI; the axis holds the
// factor of the display unit.
#pragma once

#include "ui/plot/min_max_pyramid.h"
#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_theme.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <QIODevice>
#include <QPainter>
#include <QString>

namespace touchdown {

struct PlotCurve {
    QString id;   // unique in its plot: "run 3/flying_height"
    QString name; // in the legend
    CurveStyle style;
    const MinMaxPyramid* data = nullptr;  // not owned: remove the curve before the pyramid goes
    const MinMaxPyramid* xData = nullptr; // a phase portrait: `data` is drawn against this instead of the time
    bool visible = true;
    bool arrows = false; // of a phase portrait: heads along the line point the way of time
    bool inLegend = true;
    bool dots = false;              // one at each sample: what was computed, and what is a line between
    QString legend = {};            // in the legend; empty: the name
    bool pale = false;              // thin and faint, behind the curves that are not
    bool leads = true;              // the automatic ranges are those of the curves that lead
    bool still = false;             // its data do not grow any more
    int run = 0;                    // its number in the list of runs, where others stand beside it
    QString runName = {};           // of that run: "FH 5 nm"
    std::optional<double> end = {}; // its data will grow up to this x: the range of x does not grow with each sample
};

/// A line across the plot: horizontal "d_s = 3 nm", or upright "contact 281.3 kHz". Its label stands outside the area
/// of the curves, at the right or above.
struct ReferenceLine {
    double value = 0.0; // [unit of y], or of x where it is upright
    QString label;
    bool upright = false;
    bool operator==(const ReferenceLine&) const = default;
};

/// Something that happened: a subtle tick at the upper edge, with its name in the tooltip.
struct EventMark {
    double time = 0.0; // [unit of x]
    QString label;     // "touch-down"
};

/// A point with its name beside it: a peak of a spectrum.
struct PointMark {
    double x = 0.0;
    double y = 0.0;
    QString label; // "152.4 kHz"
    CurveStyle style;
};

/// A shaded area behind the curves, with its label inside: the work of a cycle.
struct ShadedArea {
    std::vector<std::pair<double, double>> outline; // x, y
    QString label;                                  // "W = 7.5 pJ"
    CurveStyle style;
};

/// A picture that fills the area of a plot behind its curves, as a spectrogram does.
struct PlotBackdrop {
    PlotRange x, y; // the automatic ranges show all of it [units of the axes]
    /// Fills `area` with what the two axes show. At each repaint: what is costly is kept between them.
    std::function<void(QPainter& painter, const QRectF& area, const PlotAxis& x, const PlotAxis& y)> paint;
    /// Its colour bar, in a row of its own above the area.
    std::function<void(QPainter& painter, const QRectF& row, const QFont& font, const PlotTheme& theme)> paintKey;
    /// Its numbers as comma-separated values.
    std::function<void(QIODevice& device)> writeData;
};

/// The visible ranges of a plot; without a range the axis follows the data.
struct PlotView {
    std::optional<PlotRange> x;
    std::optional<PlotRange> y;
    bool operator==(const PlotView&) const = default;
};

} // namespace touchdown
