// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks, labels and grid lines that are seen on any colour.
#pragma once

#include <vector>

#include <QPainter>

#include "ui/plot/plot_theme.h"

namespace touchdown {

class SliderPlan;
struct CellGrid;

/// Rectangles with text; later text avoids them.
using TakenRoom = std::vector<QRectF>;

/// Draws the text in a small box about `centre`; draws nothing and returns false where there is other text.
bool paintPlanLabel(QPainter& painter, const QPointF& centre, const QString& text, const PlotTheme& theme,
                    TakenRoom& taken);

/// A circle for a point of interest, a triangle downwards for a minimum and upwards for a maximum.
struct PlanMark {
    enum class Kind { Interest, Minimum, Maximum };
    QPointF at; // [px]
    Kind kind = Kind::Interest;
    QString text;
};

/// Each text is drawn beside its mark, if there is room, preferably towards the middle of the clip.
void paintPlanMarks(QPainter& painter, const std::vector<PlanMark>& marks, const PlotTheme& theme, TakenRoom& taken);

/// The borders of the cells.
void paintCellGrid(QPainter& painter, const SliderPlan& plan, const CellGrid& grid);

} // namespace touchdown
