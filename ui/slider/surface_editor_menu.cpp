// SPDX-License-Identifier: GPL-3.0-or-later
//
// The menu of the right button and of the menu key.
#include <algorithm>

#include <QContextMenuEvent>
#include <QMenu>

#include "core/physics/slider/surface_symmetry.h"
#include "ui/plot/picture_widget.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/surface_editor.h"
#include "ui/slider/wall_menu.h"

namespace touchdown {

void SurfaceEditor::contextMenuEvent(QContextMenuEvent* event)
{
    if (dragging() || tool_ != Tool::Select) return;
    if (event->reason() != QContextMenuEvent::Mouse) {
        const bool some = !selection_.empty() && has(committed_, *selection_.begin());
        const QPointF at = some ? toPixel(placeOf(committed_, *selection_.begin(), {})) : planArea().center();
        popUpMenu(mapToGlobal(at.toPoint()), std::nullopt);
        return;
    }
    const QPointF pixel = event->pos();
    const auto part = partAt(*this, committed_, pixel, selection_);
    if (part && !selection_.contains(*part) && !selection_.contains({PartKind::Rail, part->item})) select({*part});
    popUpMenu(event->globalPos(), part && part->kind == PartKind::Edge ? std::optional(toSlider(pixel)) : std::nullopt);
}

void SurfaceEditor::popUpMenu(const QPoint& globalPos, const std::optional<SurfacePoint>& insertAt)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const PartSelection rails = railsOf(selection_);
    const auto count = [&](PartKind kind) {
        return std::ranges::count_if(selection_, [kind](const SurfacePart& part) { return part.kind == kind; });
    };
    const auto add = [&](const QString& text, const QString& keys, bool enabled, auto perform) {
        menu->addAction(keys.isEmpty() ? text : text + QLatin1Char('\t') + keys, this, perform)->setEnabled(enabled);
    };
    if (selection_.size() == 1 && selection_.begin()->kind == PartKind::Edge) {
        const SurfacePart edge = *selection_.begin();
        const std::vector<RailPoint>& points = committed_.rails[edge.item].points;
        const RailPoint &a = points[edge.index], &b = points[(edge.index + 1) % points.size()];
        const SurfacePoint at = insertAt.value_or(SurfacePoint{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
        add(insertAt ? tr("Insert a corner here") : tr("Insert a corner in the middle"), {}, true,
            [this, edge, at] { insertCorner(edge.item, edge.index, at); });
    }
    if (count(PartKind::Edge) + count(PartKind::Rail) > 0) {
        const bool one = selection_.size() == 1 && count(PartKind::Edge) == 1;
        QMenu* walls = menu->addMenu(one ? tr("Wall of this edge") : tr("Wall of all these edges"));
        fillWallMenu(*walls, committed_, commonWall(committed_, selection_), [this](int wall) { chooseWall(wall); });
    }
    add(tr("Coordinates…"), {}, !selection_.empty(), [this] { emit coordinatesWanted(); });
    add(tr("Recess…"), {}, rails.size() == 1, [this] { emit recessWanted(); });
    menu->addSeparator();
    add(tr("Duplicate"), QStringLiteral("Ctrl+D"), !rails.empty(), [this] { copySelected(); });
    add(tr("Mirror about the centre line"), QStringLiteral("Shift+M"), !selection_.empty(),
        [this] { mirrorSelected(); });
    const bool lopsided = madeSymmetric(committed_, rails, area().height(), pairReach) != committed_;
    add(tr("Make symmetric"), {}, lopsided, [this] { makeSymmetric(); });
    for (const PairLink& link : links_)
        if (rails.size() == 1 && (link.rail == rails.begin()->item || link.image == rails.begin()->item))
            add(link.broken ? tr("Join the pair") : tr("Break the pair"), QStringLiteral("L"), true,
                [this, rail = link.rail] { togglePair(rail); });
    add(tr("Forward"), QStringLiteral("PgUp"), rails.size() == 1, [this] { moveInOrder(1); });
    add(tr("Backward"), QStringLiteral("PgDown"), rails.size() == 1, [this] { moveInOrder(-1); });
    menu->addSeparator();
    add(tr("Delete"), QStringLiteral("Del"), !selection_.empty(), [this] { removeSelected(); });
    menu->addSeparator();
    addPictureActions(*menu, *this);
    menu->popup(globalPos);
}

} // namespace touchdown
