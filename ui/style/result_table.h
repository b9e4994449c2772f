// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of results to look at, select, copy and, where wanted, sort. Heads stand as the cells below them.
#pragma once

#include <vector>

#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTableView>
#include <QToolButton>
#include <QVariant>

namespace touchdown {

struct TableCell {
    QString text;
    Qt::Alignment alignment = Qt::AlignLeft;
    QString tip = {};
    QVariant key = {};   // by which rows are sorted; none: not known
    bool failed = false; // in the colour of a failure
};
using TableRow = std::vector<TableCell>;

/// At the right.
TableCell numberCell(const QString& text);

/// By number if both are numbers, else by text; unknown values come last in both directions.
class TableOrder : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

class ResultTable : public QTableView {
    Q_OBJECT

public:
    /// A row is chosen at a time, and all rows are copied.
    explicit ResultTable(const QString& name, QWidget* parent = nullptr);

    /// The heads sort, several rows can be selected, and those are copied.
    void setSortable();
    /// Of a head: its text and its tip. The same heads as before keep the order that was chosen.
    void setRows(const TableRow& heads, const std::vector<TableRow>& rows);
    void append(const TableRow& row);
    /// Each column as wide as its text, with a margin; the rest of a sentence is cut off.
    void fitColumns();

    /// As shown.
    int rowCount() const { return order_.rowCount(); }
    int columnCount() const { return order_.columnCount(); }
    QString text(int row, int column) const { return order_.index(row, column).data().toString(); }
    QString head(int column) const { return order_.headerData(column, Qt::Horizontal).toString(); }
    /// With the heads; cells separated by tabs, and numbers with the sign that spreadsheets read.
    QString toText() const;

public slots:
    void copy() const;

signals:
    /// -1: none.
    void chosen(int row);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fitRows();
    void colour(QStandardItem& item) const;

    QStandardItemModel content_;
    TableOrder order_;
};

/// A button without a frame, beside a result.
QToolButton* quietButton(const QString& text, const QString& tip, const QString& name, QWidget* parent);

} // namespace touchdown
