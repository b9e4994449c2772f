// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_table.h"

#include <algorithm>

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

namespace touchdown {

namespace {

constexpr int widestColumn = 420; // [px]: a sentence in a cell must not push the rest out of sight

} // namespace

StudyTableView::StudyTableView(QWidget* parent) : QTableView(parent)
{
    order_.setSourceModel(&model_);
    setModel(&order_);
    setSortingEnabled(true);
    order_.sort(-1); // in the order of the study until the user sorts
    horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    horizontalHeader()->setSortIndicatorClearable(true);
    horizontalHeader()->setStretchLastSection(false);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->hide();
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setAccessibleName(tr("Table of the study"));
}

void StudyTableView::setTable(StudyTable table)
{
    const bool same =
        std::ranges::equal(table.columns, model_.table().columns, {}, &StudyColumn::name, &StudyColumn::name);
    setAccessibleName(tr("Table %1").arg(QString::fromStdString(table.name)));
    model_.setTable(std::move(table));
    if (!same) horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    resizeColumnsToContents();
    for (int i = 0; i < model_.columnCount(); ++i) setColumnWidth(i, std::min(columnWidth(i) + 12, widestColumn));
    verticalHeader()->setDefaultSectionSize(static_cast<int>(1.5 * fontMetrics().height()));
}

QString StudyTableView::toText() const
{
    const bool all = !selectionModel()->hasSelection();
    QStringList head, lines;
    for (int column = 0; column < order_.columnCount(); ++column)
        head << order_.headerData(column, Qt::Horizontal).toString();
    lines << head.join(QLatin1Char('\t'));
    for (int row = 0; row < order_.rowCount(); ++row) {
        if (!all && !selectionModel()->isRowSelected(row)) continue;
        QStringList cells;
        for (int column = 0; column < order_.columnCount(); ++column)
            cells << order_.index(row, column).data().toString();
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void StudyTableView::copy() const { QGuiApplication::clipboard()->setText(toText()); }

void StudyTableView::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) return copy();
    QTableView::keyPressEvent(event);
}

} // namespace touchdown
