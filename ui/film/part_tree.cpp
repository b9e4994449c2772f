// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/part_tree.h"

#include <QDropEvent>

namespace touchdown {

PartTree::PartTree(QWidget* parent) : QTreeWidget(parent)
{
    setDragDropMode(QAbstractItemView::InternalMove);
    setDropIndicatorShown(true);
}

int PartTree::placeAt(const QPoint& at) const
{
    QTreeWidgetItem* group = topLevelItem(0);
    QTreeWidgetItem* dragged = currentItem();
    QTreeWidgetItem* over = itemAt(at);
    if (group == nullptr || dragged == nullptr || dragged->parent() != group || over == nullptr) return -1;
    if (over == group) return 0;
    if (over->parent() != group) return -1;
    const QRect row = visualItemRect(over);
    const int from = group->indexOfChild(dragged);
    int to = group->indexOfChild(over) + (at.y() > row.center().y() ? 1 : 0); // before this one
    if (to > from) --to;                                                      // when the dragged one is taken out
    return to;
}

bool PartTree::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event)
{
    return QTreeWidget::edit(index.siblingAtColumn(1), trigger, event);
}

void PartTree::dragMoveEvent(QDragMoveEvent* event)
{
    QTreeWidget::dragMoveEvent(event); // scrolls, and draws where the item would go
    if (event->source() == this && placeAt(event->position().toPoint()) >= 0)
        event->acceptProposedAction();
    else
        event->ignore();
}

void PartTree::dropEvent(QDropEvent* event)
{
    const int to = event->source() == this ? placeAt(event->position().toPoint()) : -1;
    const int from = to < 0 ? -1 : topLevelItem(0)->indexOfChild(currentItem());
    setState(QAbstractItemView::NoState);
    // The owner changes the surface and fills the list again: the view itself is to move nothing.
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    viewport()->update();
    if (to >= 0 && to != from) emit reordered(from, to);
}

} // namespace touchdown
