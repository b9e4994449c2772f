// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks, labels and grid lines that stand out of any colour beneath them.
#pragma once

#include <vector>

#include <QPainter>

#include "core/numerics/cell_grid.h"
#include "ui/slider/slider_plan.h"

namespace touchdown {

/// Rectangles with text; later text avoids them.
using TakenRoom = std::vector<QRectF>;

/// A small box of paper about `centre` with the text in it; false, and nothing, where other text stands.
bool paintPlanLabel(QPainter& painter, const QPointF& centre, const QString& text, const PlotTheme& theme,
                    TakenRoom& taken);

/// A circle for a point of interest, a triangle downwards for a minimum and upwards for a maximum.
struct PlanMark {
    enum class Kind { Interest, Minimum, Maximum };
    QPointF at; // [px]
    Kind kind = Kind::Interest;
    QString text;
};

/// The text stands beside its mark where there is room, towards the middle of the clip first; without room the mark
/// stands alone.
void paintPlanMarks(QPainter& painter, const std::vector<PlanMark>& marks, const PlotTheme& theme, TakenRoom& taken);

/// The borders of the cells.
void paintCellGrid(QPainter& painter, const SliderPlan& plan, const CellGrid& grid);

} // namespace touchdown
