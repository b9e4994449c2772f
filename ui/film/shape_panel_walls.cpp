// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls of edges and points of walls, from the table and the picture; keys and menu of the table.
#include <algorithm>

#include <QKeyEvent>
#include <QMenu>

#include "core/physics/slider/wall_edit.h"
#include "ui/film/part_tree.h"
#include "ui/film/shape_panel.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/wall_menu.h"
#include "ui/slider/wall_picture.h"

namespace touchdown {

void ShapePanel::buildWallMenu()
{
    wall_ = new QToolButton(this);
    wall_->setText(tr("Wall…"));
    wall_->setToolTip(tr("Wall of the edges that begin at the chosen corners, or of all edges of the selected rails"));
    wall_->setAccessibleName(wall_->toolTip());
    wall_->setFocusPolicy(Qt::StrongFocus);
    connect(wall_, &QToolButton::clicked, this, [this] {
        auto* menu = new QMenu(wall_);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fillWallMenu(*menu, case_.surface, commonWall(case_.surface, chosenEdges()),
                     [this](int wall) { chooseWall(wall); });
        menu->popup(wall_->mapToGlobal(QPoint(0, wall_->height())));
    });
}

bool ShapePanel::eventFilter(QObject* watched, QEvent* event)
{
    // Before actions of the window with the same keys.
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool taken = key == Qt::Key_Delete || (key == Qt::Key_Insert && watched == table_);
    if (!taken) return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::ShortcutOverride)
        event->accept();
    else if (key == Qt::Key_Insert)
        corner_->click();
    else
        watched == table_ ? removeTableRows() : removeChosen();
    return true;
}

/// Those that begin at the selected rows; without any, all of the selected rails.
PartSelection ShapePanel::chosenEdges() const
{
    PartSelection edges;
    if (chosen_.kind != Kind::Rail) return edges;
    for (const SurfacePart& part : selection_)
        if (part.kind == PartKind::Edge || part.kind == PartKind::Corner)
            edges.insert({PartKind::Edge, part.item, part.index});
    if (edges.empty()) edges = railsOf(selection_);
    if (edges.empty()) edges.insert({PartKind::Rail, chosen_.item});
    return edges;
}

void ShapePanel::chooseWall(int wall)
{
    const PartSelection edges = chosenEdges();
    if (edges.empty()) return;
    const AirBearingSurface surface = withChosenWall(case_.surface, edges, wall);
    const bool added = surface.walls.size() > case_.surface.walls.size();
    if (surface == case_.surface) return;
    emit edited(surface, tr("wall of %1").arg(selectionText(edges)), 0);
    if (added) showWall(surface.walls.size() - 1);
}

void ShapePanel::onTableMenu(const QPoint& at)
{
    if (chosen_.kind != Kind::Rail && chosen_.kind != Kind::Wall) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (chosen_.kind == Kind::Rail) {
        QMenu* walls = menu->addMenu(tr("Wall of the edges that begin here"));
        fillWallMenu(*walls, case_.surface, commonWall(case_.surface, chosenEdges()),
                     [this](int wall) { chooseWall(wall); });
        menu->addAction(tr("Insert a corner after this one") + QStringLiteral("\tIns"), this, [this] { addCorner(); });
    } else {
        menu->addAction(tr("Add a point after this one") + QStringLiteral("\tIns"), this, [this] { addWallPoint(); });
    }
    menu->addAction(tr("Delete") + QStringLiteral("\tDel"), this, [this] { removeTableRows(); });
    menu->popup(table_->viewport()->mapToGlobal(at));
}

void ShapePanel::removeTableRows()
{
    const int row = table_->currentRow();
    if (row < 0) return;
    if (chosen_.kind == Kind::Wall) {
        const auto point = static_cast<std::size_t>(row);
        const WallProfile wall = withoutWallPoint(case_.surface.walls[chosen_.item], point);
        if (wall == case_.surface.walls[chosen_.item])
            say(tr("A wall has two points or more."));
        else
            onWallEdited(wall, false);
    } else if (chosen_.kind == Kind::Rail && !selection_.empty()) {
        removeChosen();
    }
}

void ShapePanel::addWallPoint()
{
    if (chosen_.kind != Kind::Wall) return;
    const WallProfile& wall = case_.surface.walls[chosen_.item];
    const int row = table_->currentRow() < 0 ? static_cast<int>(wall.distance.size()) - 1 : table_->currentRow();
    const double distance = distanceAfter(wall, static_cast<std::size_t>(row));
    const int added = static_cast<int>(placeOfPoint(wall, distance));
    onWallEdited(withWallPoint(wall, distance), false);
    table_->setCurrentCell(added, 0);
}

void ShapePanel::onWallEdited(const WallProfile& wall, bool row)
{
    if (chosen_.kind != Kind::Wall) return;
    AirBearingSurface surface = case_.surface;
    surface.walls[chosen_.item] = wall;
    if (!row) ++rowOfMoves_;
    // Below the numbers of the editor's rows of moves, and of -1, which is none.
    const int merge = row ? -2 - rowOfMoves_ : 0;
    const auto point = profile_->point();
    emit edited(surface, tr("change wall %1").arg(chosen_.item + 1), merge);
    if (point && *point < wall.distance.size()) table_->setCurrentCell(static_cast<int>(*point), 0);
}

void ShapePanel::typeCoordinates()
{
    if (table_->rowCount() == 0) return;
    int row = 0;
    for (const SurfacePart& part : selection_)
        if (part.kind == PartKind::Edge || part.kind == PartKind::Corner) {
            row = static_cast<int>(part.index);
            break;
        }
    table_->setFocus();
    table_->setCurrentCell(row, 0);
}

} // namespace touchdown
