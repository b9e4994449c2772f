// SPDX-License-Identifier: GPL-3.0-or-later
//
// The menu of the right mouse button over a plot: fit, back and forth, scales, curves shown, copy, save.
#pragma once

#include "ui/plot/plot_group.h"

namespace touchdown {

/// From now on a right click on `plot` opens its menu; failures to save are shown in a message box that blocks nothing.
/// `page`, when given, holds `plot` and others and can be saved as a whole; it must outlive `plot`.
void installPlotMenu(PlotWidget* plot, PlotGroup* group, QWidget* page = nullptr);

} // namespace touchdown
