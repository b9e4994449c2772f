// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture that fills the area of a plot behind its curves, as a spectrogram does.
#pragma once

#include <functional>

#include <QIODevice>
#include <QPainter>

#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

struct PlotBackdrop {
    PlotRange x, y; // the automatic ranges show all of it [units of the axes]
    /// Fills `area` with what the two axes show. At each repaint: what is costly is kept between them.
    std::function<void(QPainter& painter, const QRectF& area, const PlotAxis& x, const PlotAxis& y)> paint;
    /// Beside the title, in place of a legend, at the right of `room`; the width that it takes.
    std::function<double(QPainter& painter, const QRectF& room, const QFont& font, const PlotTheme& theme)> paintKey;
    /// Its numbers as comma-separated values.
    std::function<void(QIODevice& device)> writeData;
};

} // namespace touchdown
