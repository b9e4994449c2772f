// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of rails, walls, points of interest and relations.
#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QSignalBlocker>

#include "core/case/case_key.h"
#include "ui/case/parameter_text.h"
#include "ui/film/part_tree.h"
#include "ui/film/relation_rows.h"
#include "ui/film/shape_panel.h"
#include "ui/slider/wall_picture.h"

namespace touchdown {

void ShapePanel::buildList()
{
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QWidget::customContextMenuRequested, this, &ShapePanel::onListMenu);
    connect(list_, &PartTree::reordered, this, &ShapePanel::onReordered);
    list_->setColumnCount(3);
    list_->setHeaderLabels({tr("Part"), tr("Recess [µm]"), tr("Corners")});
    list_->setAccessibleName(tr("Rails, walls and points of interest"));
    list_->setUniformRowHeights(true);
    list_->setIndentation(12);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (const int column : {1, 2}) list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(false);
    for (QTreeWidgetItem** group : {&rails_, &walls_, &interests_, &relations_}) {
        *group = new QTreeWidgetItem(list_);
        (*group)->setFlags(Qt::ItemIsEnabled);
        (*group)->setExpanded(true);
        (*group)->setFirstColumnSpanned(true);
    }
}

void ShapePanel::fillList()
{
    filling_ = true;
    const QSignalBlocker silent(list_);
    const AirBearingSurface& surface = case_.surface;
    const auto resize = [](QTreeWidgetItem* group, std::size_t count, const QString& name) {
        group->setText(0, QStringLiteral("%1 (%2)").arg(name).arg(count));
        while (group->childCount() > static_cast<int>(count)) delete group->takeChild(group->childCount() - 1);
        while (group->childCount() < static_cast<int>(count)) new QTreeWidgetItem(group);
    };
    resize(rails_, surface.rails.size(), tr("Rails"));
    resize(walls_, surface.walls.size(), tr("Walls"));
    resize(interests_, surface.pointsOfInterest.size(), tr("Points of interest"));
    resize(relations_, relationCount(surface), tr("Kept distances and symmetries"));
    relations_->setHidden(relationCount(surface) == 0);
    const auto fill = [&](QTreeWidgetItem* group, std::size_t i, Kind kind, const QString& name, std::size_t points) {
        QTreeWidgetItem* item = group->child(static_cast<int>(i));
        item->setText(0, name);
        item->setData(0, kindRole, static_cast<int>(kind));
        item->setText(2, points > 0 ? QString::number(points) : QString());
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        item->setFlags(item->flags().setFlag(Qt::ItemIsDragEnabled, kind == Kind::Rail) & ~Qt::ItemIsDropEnabled);
        return item;
    };
    for (std::size_t i = 0; i < surface.rails.size(); ++i) {
        const Rail& rail = surface.rails[i];
        const QString name = rail.kind == RailKind::Ramp ? tr("Rail %1, ramp").arg(i + 1) : tr("Rail %1").arg(i + 1);
        QTreeWidgetItem* item = fill(rails_, i, Kind::Rail, name, rail.points.size());
        const std::string key = "abs.rail[" + std::to_string(i + 1) + "].recess";
        item->setText(1, editorText(case_, std::get<Parameter>(caseKey(case_, key))));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setData(1, keyRole, QString::fromStdString(key));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    const int height = list_->fontMetrics().height();
    for (std::size_t i = 0; i < surface.walls.size(); ++i) {
        QTreeWidgetItem* item = fill(walls_, i, Kind::Wall, tr("Wall %1").arg(i + 1), 0);
        item->setIcon(0, QIcon(wallPixmap(surface.walls[i], {2 * height, height}, palette(), devicePixelRatioF())));
    }
    for (std::size_t i = 0; i < surface.pointsOfInterest.size(); ++i)
        fill(interests_, i, Kind::Interest, tr("P%1").arg(i + 1), 0);
    const auto wrong = relationProblems(surface, case_.slider.width);
    for (std::size_t i = 0; i < relationCount(surface); ++i)
        fillRelation(*fill(relations_, i, Kind::Relation, {}, 0), surface, i, wrong);
    filling_ = false;
    const std::size_t counts[] = {0, surface.rails.size(), surface.walls.size(), surface.pointsOfInterest.size(),
                                  relationCount(surface)};
    if (chosen_.item >= counts[static_cast<int>(chosen_.kind)]) chosen_ = {};
    updateButtons();
}

ShapePanel::Chosen ShapePanel::chosenOf(const QTreeWidgetItem* item) const
{
    if (item == nullptr || item->parent() == nullptr) return {};
    return {static_cast<Kind>(item->data(0, kindRole).toInt()),
            static_cast<std::size_t>(item->parent()->indexOfChild(const_cast<QTreeWidgetItem*>(item)))};
}

void ShapePanel::setSelection(const PartSelection& parts)
{
    selection_ = parts;
    const bool wallStays = parts.empty() && chosen_.kind == Kind::Wall;
    if (!wallStays) {
        const QSignalBlocker silent(list_);
        list_->clearSelection();
        for (const SurfacePart& part : parts) {
            auto* group = isOfRail(part) ? rails_ : part.kind == PartKind::Interest ? interests_ : relations_;
            QTreeWidgetItem* item = group->child(static_cast<int>(rowOf(case_.surface, part)));
            if (item == nullptr) continue;
            item->setSelected(true);
            if (part == *parts.begin()) {
                list_->setCurrentItem(item, 0, QItemSelectionModel::NoUpdate);
                list_->scrollToItem(item);
                chosen_ = chosenOf(item);
            }
        }
    }
    if (parts.empty() && !wallStays) chosen_ = {};
    fillTable();
    updateButtons();
}

void ShapePanel::onListSelected()
{
    PartSelection parts;
    for (const QTreeWidgetItem* item : list_->selectedItems()) {
        const Chosen one = chosenOf(item);
        if (one.kind == Kind::Rail) parts.insert({PartKind::Rail, one.item});
        if (one.kind == Kind::Interest) parts.insert({PartKind::Interest, one.item});
        if (one.kind == Kind::Relation) parts.insert(relationAt(case_.surface, one.item));
    }
    const Chosen current = chosenOf(list_->currentItem());
    if (current.kind != Kind::None) chosen_ = current;
    selection_ = parts;
    ++rowOfMoves_;
    fillTable();
    updateButtons();
    emit selected(parts);
}

void ShapePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) fillList(); // the pictures of walls have the colour of the text
}

