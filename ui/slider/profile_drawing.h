// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a slider over the disk is drawn from the side or from the rear: the length to scale, heights exaggerated.
// Recesses that are deep beside the heights at which pads fly are cut off.
#pragma once

#include <span>

#include <QColor>
#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <QRectF>

#include "ui/plot/min_max_pyramid.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

struct ProfileDrawing {
    static constexpr double belowDisk = 0.12; // of the visible heights
    static constexpr double ceiling = 0.93;   // of the visible heights: deeper recesses end there

    QRectF area;       // [px]
    double size = 0.0; // of the slider along what is drawn [m]
    PlotRange heights; // [m]

    QPointF toPixel(double along, double height) const;
    /// Metres of length drawn as long as one metre of height.
    double exaggeration() const;
    /// Where heights at equal steps over the whole size are drawn, without those that are cut off.
    QPolygonF line(std::span<const double> at) const;

    void paintDisk(QPainter& painter, const PlotTheme& theme) const;
    /// A disk with these heights at equal steps over the whole size.
    void paintDisk(QPainter& painter, const PlotTheme& theme, std::span<const double> at) const;
    /// Marks on the disk that have moved to the right by `distance` [m].
    void paintMotion(QPainter& painter, const PlotTheme& theme, double distance) const;
    /// The body above these heights.
    void paintSlider(QPainter& painter, const QColor& colour, std::span<const double> at) const;
    /// The lower side alone of another slider, which begins where this one does.
    void paintOutline(QPainter& painter, const QPen& pen, double otherSize, std::span<const double> at) const;
    /// Frame, numbers along the slider, in mm, and below them `title` with that unit, then `remark`.
    void paintFrame(QPainter& painter, const PlotTheme& theme, const QString& title, const QString& remark = {}) const;
};

} // namespace touchdown
