// SPDX-License-Identifier: GPL-3.0-or-later
//
// The key of a colour scale: a bar with values.
#pragma once

#include <vector>

#include <QPainter>

#include "ui/plot/colour_scale.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

/// The column that a bar with these numbers needs beside it [px].
double colourBarWidth(const QFont& font, const std::vector<ScaleTick>& ticks);

/// How many numbers find room along a bar of this height.
int colourBarRoom(const QFont& font, double height);

/// Upright, with its numbers at the right and `title` ("kPa") above it; the lowest value stands below unless
/// `downwards`.
void paintColourBar(QPainter& painter, const QRectF& column, const QFont& font, const PlotTheme& theme,
                    const ColourScale& scale, const std::vector<ScaleTick>& ticks, const QString& title,
                    bool downwards = false);

} // namespace touchdown
