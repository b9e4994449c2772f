// SPDX-License-Identifier: GPL-3.0-or-later
//
// What rails and edges do to the minimum spacing, in colours, arrows and words over a plan.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/physics/slider/surface_edit.h"
#include "ui/plot/colour_scale.h"

namespace touchdown {

class SurfaceView;

/// What parts do to the minimum spacing: of rails to their recess, of edges to their shift outwards [m/m].
using ShownInfluence = std::vector<std::pair<SurfacePart, double>>;

/// Of the change of the minimum spacing with the recess of a rail [m/m]; nothing where no rail has one.
std::optional<ColourScale> influenceScale(const ShownInfluence& influence, const PlotTheme& theme);
/// The whole slider, its rails filled by their influence alone.
void paintInfluenceTops(QPainter& painter, const SurfaceView& plan, const ShownInfluence& influence,
                        const PlotTheme& theme);
/// On each edge an arrow to where it must move to raise the minimum spacing.
void paintInfluenceArrows(QPainter& painter, const SurfaceView& plan, const ShownInfluence& influence,
                          const PlotTheme& theme);
/// What the colours and arrows of an influence mean, with two digits.
QString influenceWords(const ShownInfluence& influence);
/// "10 nm more recess: −0.12 nm", or of a shift of an edge; empty where it is not known.
QString influenceText(const ShownInfluence& influence, const SurfacePart& part);

} // namespace touchdown
