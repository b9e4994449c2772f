// SPDX-License-Identifier: GPL-3.0-or-later
//
// A list of parts in groups. The items of the first group can be dragged to another place in it. Of a part the number
// in column 1 is edited, also where its name has the focus.
#pragma once

#include <QTreeWidget>

namespace touchdown {

class PartTree : public QTreeWidget {
    Q_OBJECT

public:
    explicit PartTree(QWidget* parent = nullptr);

    /// The place that the current item of the first group would have if it were dropped here; -1: it cannot be.
    int placeAt(const QPoint& at) const;

signals:
    /// An item of the first group was dropped: its place before, and the one that it is to have.
    void reordered(int from, int to);

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
};

} // namespace touchdown
