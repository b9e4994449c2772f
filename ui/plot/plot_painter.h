// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything of a plot but its curves: paper, grid, axes, numbers, titles, legend, marks, cursors. The same on the
// screen and on paper.
#pragma once

#include "ui/plot/plot_widget.h"

#include <QFont>
#include <QPainter>

namespace touchdown {

class PlotPainter {
public:
    PlotPainter(const PlotWidget& plot, const PlotTheme& theme);

    /// Where the curves go. It depends on size and font only, so that stacked plots agree and a live plot stands still.
    static QRectF plotArea(const QSizeF& size, const QFont& font, bool xNumbers);

    void paintBehind(QPainter& painter) const;
    void paintAbove(QPainter& painter) const;
    /// The curves themselves, cut at the border: for pictures. The screen leaves them to Qt Charts.
    void paintCurves(QPainter& painter) const;
    void paintCursors(QPainter& painter) const;
    void paintSelection(QPainter& painter, const QRectF& box) const;

private:
    double across(double position) const { return area_.left() + position * area_.width(); }
    double up(double position) const { return area_.bottom() - position * area_.height(); }
    std::vector<AxisTick> xTicks() const;
    std::vector<AxisTick> yTicks() const;
    void paintNumbers(QPainter& painter) const;
    void paintAxisTitles(QPainter& painter) const;
    void paintHeader(QPainter& painter) const;
    void paintReferenceLines(QPainter& painter) const;
    void paintReferenceLabels(QPainter& painter) const;
    void paintEventMarks(QPainter& painter) const;
    void paintArrows(QPainter& painter) const;
    void paintPointMarks(QPainter& painter) const;
    void paintLabel(QPainter& painter, const QRectF& box, const QString& text, const QColor& colour) const;

    const PlotWidget& plot_;
    const PlotTheme& theme_;
    QFont textFont_;
    QFont numberFont_;
    QRectF area_;
};

/// In pixels, so that a picture of any resolution has the proportions of the screen.
QFont plotTextFont(const QFont& font);
/// Font of the numbers on the axes: slightly smaller than the text.
QFont plotNumberFont(const QFont& font);

} // namespace touchdown
