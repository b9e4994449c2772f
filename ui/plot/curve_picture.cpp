// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/curve_picture.h"

#include <algorithm>

#include <QPainter>

#include "ui/plot/plot_path.h"
#include "ui/plot/plot_widget.h"

namespace touchdown {

void CurvePicture::update(const PlotWidget& plot)
{
    const QRectF area(QPointF(), plot.plotArea().size());
    const View now{plot.xAxis().range(),     plot.yAxis().range(), plot.xAxis().label.scale,
                   plot.yAxis().label.scale, plot.timeWindow(),    area.size(),
                   plot.devicePixelRatioF(), plot.theme().curves,  plot.theme().plotArea};
    std::vector<Line> wanted;
    std::vector<const PlotCurve*> curves;
    for (const PlotCurve& curve : plot.curves()) {
        if (!holds(curve) || curve.data == nullptr) continue;
        wanted.push_back({curve.id, curve.data, curve.xData, curve.data->size(), curve.style});
        curves.push_back(&curve);
    }
    if (wanted.empty()) {
        image_ = {};
        drawn_.clear();
        return;
    }
    const bool grows = !image_.isNull() && view_ == now && drawn_.size() <= wanted.size() &&
                       std::equal(drawn_.begin(), drawn_.end(), wanted.begin());
    if (!grows) {
        const QSize pixels = (area.size() * now.pixelRatio).toSize();
        if (image_.size() != pixels) image_ = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
        image_.setDevicePixelRatio(now.pixelRatio);
        image_.fill(Qt::transparent);
        view_ = now;
        drawn_.clear();
    }
    if (drawn_.size() == wanted.size()) return;
    QPainter painter(&image_);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = drawn_.size(); i < wanted.size(); ++i) {
        painter.setPen(palePen(curves[i]->style, plot.theme()));
        drawPath(painter, plot.drawnPath(*curves[i]), area);
        ++linesDrawn_;
    }
    drawn_ = std::move(wanted);
}

void CurvePicture::paint(QPainter& painter, const QRectF& area) const
{
    if (!image_.isNull()) painter.drawImage(area.topLeft(), image_);
}

} // namespace touchdown
