// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/result_table.h"

#include <algorithm>

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

#include "ui/style/foreign_text.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int columnMargin = 14;  // [px]
constexpr int widestColumn = 420; // [px]: a sentence in a cell must not push the rest out of sight
constexpr int keyRole = Qt::UserRole, failedRole = Qt::UserRole + 1;

QStandardItem* itemOf(const TableCell& cell)
{
    auto* item = new QStandardItem(cell.text);
    item->setTextAlignment(cell.alignment | Qt::AlignVCenter);
    if (!cell.tip.isEmpty()) item->setToolTip(plainTip(cell.tip));
    item->setData(cell.key, keyRole);
    item->setData(cell.failed, failedRole);
    return item;
}

} // namespace

TableCell numberCell(const QString& text) { return {text, Qt::AlignRight}; }

bool TableOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const QVariant a = left.data(keyRole), b = right.data(keyRole);
    if (!a.isValid() || !b.isValid())
        return a.isValid() == b.isValid() ? false : a.isValid() == (sortOrder() == Qt::AscendingOrder);
    if (a.typeId() == QMetaType::Double && b.typeId() == QMetaType::Double) return a.toDouble() < b.toDouble();
    return a.toString().localeAwareCompare(b.toString()) < 0;
}

ResultTable::ResultTable(const QString& name, QWidget* parent) : QTableView(parent)
{
    order_.setSourceModel(&content_);
    setModel(&order_);
    makePlain(*this);
    setAccessibleName(name);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    horizontalHeader()->setHighlightSections(false); // bold heads would need wider columns
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { emit chosen(order_.mapToSource(now).row()); });
    fitRows();
}

void ResultTable::setSortable()
{
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setSortingEnabled(true);
    order_.sort(-1); // in the given order until the user sorts
    horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    horizontalHeader()->setSortIndicatorClearable(true);
}

void ResultTable::setRows(const TableRow& heads, const std::vector<TableRow>& rows)
{
    bool same = static_cast<int>(heads.size()) == content_.columnCount();
    for (int i = 0; same && i < content_.columnCount(); ++i)
        same = content_.horizontalHeaderItem(i)->text() == heads[static_cast<std::size_t>(i)].text;
    content_.setRowCount(0);
    if (!same) {
        content_.clear();
        for (int i = 0; i < static_cast<int>(heads.size()); ++i)
            content_.setHorizontalHeaderItem(i, itemOf(heads[static_cast<std::size_t>(i)]));
        if (isSortingEnabled()) horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    }
    for (const TableRow& row : rows) append(row);
}

void ResultTable::append(const TableRow& row)
{
    QList<QStandardItem*> items;
    for (const TableCell& cell : row) {
        items << itemOf(cell);
        colour(*items.back());
        if (content_.rowCount() == 0)
            content_.horizontalHeaderItem(static_cast<int>(items.size()) - 1)
                ->setTextAlignment(items.back()->textAlignment());
    }
    content_.appendRow(items);
}

void ResultTable::fitColumns()
{
    resizeColumnsToContents();
    for (int i = 0; i < columnCount(); ++i) setColumnWidth(i, std::min(columnWidth(i) + columnMargin, widestColumn));
}

QString ResultTable::toText() const
{
    const bool all = selectionMode() == QAbstractItemView::SingleSelection || !selectionModel()->hasSelection();
    QStringList lines;
    for (int row = -1; row < rowCount(); ++row) {
        if (row >= 0 && !all && !selectionModel()->isRowSelected(row)) continue;
        QStringList cells;
        for (int column = 0; column < columnCount(); ++column) cells << (row < 0 ? head(column) : text(row, column));
        lines << cells.join(QLatin1Char('\t'));
    }
    QString text = lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
    return text.replace(QChar(0x2212), QLatin1Char('-'));
}

void ResultTable::copy() const { QGuiApplication::clipboard()->setText(toText()); }

void ResultTable::fitRows() { verticalHeader()->setDefaultSectionSize(static_cast<int>(1.6 * fontMetrics().height())); }

void ResultTable::colour(QStandardItem& item) const
{
    if (item.data(failedRole).toBool()) item.setForeground(meaningColours(palette()).failure);
}

void ResultTable::changeEvent(QEvent* event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitRows();
    if (event->type() != QEvent::PaletteChange) return;
    for (int row = 0; row < content_.rowCount(); ++row)
        for (int column = 0; column < content_.columnCount(); ++column) colour(*content_.item(row, column));
}

void ResultTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) return copy();
    QTableView::keyPressEvent(event);
}

QToolButton* quietButton(const QString& text, const QString& tip, const QString& name, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(plainTip(tip));
    button->setAccessibleName(name);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace touchdown
