// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tool that measures between two places.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainter>

#include "ui/slider/part_picking.h"
#include "ui/slider/surface_editor.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

/// Without a mouse: between two selected corners or points of interest, or along a selected edge.
void SurfaceEditor::chooseMeasure()
{
    std::vector<SurfacePoint> places;
    for (const SurfacePart& part : selection_)
        if (part.kind == PartKind::Corner || part.kind == PartKind::Interest)
            places.push_back(placeOf(committed_, part, {}));
    if (selection_.size() == 1 && selection_.begin()->kind == PartKind::Edge) {
        const std::vector<RailPoint>& points = committed_.rails[selection_.begin()->item].points;
        for (const std::size_t k : {selection_.begin()->index, (selection_.begin()->index + 1) % points.size()})
            places.push_back({points[k].x, points[k].y});
    }
    if (places.size() == 2) measured_ = places;
    update();
}

void SurfaceEditor::addMeasured(const SurfacePoint& at)
{
    if (measured_.size() == 2) measured_.clear();
    if (measured_.empty() || measured_.front() != at) measured_.push_back(at);
    update();
}

QString SurfaceEditor::measureText() const
{
    if (measured_.empty()) return {};
    const bool underWay = measured_.size() == 1;
    if (underWay && !snap_) return {};
    const SurfacePoint from = measured_.front(), to = underWay ? snap_->at : measured_.back();
    const double dx = to.x - from.x, dy = to.y - from.y;
    const auto micrometres = [](double length) { return typeset(length * 1e6, 2); };
    return tr("%1 µm   dx %2   dy %3   %4°")
        .arg(micrometres(std::hypot(dx, dy)), micrometres(dx), micrometres(dy),
             typeset(std::atan2(dy, dx) * 180.0 / std::numbers::pi, 2));
}

void SurfaceEditor::paintMeasure(QPainter& painter, const PlotTheme& theme) const
{
    const QString text = measureText();
    if (text.isEmpty()) return;
    const QPointF from = toPixel(measured_.front()), to = toPixel(measured_.size() == 2 ? measured_.back() : snap_->at);
    const double length = std::max(std::hypot(to.x() - from.x(), to.y() - from.y()), 1e-9);
    const QPointF across = 6.0 * QPointF(from.y() - to.y(), to.x() - from.x()) / length;
    for (const QPen& pen : {QPen(theme.background, 4.0), QPen(theme.text, 1.6)}) {
        painter.setPen(pen);
        painter.drawLine(from, to);
        for (const QPointF& end : {from, to}) painter.drawLine(end - across, end + across);
    }
    painter.setFont(font());
    const double half = 0.5 * QFontMetricsF(font()).horizontalAdvance(text) + 8.0;
    // Above a flat line; beside a steep one, at the right where there is room.
    QPointF at = 0.5 * (from + to);
    if (std::abs(across.y()) > std::abs(across.x()))
        at.ry() -= 18.0;
    else
        at.rx() += at.x() + 2.0 * half + 8.0 < planArea().right() ? half + 8.0 : -half - 8.0;
    const double left = planArea().left() + half;
    at.setX(std::clamp(at.x(), left, std::max(left, planArea().right() - half)));
    TakenRoom taken;
    paintPlanLabel(painter, at, text, theme, taken);
}

} // namespace touchdown
