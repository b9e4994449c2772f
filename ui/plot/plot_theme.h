// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours and dashes of plots, light and dark.
//
// The curve colours are those of Okabe and Ito (2008), which the colour-blind can tell apart, darkened or lightened to
// a contrast of at least 3:1 against the background (WCAG 2.1, 1.4.11). Pale curves have no more than that and are
// thin: they stand back.
#pragma once

#include <QColor>
#include <QList>
#include <QPalette>
#include <QPen>

namespace touchdown {

/// How a curve looks in any theme.
struct CurveStyle {
    int colour = 0; // 0 blue, 1 vermilion, 2 green, 3 purple, 4 orange, 5 sky blue, 6 ink; further numbers begin again
    int dash = 0;   // 0 solid, 1 dashed, 2 dotted, 3 dash-dot; further numbers begin again
    bool operator==(const CurveStyle&) const = default;
};

struct PlotTheme {
    QColor background; // around the plot
    QColor plotArea;
    QColor grid;
    QColor axis;
    QColor text;
    QColor mutedText;
    QColor referenceLine;
    QColor cursor;
    QColor selection; // the box that is being dragged
    QList<QColor> curves;
    double width = 1.0; // of lines, where they grow with the text

    QColor colour(const CurveStyle& style) const { return curves[style.colour % curves.size()]; }
    /// The same, faint.
    QColor paleColour(const CurveStyle& style) const;
};

PlotTheme lightPlotTheme(); // also of everything that is printed
/// The one that fits the palette and the font of the application.
PlotTheme plotTheme(const QPalette& palette);

/// 1.5 times the width of the theme. `dashed` false draws a dashed curve solid: a dash says nothing where the line
/// folds within a pixel.
QPen curvePen(const CurveStyle& style, const PlotTheme& theme, bool dashed = true);

/// Thin, faint and solid: for curves behind the wide ones.
QPen palePen(const CurveStyle& style, const PlotTheme& theme);

} // namespace touchdown
