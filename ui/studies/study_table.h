// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of a study's report to look at, sort, select and copy.
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QTableView>

#include "core/studies/study/study.h"

namespace touchdown {

/// Numbers in display units, with as many digits as can be read.
class StudyTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// Key for sorting: the number in SI or the text; none if it is not known.
    static constexpr int SortRole = Qt::UserRole;

    explicit StudyTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void setTable(StudyTable table);
    const StudyTable& table() const { return table_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const StudyColumn& column, const StudyValue& value) const;

    StudyTable table_;
};

/// By number if both are numbers, else by text; unknown values come last.
class StudyTableOrder : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

class StudyTableView : public QTableView {
    Q_OBJECT

public:
    explicit StudyTableView(QWidget* parent = nullptr);

    /// Keeps the order that was chosen, if the table has the same columns.
    void setTable(StudyTable table);
    const StudyTableModel& content() const { return model_; }
    /// The selected rows, or all, in the order shown: tab-separated, with a header.
    QString toText() const;

public slots:
    void copy() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    StudyTableModel model_;
    StudyTableOrder order_;
};

} // namespace touchdown
