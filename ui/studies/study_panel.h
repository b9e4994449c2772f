// SPDX-License-Identifier: GPL-3.0-or-later
//
// One panel of a study's chart in a box: axes, bands, map, series, labels; and the object under a pixel. The same on
// the screen and on paper. Not drawn with Qt Charts: its logarithmic axes drop a whole curve for one number <= 0, and
// it has neither hollow points nor maps.
#pragma once

#include <optional>

#include <QFont>
#include <QPainter>

#include "ui/plot/plot_frame.h"
#include "ui/studies/study_axes.h"
#include "ui/studies/study_chart_style.h"

namespace touchdown {

struct ChartPanel;
struct ChartBand;
struct ChartSeries;

/// The object under a pixel: a point of a series, a cell of the map, or a band; the others are -1.
struct PanelHit {
    int series = -1, point = -1, cell = -1, band = -1;
    bool operator==(const PanelHit&) const = default;
};

class StudyPanel {
public:
    /// Everything that is given by reference must outlive this.
    StudyPanel(const ChartPanel& panel, const ChartStyles& styles, const PlotTheme& theme, const QFont& font,
               const QRectF& box, const std::optional<PanelRange>& zoomed = {});

    void paint(QPainter& painter) const;
    /// A ring around the object under the pointer.
    void paintPointed(QPainter& painter, const PanelHit& hit) const;

    const ChartPanel& panel() const { return panel_; }
    const PanelAxes& axes() const { return axes_; }
    const QRectF& area() const { return area_; }
    QPointF toPixel(double x, double y) const;
    PanelRange rangeOf(const QRectF& box) const;
    std::optional<PanelHit> at(const QPointF& pixel) const;
    /// The object in words, in HTML: series and setting, x and y with their errors and how the point came out; the
    /// class and the sentence of a cell; the label of a band.
    QString reading(const PanelHit& hit) const;
    /// Half of a marker's width [px].
    double radius() const { return radius_; }

private:
    static constexpr int mostUp = 9; // numbers on the upright axis

    QString bandText(const ChartBand& band) const;
    double across(double x) const;
    double up(double y) const;
    QRectF bandBox(const ChartBand& band) const;
    QRectF cellBox(int cell) const;
    std::vector<QPolygonF> polylines(const ChartSeries& series) const;
    bool inside(const QPointF& pixel) const { return area_.adjusted(-1.0, -1.0, 1.0, 1.0).contains(pixel); }

    void layOut();
    PlotFrame frame() const { return {area_, textFont_, axes_.x, axes_.y, mostUp}; }
    void paintGrid(QPainter& painter, const PlotFrame& frame) const;
    void paintMap(QPainter& painter) const;
    void paintBands(QPainter& painter) const;
    /// The label of a band; where the band is out of sight, with an arrow to it.
    QString withArrow(const ChartBand& band) const;
    void paintBandLabels(QPainter& painter, std::vector<QRectF>& taken) const;
    void paintLines(QPainter& painter) const;
    void paintErrors(QPainter& painter) const;
    void paintMarkers(QPainter& painter) const;
    void paintLabels(QPainter& painter) const;
    void paintAxes(QPainter& painter, PlotFrame frame) const;

    const ChartPanel& panel_;
    const ChartStyles& styles_;
    const PlotTheme& theme_;
    QFont textFont_, numberFont_;
    double radius_ = 4.0;
    PanelAxes axes_;
    QRectF box_, area_;
    std::vector<double> xEdges_, yEdges_; // of the map's cells
};

/// The smallest width and height in which a panel can be read.
QSizeF leastPanelSize(const QFont& font);

} // namespace touchdown
