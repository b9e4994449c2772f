// SPDX-License-Identifier: GPL-3.0-or-later
//
// From samples to the line that is drawn, in parts of the plot area: 0 to 1, y upwards.
#pragma once

#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_curve.h"

#include <vector>

#include <QPainter>
#include <QPolygonF>

namespace touchdown {

/// A curve over x, thinned to the pixels and cut a little outside the area, so that no coordinate is too large to draw.
/// `waits`: see MinMaxPyramid::thinned.
std::vector<QPointF> timePath(const MinMaxPyramid& data, const PlotAxis& x, const PlotAxis& y, int pixels,
                              bool* waits = nullptr);

/// `yData` against `xData` within a window of time, from every sample held; points closer than 0.7 pixels to the last
/// one are omitted. A path of more than `mostWhole` points is drawn in parts: see withoutCovered(). `waits`: as above,
/// but then there are no points.
std::vector<QPointF> phasePath(const MinMaxPyramid& xData, const MinMaxPyramid& yData, const PlotRange& window,
                               const PlotAxis& x, const PlotAxis& y, const QSizeF& pixels, bool* waits = nullptr,
                               std::size_t mostWhole = 20'000);

/// The lines of `path` inside the area, in the order of time, that pass at least one pixel through which no line before
/// them passes: the same pixels are drawn, and there are at most as many lines as pixels. Between lines that do not
/// follow each other stands a point that is not a number: the pen is lifted there. Lines are followed pixel by pixel
/// over `mostFollowed` pixels in total; beyond that only the pixels of their ends count, so that the cost is bounded
/// and still each sample's pixel is drawn.
std::vector<QPointF> withoutCovered(const std::vector<QPointF>& path, const QSizeF& pixels,
                                    std::size_t mostFollowed = 10'000'000);

/// The parts of a line inside the area, cut at its border: for pictures whose format cannot clip. A point that is not a
/// number separates two parts.
std::vector<QPolygonF> insideArea(const std::vector<QPointF>& path);

/// Where the way of a line is shown, and the direction there in pixels (y upwards, length 1): a few places along what
/// lies inside the area; none on a line so long that its way cannot be followed.
struct PathArrow {
    QPointF tip; // in parts of the plot area
    QPointF along;
};
std::vector<PathArrow> pathArrows(const std::vector<QPointF>& path, const QSizeF& pixels);

/// The pen for a way there and back: where it returns on itself, beside its turning point and beside its ends, its
/// dashes cover each other instead of filling each other's gaps.
QPen penThereAndBack(const std::vector<QPointF>& path, const QSizeF& pixels, QPen pen);

/// The pen that draws `path`, the line of `curve`: solid where the line is folded many times, as it would be broken
/// into thousands of invisible dashes. `wide`: beside pale curves.
QPen pathPen(const PlotCurve& curve, const std::vector<QPointF>& path, const QSizeF& pixels, const PlotTheme& theme,
             bool wide = false);

/// A curve over x without the points that lie on a straight line to a tenth of a pixel: smooth and level parts need
/// few points, and a line costs by their number.
std::vector<QPointF> withoutStraightPoints(const std::vector<QPointF>& path, const QSizeF& pixels);

/// The parts of `path` inside `area` [px].
void drawPath(QPainter& painter, const std::vector<QPointF>& path, const QRectF& area);

/// Heads of arrows in the middle of `path`, where pathArrows() has them.
void drawArrows(QPainter& painter, const std::vector<QPointF>& path, const QRectF& area, const QColor& colour);

/// The length of a line without its gaps [px].
double pathLength(const std::vector<QPointF>& path, const QSizeF& pixels);

} // namespace touchdown
