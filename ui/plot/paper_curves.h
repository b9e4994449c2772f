// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the curves of a plot look in a figure on paper: none is pale, and no two look alike.
#pragma once

#include <cstdint>
#include <vector>

#include <QString>

#include "ui/plot/plot_curve.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

enum class PaperColours : std::uint8_t { Coloured, Black };

/// White paper, black ink. Coloured curves have the colours of the screen; black ones are black, then grey.
PlotTheme paperTheme(PaperColours colours);

/// What curves look like in a figure of several panels.
struct PaperStyle {
    QString name; // of the run, or of the curve
    bool run = false;
    CurveStyle screen, paper;
};

/// The visible curves with samples. Where several runs are shown, the legend names the run of every curve. Coloured: as
/// on the screen, but with another dash where a curve would look like one before it. Black: each has the next dash, and
/// after the fourth they are grey. `styles`: of the panels before, receives those that are new: a run, or a curve of
/// that name, looks the same in each panel as long as no two of one panel look alike.
std::vector<PlotCurve> paperCurves(const std::vector<PlotCurve>& curves, PaperColours colours,
                                   std::vector<PaperStyle>& styles);
std::vector<PlotCurve> paperCurves(const std::vector<PlotCurve>& curves, PaperColours colours);

/// How many curves paperCurves() can tell apart.
std::size_t distinctPaperCurves(PaperColours colours);

} // namespace touchdown
