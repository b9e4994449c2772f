// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the editor draws over its plan: the surface as it was last saved, influence, pairs, selection, problems at their
// places, and the gesture. It reads what is shown and knows nothing of how it came about.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/physics/slider/surface_check.h"
#include "ui/slider/influence_painting.h"
#include "ui/slider/surface_selection.h"
#include "ui/slider/surface_view.h"

namespace touchdown {

/// What a gesture of the mouse shows.
struct GestureMarks {
    bool dragging = false;
    QPointF pointer;                     // [px]
    std::optional<SurfaceShift> shift;   // of what is dragged, before a number is typed [m]
    std::optional<SurfacePart> hovered;  // under the pointer
    std::optional<SnappedPlace> snap;    // of the place that is dragged or measured
    std::optional<SurfacePoint> boxFrom; // a rectangle is drawn from here to the pointer [m]
    std::vector<SurfacePoint> polygon;   // under way [m]
    std::vector<SurfacePoint> measured;  // one place or two [m]
    std::vector<SurfacePoint> drawing;   // corners of the drawing under the plan [m]
};

/// All that is shown over the plan.
struct EditMarks {
    const SurfaceSelection& selection;
    const GestureMarks& gesture;
    const AirBearingSurface& ghost; // as it was last saved
    const ShownInfluence& influence;
    const std::vector<SurfaceProblem>&problems, &warnings; // of the surface that is shown
    const std::vector<SurfaceProblem>& knownWarnings;      // of the ghost: their sentences wait for the pointer
};
void paintEditMarks(QPainter& painter, const SurfaceView& plan, const EditMarks& marks, const PlotTheme& theme);

/// Where the symbol of a link is drawn and clicked [px].
QPointF linkSymbol(const SliderPlan& plan, const PairLink& link);
/// The first rail of the link whose symbol is there.
std::optional<std::size_t> linkAt(const SliderPlan& plan, const std::vector<PairLink>& links, const QPointF& pixel);

/// What holds the place that is dragged or measured: "corner 2 of rail 3", "centre line", "border".
QStringList snapWords(const GestureMarks& gesture);
/// Distance, its parts along x and y, and its angle to x; empty where nothing is measured.
QString measureText(const GestureMarks& gesture);

} // namespace touchdown
