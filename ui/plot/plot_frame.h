// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands around the area of a plot or of a map: margins, title, ticks, numbers and titles of both axes.
#pragma once

#include <vector>

#include <QFont>
#include <QPainter>

#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

/// In pixels, so that a picture of any resolution has the proportions of the screen.
QFont plotTextFont(const QFont& font);
/// Font of the numbers on the axes: slightly smaller than the text.
QFont plotNumberFont(const QFont& font);

/// A thin line at this pixel fills one row of pixels.
double alignedPixel(double pixel);

/// What labels of reference lines, or a colour bar, need beside the area of the curves.
struct LabelRoom {
    double width = 0.0; // of the widest at the right [px]
    bool above = false; // a row of them
    bool paper = false; // they may take more of the width, as they are not made smaller
};

struct PlotFrame {
    static constexpr double gap = 6.0;          // between things that belong together [px]
    static constexpr double tickLength = 4.0;   // [px]
    static constexpr double leastTitle = 0.7;   // size of an axis title where it has no room, of its usual one
    static constexpr double leastOnPaper = 0.9; // the same there: 7 pt beside a text of 8 pt
    static constexpr double leader = 7.0;       // from a reference line to its label [px]
    static constexpr double mostLabels = 0.18;  // of the width is for labels at the right
    static constexpr double mostOnPaper = 0.35; // the same there

    /// The area within `size`, with room for `widestNumber` at its left and `right` pixels at its right. It depends on
    /// size and font only, so that stacked plots agree and a live plot does not move.
    static QRectF areaWithin(const QSizeF& size, const QFont& font, const QString& widestNumber, double right,
                             bool xNumbers = true);

    /// In which an area has room for two numbers above each other [px].
    static int leastHeight(const QFont& font, bool xNumbers);

    /// The same for curves, with room for labels of reference lines.
    static QRectF curveArea(const QSizeF& size, const QFont& font, bool xNumbers, const LabelRoom& labels);

    /// The axes must outlive the frame; at most `mostUp` numbers on the y axis.
    PlotFrame(const QRectF& plotArea, const QFont& font, const PlotAxis& xAxis, const PlotAxis& yAxis, int mostUp);

    double across(double position) const { return area.left() + position * area.width(); }
    double up(double position) const { return area.bottom() - position * area.height(); }

    /// `width` of the widget: no number reaches beyond it. The ticks of x remain without `xNumbers`.
    void paintNumbers(QPainter& painter, const PlotTheme& theme, double width, bool xNumbers = true) const;
    void paintAxisTitles(QPainter& painter, const PlotTheme& theme, bool xTitle = true) const;
    /// The title above the area, cut to `width`; on paper in as many lines as it needs.
    void paintTitle(QPainter& painter, const PlotTheme& theme, const QString& title, double width,
                    bool lines = false) const;
    double titleHeight(const QString& title, double width) const; // in lines
    double lineHeight() const;                                    // of a text [px]
    double numberHeight() const;                                  // of a number [px]
    double titleWidth(const QString& title, double width) const;

    QRectF area;
    double least = leastTitle; // size of an axis title
    QFont textFont;
    QFont numberFont;
    const PlotAxis* x;
    const PlotAxis* y;
    std::vector<AxisTick> xTicks;
    std::vector<AxisTick> yTicks;
};

} // namespace touchdown
