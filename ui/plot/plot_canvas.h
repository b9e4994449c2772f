// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of a plot on the screen, drawn by Qt Charts, between what PlotPainter draws behind and above them. Those
// of a phase portrait are drawn into an image once for each refresh: they may have gaps and many parts, and their
// cursors are dots that move anywhere.
//
// The chart's own axes stay hidden at 0 to 1 and the points come in parts of the plot area: a range that changed
// would cost a second pass over all points, a logarithmic axis would lose a whole curve to one zero, and the numbers
// of QValueAxis move the plot area.
#pragma once

#include <optional>
#include <vector>

#include <QGraphicsView>
#include <QImage>

class QChart;
class QLineSeries;
class QValueAxis;

namespace touchdown {

class PlotWidget;
struct PlotCurve;

class PlotCanvas : public QGraphicsView {
    Q_OBJECT

public:
    explicit PlotCanvas(PlotWidget* plot);

    struct Line {
        const PlotCurve* curve;
        std::vector<QPointF> path;
    };
    /// In the order in which they are drawn; an empty path hides its line. The picture of still curves is below them.
    void setLines(const std::vector<Line>& lines);
    void setPlotArea(const QRectF& area);
    void setSelection(std::optional<QRectF> box);
    /// Repaints a vertical strip about a cursor only.
    void repaintCursor(double pixel);
    void repaintAll();

protected:
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void drawPhaseLines(const std::vector<Line>& lines);

    const PlotWidget& plot_;
    QGraphicsScene* scene_;
    QChart* chart_;      // owned by the scene
    QValueAxis* across_; // owned by the chart, as are the series
    QValueAxis* up_;
    std::vector<QLineSeries*> series_;
    QImage phaseLines_; // null over time
    std::optional<QRectF> selection_;
};

} // namespace touchdown
