// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_chart_drawing.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "ui/plot/plot_painter.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr double margin = 14.0;                    // about everything [px]
constexpr double partGap = 8.0;                    // between title, legend, panels, caption
constexpr double betweenX = 18.0, betweenY = 12.0; // panels
constexpr double goodShape = 0.74;                 // height of a panel in its widths

QFont titleFontOf(const QFont& font)
{
    QFont title = plotTextFont(font);
    title.setPixelSize(static_cast<int>(std::lround(1.12 * title.pixelSize())));
    title.setWeight(QFont::DemiBold);
    return title;
}

double wrappedHeight(const QFont& font, const std::string& text, double width)
{
    if (text.empty()) return 0.0;
    return std::ceil(
        QFontMetricsF(font).boundingRect(QRectF(0.0, 0.0, width, 1e5), Qt::TextWordWrap, readable(text)).height());
}

struct Raster {
    int columns = 1, rows = 1;
};

/// As many columns as have room, and no more than fill the last row well.
Raster rasterOf(std::size_t panels, const QFont& font, double width)
{
    const int count = std::max(1, static_cast<int>(panels));
    const int room = static_cast<int>((width - 2.0 * margin + betweenX) / (leastPanelSize(font).width() + betweenX));
    Raster raster;
    raster.columns = std::clamp(room, 1, count);
    raster.rows = (count + raster.columns - 1) / raster.columns;
    raster.columns = (count + raster.rows - 1) / raster.rows;
    return raster;
}

double heightWith(const StudyChart& chart, const QFont& font, double width, double panelHeight)
{
    const double inner = width - 2.0 * margin;
    const PlotTheme theme = lightPlotTheme();
    const StudyLegend legend(chart, ChartStyles(chart), theme, font);
    const Raster raster = rasterOf(chart.panels.size(), font, width);
    double height = 2.0 * margin + raster.rows * panelHeight + (raster.rows - 1) * betweenY;
    for (const double part : {wrappedHeight(titleFontOf(font), chart.title, inner), legend.height(inner),
                              wrappedHeight(plotNumberFont(font), chart.caption, inner)})
        if (part > 0.0) height += part + partGap;
    return std::ceil(height);
}

} // namespace

double StudyChartDrawing::leastHeight(const StudyChart& chart, const QFont& font, double width)
{
    return heightWith(chart, font, width, leastPanelSize(font).height());
}

double StudyChartDrawing::goodHeight(const StudyChart& chart, const QFont& font, double width)
{
    const Raster raster = rasterOf(chart.panels.size(), font, width);
    const double panelWidth = (width - 2.0 * margin - (raster.columns - 1) * betweenX) / raster.columns;
    const double shape = raster.columns == 1 ? 0.75 * goodShape : goodShape;
    return heightWith(chart, font, width, std::max(leastPanelSize(font).height(), shape * panelWidth));
}

StudyChartDrawing::StudyChartDrawing(const StudyChart& chart, const PlotTheme& theme, const QFont& font,
                                     const QSizeF& size, const std::vector<std::optional<PanelRange>>& zoomed,
                                     bool underWay)
    : chart_(chart),
      theme_(theme),
      titleFont_(titleFontOf(font)),
      captionFont_(plotNumberFont(font)),
      size_(size),
      styles_(chart),
      legend_(chart, styles_, theme_, font, underWay)
{
    const double width = std::max(40.0, size.width() - 2.0 * margin);
    double top = margin, bottom = size.height() - margin;
    const double title = wrappedHeight(titleFont_, chart.title, width);
    title_ = QRectF(margin, top, width, title);
    if (title > 0.0) top += title + partGap;
    legendBox_ = QRectF(margin, top, width, legend_.height(width));
    if (legendBox_.height() > 0.0) top += legendBox_.height() + partGap;
    const double caption = wrappedHeight(captionFont_, chart.caption, width);
    caption_ = QRectF(margin, bottom - caption, width, caption);
    if (caption > 0.0) bottom -= caption + partGap;

    const Raster raster = rasterOf(chart.panels.size(), font, size.width());
    const double panelWidth = (width - (raster.columns - 1) * betweenX) / raster.columns;
    const double panelHeight = std::max(60.0, (bottom - top - (raster.rows - 1) * betweenY) / raster.rows);
    panels_.reserve(chart.panels.size());
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const auto column = static_cast<double>(i % static_cast<std::size_t>(raster.columns));
        const auto row = static_cast<double>(i / static_cast<std::size_t>(raster.columns));
        const QRectF box(margin + column * (panelWidth + betweenX), top + row * (panelHeight + betweenY), panelWidth,
                         panelHeight);
        panels_.emplace_back(chart.panels[i], styles_, theme_, font, box, i < zoomed.size() ? zoomed[i] : std::nullopt);
    }
}

void StudyChartDrawing::paint(QPainter& painter) const
{
    painter.fillRect(QRectF(QPointF(), size_), theme_.background);
    painter.setPen(theme_.text);
    painter.setFont(titleFont_);
    painter.drawText(title_, Qt::TextWordWrap, readable(chart_.title));
    legend_.paint(painter, legendBox_);
    for (const StudyPanel& panel : panels_) panel.paint(painter);
    painter.setPen(theme_.mutedText);
    painter.setFont(captionFont_);
    painter.drawText(caption_, Qt::TextWordWrap, readable(chart_.caption));
}

} // namespace touchdown
