// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the mouse takes a cursor. Over frequency to a peak: a local maximum of the curve that leads, the newest run.
// Its place is between the samples, by a parabola through the logarithms, as that of the peaks with labels
// (core/numerics/spectrum.h). In a phase portrait to the point of a curve that is nearest.
#pragma once

#include <optional>

#include "ui/plot/plot_widget.h"

namespace touchdown {

/// The peak nearest to `x` within `reach` [px], as the plot is zoomed now: a local maximum that is higher than all
/// points within `reach` of it. Nothing where there is none.
std::optional<double> peakNear(const PlotWidget& plot, double x, double reach);

/// Whether there is a local maximum exactly at `x`, where peakNear() put a cursor; at any zoom.
bool isAtPeak(const PlotWidget& plot, double x);

/// The time of the first point within half a pixel of `pixel` on the visible curves of a phase portrait, else of the
/// nearest one, within the time window that is shown. Nothing without curves.
std::optional<double> phaseTimeNear(const PlotWidget& plot, const QPointF& pixel);

} // namespace touchdown
