// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of all rails on a plan. Stroking them takes half of the time of a picture, so a picture is kept of those
// that stay as they are while another one is dragged.
#pragma once

#include <set>
#include <vector>

#include <QPainter>
#include <QPixmap>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

class SliderPlan;

/// `pointed`: the one under the pointer stands out.
void paintRailOutline(QPainter& painter, const SliderPlan& plan, const Rail& rail, bool pointed);

class OutlineLayer {
public:
    /// On the widget itself; on other devices, as files, each outline is drawn.
    void paint(QPainter& painter, const SliderPlan& plan, const std::vector<Rail>& rails);
    /// Rails that the last call did not find in the kept picture.
    std::size_t drawnAlone() const { return alone_.size(); }

private:
    std::set<std::size_t> movedRails(const std::vector<Rail>& rails) const;
    void keep(const SliderPlan& plan, const std::vector<Rail>& rails, std::set<std::size_t> alone);

    QPixmap picture_; // of all rails but those that are drawn alone
    QRectF view_;     // that it shows [m]
    QSize size_;      // of the widget [px]
    std::vector<Rail> rails_;
    std::set<std::size_t> alone_;
};

} // namespace touchdown
