// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the buttons of the panel do.
#include <algorithm>

#include "core/physics/slider/wall_edit.h"
#include "ui/film/shape_panel.h"
#include "ui/slider/part_picking.h"

namespace touchdown {

void ShapePanel::addRail()
{
    const double x = 0.5 * case_.slider.length, y = 0.5 * case_.slider.width;
    const double length = 0.1 * case_.slider.length, width = 0.1 * case_.slider.width;
    AirBearingSurface surface = case_.surface;
    surface.rails.push_back({RailKind::Step,
                             {{x - length, y - width, 0},
                              {x + length, y - width, 0},
                              {x + length, y + width, 0},
                              {x - length, y + width, 0}},
                             {}});
    const SurfacePart added{PartKind::Rail, surface.rails.size() - 1};
    emit edited(surface, tr("add %1").arg(partText(added)), 0);
    setSelection({added});
    emit selected({added});
}

void ShapePanel::addCorner()
{
    if (chosen_.kind != Kind::Rail) return;
    const std::vector<RailPoint>& points = case_.surface.rails[chosen_.item].points;
    const std::size_t corner = static_cast<std::size_t>(std::max(0, table_->currentRow())) % points.size();
    const RailPoint &a = points[corner], &b = points[(corner + 1) % points.size()];
    const SurfacePoint middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
    emit edited(withCorner(case_.surface, chosen_.item, corner, middle),
                tr("insert a corner into %1").arg(partText({PartKind::Rail, chosen_.item})), 0);
    setSelection({{PartKind::Corner, chosen_.item, corner + 1}});
    emit selected(selection_);
}

void ShapePanel::addWall()
{
    AirBearingSurface surface = case_.surface;
    surface.walls.push_back(slopedWall(0.0, surface.baseRecess));
    chosen_ = {Kind::Wall, surface.walls.size() - 1};
    emit edited(surface, tr("add a wall"), 0);
}

void ShapePanel::addInterest()
{
    AirBearingSurface surface = case_.surface;
    surface.pointsOfInterest.push_back({0.5 * case_.slider.length, 0.5 * case_.slider.width});
    const SurfacePart added{PartKind::Interest, surface.pointsOfInterest.size() - 1};
    emit edited(surface, tr("add a point of interest"), 0);
    setSelection({added});
    emit selected({added});
}

void ShapePanel::removeChosen()
{
    if (chosen_.kind == Kind::Wall)
        emit edited(withoutWall(case_.surface, chosen_.item), tr("delete wall %1").arg(chosen_.item + 1), 0);
    else if (!selection_.empty())
        emit edited(without(case_.surface, selection_), tr("delete %1").arg(selectionText(selection_)), 0);
}

void ShapePanel::moveChosen(int places)
{
    const auto count = static_cast<std::ptrdiff_t>(case_.surface.rails.size());
    const auto place = static_cast<std::ptrdiff_t>(chosen_.item) + places;
    if (chosen_.kind != Kind::Rail || place < 0 || place >= count) return;
    const SurfacePart rail{PartKind::Rail, static_cast<std::size_t>(place)};
    emit edited(reordered(case_.surface, chosen_.item, rail.item), tr("change the order of rails"), 0);
    setSelection({rail});
    emit selected({rail});
}

} // namespace touchdown