void ShapePanel::onReordered(int from, int to)
{
    emit edited(reordered(case_.surface, static_cast<std::size_t>(from), static_cast<std::size_t>(to)),
                tr("change the order of rails"), 0);
    const PartSelection rail{{PartKind::Rail, static_cast<std::size_t>(to)}};
    setSelection(rail);
    emit selected(rail);
}

void ShapePanel::onListMenu(const QPoint& at)
{
    const QTreeWidgetItem* item = list_->itemAt(at);
    const Chosen one = chosenOf(item ? item : list_->currentItem());
    const QPoint place = list_->viewport()->mapToGlobal(at);
    if (one.kind != Kind::None && one.kind != Kind::Wall) emit menuWanted(place);
    if (one.kind != Kind::Wall) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Add a point"), this, [this] { addWallPoint(); });
    menu->addAction(tr("Delete the wall"), this, [this] { removeChosen(); });
    menu->popup(place);
}

void ShapePanel::typeRecess()
{
    QTreeWidgetItem* item = rails_->child(static_cast<int>(chosen_.item));
    if (chosen_.kind != Kind::Rail || item == nullptr) return;
    list_->setFocus();
    list_->editItem(item, 1);
}

void ShapePanel::showWall(std::size_t wall)
{
    QTreeWidgetItem* item = walls_->child(static_cast<int>(wall));
    if (item != nullptr) list_->setCurrentItem(item);
}

} // namespace touchdown
