// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which curves of a plot the legend names, and where: in one row on the screen, in as many as it needs on paper.
#pragma once

#include <vector>

#include <QFont>
#include <QRectF>
#include <QString>

#include "ui/plot/plot_curve.h"

namespace touchdown {

struct LegendEntry {
    const PlotCurve* curve;
    QString text; // shortened where it is long
    QRectF box;   // [px]
};
struct Legend {
    static constexpr double sample = 20.0; // length of the piece of line in front of a text [px]

    std::vector<LegendEntry> entries; // from left to right
    std::size_t more = 0;             // that have no room
    double height = 0.0;              // of all rows [px]
};

/// At the right of `row`, the newest run first. A curve that is called `title` needs no entry.
Legend legendInRow(const std::vector<PlotCurve>& curves, const QString& title, const QRectF& row, const QFont& font);

/// All of them, from the corner to the right; texts that are wider than a row are broken into lines.
Legend legendInRows(const std::vector<PlotCurve>& curves, const QString& title, const QPointF& corner, double width,
                    const QFont& font);

} // namespace touchdown
