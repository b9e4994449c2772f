// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/wall_picture.h"

#include <algorithm>

#include <QPainter>

#include "ui/plot/plot_theme.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

WallPicture::WallPicture(QWidget* parent) : QWidget(parent) { setAccessibleName(tr("Profile of the wall")); }

void WallPicture::setWall(const WallProfile& wall)
{
    wall_ = wall;
    update();
}

void WallPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const PlotTheme theme = plotTheme(palette());
    painter.fillRect(rect(), theme.background);
    const std::size_t count = std::min(wall_.distance.size(), wall_.recess.size());
    if (count < 2) return;
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font());
    const QRectF area = QRectF(rect()).adjusted(12.0, metrics.height() + 8.0, -12.0, -metrics.height() - 8.0);
    const auto [left, right] = std::minmax(wall_.distance.front(), wall_.distance.back());
    const auto [top, bottom] = std::minmax_element(wall_.recess.begin(), wall_.recess.end());
    const auto at = [&](double distance, double recess) {
        const double x = right > left ? (distance - left) / (right - left) : 0.5;
        const double y = *bottom > *top ? (recess - *top) / (*bottom - *top) : 0.5;
        return QPointF(area.left() + x * area.width(), area.top() + y * area.height());
    };
    if (left < 0.0 && right > 0.0) {
        painter.setPen(QPen(theme.grid, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(at(0.0, *top).x(), area.top()), QPointF(at(0.0, *top).x(), area.bottom()));
    }
    QPolygonF curve;
    for (std::size_t i = 0; i < count; ++i) curve << at(wall_.distance[i], wall_.recess[i]);
    painter.setPen(QPen(theme.colour({}), 2.0));
    painter.drawPolyline(curve);
    painter.setBrush(theme.background);
    for (const QPointF& point : curve) painter.drawEllipse(point, 3.0, 3.0);
    painter.setPen(theme.mutedText);
    const auto text = [&](double x, double y, Qt::Alignment how, const QString& words) {
        painter.drawText(QRectF(x, y, area.width(), metrics.height()), int(how | Qt::TextDontClip), words);
    };
    text(area.left(), 2.0, Qt::AlignLeft, tr("recess %1").arg(lengthText(*top, 4)));
    text(area.left(), area.bottom() + 6.0, Qt::AlignRight,
         tr("%1 at %2").arg(lengthText(*bottom, 4), lengthText(right, 4)));
    text(area.left(), area.bottom() + 6.0, Qt::AlignLeft, lengthText(left, 4));
}

} // namespace touchdown
