// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/outline_layer.h"

#include <algorithm>
#include <utility>

#include "ui/slider/slider_plan.h"

namespace touchdown {

namespace {

constexpr std::size_t mostAlone = 4; // more rails have moved since: the picture is made anew

} // namespace

void paintRailOutline(QPainter& painter, const SliderPlan& plan, const Rail& rail, bool pointed)
{
    QPolygonF outline;
    for (const RailPoint& point : rail.points) outline << plan.toPixel({point.x, point.y});
    // Dark on light tops and light on the dark base: one line in each.
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, pointed ? 230 : 90), pointed ? 4.0 : 2.4));
    painter.drawPolygon(outline);
    painter.setPen(QPen(QColor(20, 24, 28, pointed ? 255 : 190), pointed ? 1.8 : 1.0));
    painter.drawPolygon(outline);
}

void OutlineLayer::paint(QPainter& painter, const SliderPlan& plan, const std::vector<Rail>& rails)
{
    if (painter.device() != &plan) {
        for (const Rail& rail : rails) paintRailOutline(painter, plan, rail, false);
        return;
    }
    const double ratio = plan.devicePixelRatioF();
    const bool fits = view_ == plan.view() && size_ == plan.size() && picture_.devicePixelRatio() == ratio;
    const std::set<std::size_t> moved = movedRails(rails);
    if (!fits || rails.size() != rails_.size() || moved.size() > mostAlone)
        keep(plan, rails, {});
    else if (!std::ranges::includes(alone_, moved))
        keep(plan, rails, moved);
    painter.drawPixmap(QPointF(), picture_);
    for (const std::size_t rail : alone_) paintRailOutline(painter, plan, rails[rail], false);
}

std::set<std::size_t> OutlineLayer::movedRails(const std::vector<Rail>& rails) const
{
    std::set<std::size_t> moved;
    for (std::size_t i = 0; i < std::min(rails.size(), rails_.size()); ++i)
        if (rails[i].points != rails_[i].points) moved.insert(i);
    return moved;
}

void OutlineLayer::keep(const SliderPlan& plan, const std::vector<Rail>& rails, std::set<std::size_t> alone)
{
    view_ = plan.view();
    size_ = plan.size();
    rails_ = rails;
    alone_ = std::move(alone);
    picture_ = QPixmap(size_ * plan.devicePixelRatioF());
    picture_.setDevicePixelRatio(plan.devicePixelRatioF());
    picture_.fill(Qt::transparent);
    QPainter painter(&picture_);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < rails.size(); ++i)
        if (!alone_.contains(i)) paintRailOutline(painter, plan, rails[i], false);
}

} // namespace touchdown
