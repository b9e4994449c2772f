// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_canvas.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QPainter>
#include <QResizeEvent>
#include <QValueAxis>

#include "ui/plot/plot_painter.h"
#include "ui/plot/plot_path.h"

namespace touchdown {

PlotCanvas::PlotCanvas(PlotWidget* plot)
    : QGraphicsView(plot),
      plot_(*plot),
      scene_(new QGraphicsScene(this)),
      chart_(new QChart),
      across_(new QValueAxis),
      up_(new QValueAxis)
{
    setScene(scene_);
    scene_->setItemIndexMethod(QGraphicsScene::NoIndex);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(NoViewportUpdate); // repaintAll and repaintCursor know better
    setOptimizationFlag(DontSavePainterState, false);
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents); // the plot itself handles the mouse

    chart_->setMargins({});
    chart_->layout()->setContentsMargins(0.0, 0.0, 0.0, 0.0);
    chart_->setBackgroundVisible(false);
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->legend()->hide();
    chart_->setAcceptedMouseButtons(Qt::NoButton);
    chart_->setAcceptHoverEvents(false);
    for (QValueAxis* axis : {across_, up_}) {
        axis->setRange(0.0, 1.0);
        axis->setVisible(false);
    }
    chart_->addAxis(across_, Qt::AlignBottom);
    chart_->addAxis(up_, Qt::AlignLeft);
    scene_->addItem(chart_);
}

void PlotCanvas::setLines(const std::vector<Line>& all)
{
    phaseLines_ = {};
    if (plot_.isPhasePortrait()) drawPhaseLines(all);
    const std::vector<Line> lines = plot_.isPhasePortrait() ? std::vector<Line>() : all;
    while (series_.size() < lines.size()) {
        auto* series = new QLineSeries;
        chart_->addSeries(series);
        series->attachAxis(across_);
        series->attachAxis(up_);
        series_.push_back(series);
    }
    while (series_.size() > lines.size()) {
        chart_->removeSeries(series_.back());
        delete series_.back();
        series_.pop_back();
    }
    const QSizeF size = plot_.plotArea().size();
    const bool wide = plot_.hasPaleCurves();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto& [curve, path] = lines[i];
        if (path.empty()) {
            if (series_[i]->count() > 0) series_[i]->clear();
            continue;
        }
        QPen pen = pathPen(*curve, path, size, plot_.theme(), wide);
        // The chart strokes an invisible outline of the line each time, for clicks on it; this is the cheapest one.
        pen.setJoinStyle(Qt::BevelJoin);
        if (series_[i]->pen() != pen) series_[i]->setPen(pen);
        series_[i]->replace(QList<QPointF>(path.begin(), path.end()));
    }
}

void PlotCanvas::drawPhaseLines(const std::vector<Line>& lines)
{
    const QRectF area(QPointF(), plot_.plotArea().size());
    const double sharp = devicePixelRatioF();
    phaseLines_ = QImage((area.size() * sharp).toSize(), QImage::Format_ARGB32_Premultiplied);
    phaseLines_.setDevicePixelRatio(sharp);
    phaseLines_.fill(Qt::transparent);
    QPainter painter(&phaseLines_);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [curve, path] : lines) {
        painter.setPen(pathPen(*curve, path, area.size(), plot_.theme(), plot_.hasPaleCurves()));
        drawPath(painter, path, area);
    }
}

void PlotCanvas::setPlotArea(const QRectF& area) { chart_->setPlotArea(area); }

void PlotCanvas::setSelection(std::optional<QRectF> box)
{
    selection_ = box;
    repaintAll();
}

void PlotCanvas::repaintCursor(double pixel)
{
    const double reach = fontMetrics().height(); // of the tag with the cursor's number
    viewport()->update(QRectF(pixel - reach, 0.0, 2.0 * reach, height()).toAlignedRect());
}

void PlotCanvas::repaintAll() { viewport()->update(); }

void PlotCanvas::drawBackground(QPainter* painter, const QRectF& rect)
{
    painter->fillRect(rect, plot_.theme().background);
    PlotPainter(plot_, plot_.theme()).paintBehind(*painter);
    plot_.stillPicture().paint(*painter, plot_.plotArea());
    plot_.phasePicture().paint(*painter);
    if (!phaseLines_.isNull()) painter->drawImage(plot_.plotArea().topLeft(), phaseLines_);
}

void PlotCanvas::drawForeground(QPainter* painter, const QRectF& /*rect*/)
{
    const PlotPainter above(plot_, plot_.theme());
    above.paintAbove(*painter);
    above.paintCursors(*painter);
    if (selection_) above.paintSelection(*painter, *selection_);
}

void PlotCanvas::resizeEvent(QResizeEvent* event)
{
    QGraphicsView::resizeEvent(event);
    scene_->setSceneRect(QRectF(QPointF(), event->size()));
    chart_->setGeometry(scene_->sceneRect());
}

} // namespace touchdown
