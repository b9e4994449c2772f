// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of mirror rails: their links on the plan, broken and joined by a click.
#include <cmath>

#include <QPainter>

#include "ui/slider/part_picking.h"
#include "ui/slider/rail_drawing.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

namespace {

constexpr double linkReach = 10.0; // of the symbol from its middle [px]

/// Two links of a chain; apart where it is broken.
void paintChain(QPainter& painter, const QPointF& at, bool broken)
{
    const double apart = broken ? 8.0 : 4.0;
    for (const double side : {-1.0, 1.0})
        painter.drawRoundedRect(QRectF(at.x() - 3.0, at.y() + side * apart - 5.0, 6.0, 10.0), 3.0, 3.0);
}

} // namespace

void SurfaceEditor::setPairs(bool on)
{
    pairs_ = on;
    findLinks();
}

AirBearingSurface SurfaceEditor::movedSelection(SurfaceShift by) const
{
    return pairs_ ? movedInPairs(committed_, selection_, by, area().height(), pairReach, single_)
                  : moved(committed_, selection_, by);
}

void SurfaceEditor::findLinks()
{
    links_.clear();
    update();
    if (!pairs_ || !problems_.empty()) return;
    const auto images = mirrorImages(committed_, area().height(), pairReach);
    const std::vector<SurfacePoint> inside = railNumberPoints(committed_);
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (!images[i] || images[i]->rail <= i) continue;
        const std::size_t image = images[i]->rail;
        const SurfacePoint to{inside[i].x, area().height() - inside[i].y}; // straight across the centre line
        links_.push_back({i, image, single_.contains(i) || single_.contains(image), inside[i], to});
    }
}

void SurfaceEditor::togglePair(std::size_t rail)
{
    for (const PairLink& link : links_) {
        if (link.rail != rail && link.image != rail) continue;
        for (const std::size_t each : {link.rail, link.image})
            if (link.broken)
                single_.erase(each);
            else
                single_.insert(each);
    }
    findLinks();
}

std::optional<std::size_t> SurfaceEditor::linkAt(const QPointF& pixel) const
{
    if (tool_ != Tool::Select || dragging()) return {};
    for (const PairLink& link : links_)
        if (const QPointF away = toPixel(link.middle()) - pixel; std::hypot(away.x(), away.y()) < linkReach)
            return link.rail;
    return {};
}

void SurfaceEditor::paintLinks(QPainter& painter, const PlotTheme& theme) const
{
    if (dragging()) return;
    painter.setBrush(Qt::NoBrush);
    for (const PairLink& link : links_) {
        const QPointF from = toPixel(link.from), to = toPixel(link.to), middle = toPixel(link.middle());
        const QPen thin(theme.selection, 1.0, link.broken ? Qt::DotLine : Qt::SolidLine);
        for (const QPen& pen : {QPen(theme.background, 3.0), thin}) {
            painter.setPen(pen);
            painter.drawLine(from, to);
        }
        painter.setPen(QPen(theme.background, 1.0));
        painter.setBrush(theme.background);
        painter.drawEllipse(middle, linkReach + 4.0, linkReach + 4.0);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(link.broken ? theme.mutedText : theme.selection, 2.0));
        paintChain(painter, middle, link.broken);
    }
}

} // namespace touchdown
