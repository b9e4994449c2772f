// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kept distances on a plan: each is drawn as a dimension, which can be clicked.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/physics/slider/surface_edit.h"
#include "ui/slider/plan_marks.h"

class QPainter;

namespace touchdown {

struct PlotTheme;
struct SurfaceProblem;

/// A line with arrows and its value for each distance, on lines from both of its places. The selected one has the
/// colour of the selection, one with a problem that of a failure.
void paintKeptDistances(QPainter& painter, const SliderPlan& plan, const AirBearingSurface& surface,
                        const PartSelection& selected, const std::vector<SurfaceProblem>& problems,
                        const PlotTheme& theme);

/// The distance whose line or value is there.
std::optional<std::size_t> keptDistanceAt(const SliderPlan& plan, const AirBearingSurface& surface,
                                          const QPointF& pixel);

/// The sentence of what is wrong with a relation; empty: nothing.
QString relationProblem(const std::vector<SurfaceProblem>& problems, const SurfacePart& relation);

} // namespace touchdown
