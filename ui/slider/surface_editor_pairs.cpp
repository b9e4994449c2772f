// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of mirror rails: their links on the plan, broken and joined by a click.
#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/slider/part_picking.h"
#include "ui/slider/rail_drawing.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

namespace {

constexpr double linkReach = 10.0;        // of the symbol from its middle [px]
const QPointF besideTheNumber{18.0, 0.0}; // of a rail [px]

/// Two links of a chain; apart where it is broken.
void paintChain(QPainter& painter, const QPointF& at, bool broken)
{
    const double apart = broken ? 5.5 : 3.0;
    for (const double side : {-1.0, 1.0})
        painter.drawRoundedRect(QRectF(at.x() - 2.5, at.y() + side * apart - 4.0, 5.0, 8.0), 2.5, 2.5);
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
    noPairs_ = false;
    if (!pairs_ || !problems_.empty()) return;
    const auto images = mirrorImages(committed_, area().height(), pairReach);
    noPairs_ = std::ranges::none_of(images, [](const auto& image) { return image.has_value(); });
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

QPointF SurfaceEditor::symbolOf(const PairLink& link) const { return toPixel(link.middle()) + besideTheNumber; }

std::optional<std::size_t> SurfaceEditor::linkAt(const QPointF& pixel) const
{
    if (tool_ != Tool::Select || dragging()) return {};
    for (const PairLink& link : links_)
        if (const QPointF away = symbolOf(link) - pixel; std::hypot(away.x(), away.y()) < linkReach) return link.rail;
    return {};
}

void SurfaceEditor::paintLinks(QPainter& painter, const PlotTheme& theme) const
{
    if (dragging()) return;
    if (noPairs_) {
        TakenRoom taken;
        painter.setFont(font());
        const QString text = tr("No mirror images within 0.1 µm");
        const double half = 0.5 * QFontMetricsF(font()).horizontalAdvance(text) + 8.0;
        paintPlanLabel(painter, planArea().bottomLeft() + QPointF(half, -14.0), text, theme, taken);
    }
    painter.setBrush(Qt::NoBrush);
    for (const PairLink& link : links_) {
        const QPointF middle = symbolOf(link);
        const QPointF from = toPixel(link.from) + besideTheNumber, to = toPixel(link.to) + besideTheNumber;
        const QPen thin(theme.text, 1.2, link.broken ? Qt::DotLine : Qt::SolidLine);
        for (const QPen& pen : {QPen(theme.background, 3.2), thin}) {
            painter.setPen(pen);
            painter.drawLine(from, to);
        }
        painter.setPen(QPen(theme.background, 1.0));
        painter.setBrush(theme.background);
        painter.drawEllipse(middle, linkReach, linkReach);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(link.broken ? theme.mutedText : theme.text, 1.6));
        paintChain(painter, middle, link.broken);
    }
}

} // namespace touchdown
