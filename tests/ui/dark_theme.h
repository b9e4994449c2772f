// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colours of plots on a dark desktop.
#pragma once

#include <QPalette>

#include "ui/plot/plot_theme.h"

namespace touchdown {

inline PlotTheme darkPlotTheme()
{
    QPalette dark;
    dark.setColor(QPalette::Base, QColor("#1d2024"));
    dark.setColor(QPalette::Text, QColor("#eef1f4"));
    dark.setColor(QPalette::Highlight, QColor("#5aa7ee"));
    return plotTheme(dark);
}

} // namespace touchdown
