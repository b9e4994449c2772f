// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything of a plot but its curves: paper, grid, axes, legend, marks, cursors. The same on the screen and on paper.
#pragma once

#include "ui/plot/plot_frame.h"
#include "ui/plot/plot_widget.h"

namespace touchdown {

struct LegendEntry {
    const PlotCurve* curve;
    QString text; // shortened where it is long
    QRectF box;   // [px]
};
struct Legend {
    std::vector<LegendEntry> entries; // from left to right
    std::size_t more = 0;             // that have no room
};

class PlotPainter {
public:
    /// Both must outlive the painter.
    PlotPainter(const PlotWidget& plot, const PlotTheme& theme);

    void paintBehind(QPainter& painter) const;
    void paintAbove(QPainter& painter) const;
    /// The curves themselves, cut at the border: for pictures. On the screen Qt Charts draws them.
    void paintCurves(QPainter& painter) const;
    void paintCursors(QPainter& painter) const;
    void paintSelection(QPainter& painter, const QRectF& box) const;
    /// Beside the title; the newest run first.
    Legend legend() const;

private:
    void paintHeader(QPainter& painter) const;
    void paintShadedAreas(QPainter& painter) const;
    bool isSeen(const ReferenceLine& line) const;
    void paintReferenceLines(QPainter& painter) const;
    void paintReferenceLabels(QPainter& painter) const;
    void paintEventMarks(QPainter& painter) const;
    void paintArrows(QPainter& painter) const;
    void paintDots(QPainter& painter) const;
    void paintCursorTag(QPainter& painter, int which, const QPointF& bottomLeft) const;
    void paintPointMarks(QPainter& painter) const;
    void paintLabel(QPainter& painter, const QRectF& box, const QString& text, const QColor& colour) const;

    const PlotWidget& plot_;
    const PlotTheme& theme_;
    QRectF area_;
    PlotFrame frame_;
};

} // namespace touchdown
