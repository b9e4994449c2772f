// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks, labels and grid lines that stand out of any colour beneath them.
#pragma once

#include <QPainter>

#include "core/numerics/cell_grid.h"
#include "ui/slider_plan.h"

namespace touchdown {

enum class PlanMark { Interest, Minimum, Maximum, Cursor };

/// A small box of paper about `centre` with the text in it.
void paintPlanLabel(QPainter& painter, const QPointF& centre, const QString& text, const PlotTheme& theme);

/// A circle for a point of interest, a triangle downwards for a minimum and upwards for a maximum, a cross for the cursor;
/// the text beside it, towards the middle of the clip.
void paintPlanMark(QPainter& painter, const QPointF& at, PlanMark kind, const QString& text, const PlotTheme& theme);

/// The borders of the cells.
void paintCellGrid(QPainter& painter, const SliderPlan& plan, const CellGrid& grid);

} // namespace touchdown
