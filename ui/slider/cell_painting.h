// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values on the cells of a grid, painted on a plan.
#pragma once

#include <vector>

#include <QPainter>

#include "ui/plot/colour_scale.h"

namespace touchdown {

class SliderPlan;

/// The cell between ascending lines that holds a place; -1: none.
int cellIndex(const std::vector<double>& lines, double at);

/// Cell by cell without smoothing: one value for each cell of the plan's grid, x fastest.
void paintCells(QPainter& painter, const SliderPlan& plan, const std::vector<double>& values, const ColourScale& scale);

} // namespace touchdown
