// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/wall_menu.h"

#include <algorithm>

#include <QActionGroup>
#include <QCoreApplication>
#include <QIcon>
#include <QProxyStyle>

#include "core/physics/slider/wall_edit.h"
#include "ui/slider/wall_picture.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

QString menuText(const char* text) { return QCoreApplication::translate("WallMenu", text); }

/// Pictures in a menu are as large as small icons of the style.
class LargePictures : public QProxyStyle {
public:
    explicit LargePictures(int size) : size_(size) {}
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override
    {
        return metric == PM_SmallIconSize ? size_ : QProxyStyle::pixelMetric(metric, option, widget);
    }

private:
    int size_;
};

double widest(const std::vector<WallProfile>& walls)
{
    double width = 0.0;
    for (const WallProfile& wall : walls)
        if (!wall.distance.empty()) width = std::max(width, wall.distance.back() - wall.distance.front());
    return width;
}

/// "Wall 3:  10 µm wide, recess 0 nm to 1.5 µm"
QString wallText(std::size_t index, const WallProfile& wall)
{
    const QString name = menuText("Wall %1").arg(index + 1);
    if (wall.distance.empty() || wall.recess.empty()) return name;
    return menuText("%1:  %2 wide, recess %3 to %4")
        .arg(name, lengthText(wall.distance.back() - wall.distance.front(), 4), lengthText(wall.recess.front(), 4),
             lengthText(wall.recess.back(), 4));
}

} // namespace

void fillWallMenu(QMenu& menu, const AirBearingSurface& surface, std::optional<int> current,
                  const std::function<void(int)>& choose)
{
    auto* group = new QActionGroup(&menu);
    const int side = 3 * menu.fontMetrics().height() / 2;
    auto* style = new LargePictures(side);
    style->setParent(&menu);
    menu.setStyle(style);
    const double width = widest(surface.walls);
    const auto add = [&](int wall, const QString& text, const WallProfile& profile) {
        QAction* action = menu.addAction(text, &menu, [choose, wall] { choose(wall); });
        action->setIcon(QIcon(wallPixmap(profile, {side, side}, menu.palette(), menu.devicePixelRatioF(), width)));
        action->setIconVisibleInMenu(true);
        action->setCheckable(true);
        action->setChecked(current == wall);
        group->addAction(action);
    };
    add(0, menuText("None, a vertical edge"), {});
    for (std::size_t i = 0; i < surface.walls.size(); ++i)
        add(static_cast<int>(i) + 1, wallText(i, surface.walls[i]), surface.walls[i]);
    menu.addSeparator();
    const int next = static_cast<int>(surface.walls.size()) + 1;
    menu.addAction(menuText("New wall…"), &menu, [choose, next] { choose(next); });
}

std::optional<int> commonWall(const AirBearingSurface& surface, const PartSelection& parts)
{
    std::set<int> walls;
    for (const SurfacePart& part : parts) {
        if (!has(surface, part)) continue;
        const std::vector<RailPoint>* points = isOfRail(part) ? &surface.rails[part.item].points : nullptr;
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
