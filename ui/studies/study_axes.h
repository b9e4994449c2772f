// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axes of a panel of a study's chart: the range that shows everything, equal scales, and the borders of a map's
// cells.
#pragma once

#include <optional>
#include <vector>

#include <QSizeF>

#include "ui/plot/plot_axis.h"

namespace touchdown {

struct ChartPanel;

struct PanelRange {
    PlotRange x, y; // [SI]
    bool operator==(const PanelRange&) const = default;
};

struct PanelAxes {
    PlotAxis x, y;
    PanelRange range() const { return {x.range(), y.range()}; }
};

/// Ranges with round ends that show all points, their errors, the map and the bands nearby; or the range `zoomed`.
PanelAxes panelAxes(const ChartPanel& panel, const std::optional<PanelRange>& zoomed = {});

/// Widens one axis until a unit of x is as long as one of y on an area of this size.
void equaliseScales(PanelAxes& axes, const QSizeF& area);

/// One border more than there are cells: half way between the middles, in the logarithm on a logarithmic axis.
std::vector<double> cellEdges(const std::vector<double>& middles, bool logarithmic);

} // namespace touchdown
