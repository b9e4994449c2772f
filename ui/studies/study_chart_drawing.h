// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of a study's chart: title, legend, panels (side by side, or stacked where the chart is narrow) and caption.
// The same on the screen and on paper.
#pragma once

#include <optional>
#include <vector>

#include "ui/studies/study_legend.h"
#include "ui/studies/study_panel.h"

namespace touchdown {

class StudyChartDrawing {
public:
    /// `chart` must outlive this. `zoomed` has a range, or nothing, for each panel, or is empty. `underWay`: there is
    /// more of the chart to come.
    StudyChartDrawing(const StudyChart& chart, const PlotTheme& theme, const QFont& font, const QSizeF& size,
                      const std::vector<std::optional<PanelRange>>& zoomed = {}, bool underWay = false);
    StudyChartDrawing(const StudyChartDrawing&) = delete;
    StudyChartDrawing& operator=(const StudyChartDrawing&) = delete;

    void paint(QPainter& painter) const;
    const std::vector<StudyPanel>& panels() const { return panels_; }
    const StudyLegend& legend() const { return legend_; }

    /// The smallest height at which a chart of this width is readable, and the best one.
    static double leastHeight(const StudyChart& chart, const QFont& font, double width);
    static double goodHeight(const StudyChart& chart, const QFont& font, double width);

private:
    const StudyChart& chart_;
    PlotTheme theme_;
    QFont titleFont_, captionFont_;
    QSizeF size_;
    ChartStyles styles_;
    StudyLegend legend_;
    QRectF title_, legendBox_, caption_;
    std::vector<StudyPanel> panels_;
};

} // namespace touchdown
