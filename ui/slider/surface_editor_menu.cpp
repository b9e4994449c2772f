// SPDX-License-Identifier: GPL-3.0-or-later
//
// The menu of the right button and of the menu key.
#include <QContextMenuEvent>
#include <QMenu>

#include "ui/slider/part_picking.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

void SurfaceEditor::contextMenuEvent(QContextMenuEvent* event)
{
    if (dragging() || tool_ != Tool::Select) return;
    const QPointF pixel = event->reason() == QContextMenuEvent::Mouse ? QPointF(event->pos()) : QPointF(-1.0, -1.0);
    const auto part = partAt(*this, committed_, pixel, selection_);
    if (part && !selection_.contains(*part) && !selection_.contains({PartKind::Rail, part->item})) select({*part});
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (part && part->kind == PartKind::Edge)
        menu->addAction(tr("Insert a corner here"), this,
                        [this, edge = *part, at = toSlider(pixel)] { insertCorner(edge.item, edge.index, at); });
    const auto add = [&](const QString& text, auto perform) {
        menu->addAction(text, this, perform)->setEnabled(!selection_.empty());
    };
    add(tr("Copy") + QStringLiteral("\tCtrl+D"), [this] { copySelected(); });
    add(tr("Mirror about the centre line") + QStringLiteral("\tShift+M"), [this] { mirrorSelected(); });
    add(tr("Forward") + QStringLiteral("\tPgUp"), [this] { moveInOrder(1); });
    add(tr("Backward") + QStringLiteral("\tPgDown"), [this] { moveInOrder(-1); });
    menu->addSeparator();
    add(tr("Delete") + QStringLiteral("\tDel"), [this] { removeSelected(); });
    menu->popup(event->globalPos());
}

} // namespace touchdown
