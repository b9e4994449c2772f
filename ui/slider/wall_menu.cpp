// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/wall_menu.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QIcon>

#include "core/physics/slider/wall_edit.h"
#include "ui/slider/wall_picture.h"

namespace touchdown {

namespace {

QString menuText(const char* text) { return QCoreApplication::translate("WallMenu", text); }

} // namespace

void fillWallMenu(QMenu& menu, const AirBearingSurface& surface, std::optional<int> current,
                  const std::function<void(int)>& choose)
{
    auto* group = new QActionGroup(&menu);
    const int side = 2 * menu.fontMetrics().height();
    const auto add = [&](int wall, const QString& text, const WallProfile& profile) {
        QAction* action = menu.addAction(text, &menu, [choose, wall] { choose(wall); });
        action->setIcon(QIcon(wallPixmap(profile, {side, side / 2}, menu.palette(), menu.devicePixelRatioF())));
        action->setIconVisibleInMenu(true);
        action->setCheckable(true);
        action->setChecked(current == wall);
        group->addAction(action);
    };
    add(0, menuText("None, a vertical edge"), {});
    for (std::size_t i = 0; i < surface.walls.size(); ++i)
        add(static_cast<int>(i) + 1, menuText("Wall %1").arg(i + 1), surface.walls[i]);
    menu.addSeparator();
    const int next = static_cast<int>(surface.walls.size()) + 1;
    menu.addAction(menuText("New wall…"), &menu, [choose, next] { choose(next); });
}

std::optional<int> commonWall(const AirBearingSurface& surface, const PartSelection& parts)
{
    std::set<int> walls;
    for (const SurfacePart& part : parts) {
        if (!has(surface, part)) continue;
        const std::vector<RailPoint>* points =
            part.kind == PartKind::Interest ? nullptr : &surface.rails[part.item].points;
        if (part.kind == PartKind::Edge) walls.insert(points->at(part.index).wall);
        if (part.kind == PartKind::Rail)
            for (const RailPoint& point : *points) walls.insert(point.wall);
    }
    return walls.size() == 1 ? std::optional(*walls.begin()) : std::nullopt;
}

AirBearingSurface withChosenWall(AirBearingSurface surface, const PartSelection& parts, int wall)
{
    if (wall > static_cast<int>(surface.walls.size()) && !parts.empty()) {
        const std::size_t rail = parts.begin()->item;
        surface.walls.push_back(slopedWall(surface.rails.at(rail).recess[0], surface.baseRecess));
        wall = static_cast<int>(surface.walls.size());
    }
    return withEdgeWall(std::move(surface), parts, wall);
}

} // namespace touchdown
