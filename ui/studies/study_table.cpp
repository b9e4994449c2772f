// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_table.h"

#include <algorithm>
#include <cmath>

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>

#include "core/formats/units.h"
#include "ui/case/choice_text.h"
#include "ui/plot/plot_axis.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr int widestColumn = 420; // [px]: a sentence in a cell must not push the rest out of sight

constexpr int cellDigits = 5; // significant

/// "0.030000" as "0.03", "1.2e-07" as "1.2·10⁻⁷"; whole numbers as they are.
QString numberText(double value)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const auto plain = [&locale](QString text) {
        return text.replace(QLatin1Char('.'), locale.decimalPoint()).replace(QLatin1Char('-'), QChar(0x2212));
    };
    if (value == 0.0) return QStringLiteral("0");
    const double size = std::abs(value);
    if (size < 1e9 && value == std::round(value)) return plain(QString::number(static_cast<qlonglong>(value)));
    if (size >= 1e-3 && size < 1e6) return plain(QString::number(value, 'g', size >= 1e5 ? 6 : cellDigits));
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    return plain(QString::number(value / std::pow(10.0, exponent), 'g', cellDigits)) + QChar(0x00B7) +
           powerOfTen(exponent);
}

} // namespace

void StudyTableModel::setTable(StudyTable table)
{
    beginResetModel();
    table_ = std::move(table);
    endResetModel();
}

int StudyTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(table_.rows.size());
}

int StudyTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(table_.columns.size());
}

QString StudyTableModel::text(const StudyColumn& column, const StudyValue& value) const
{
    if (const auto* words = std::get_if<std::string>(&value)) {
        const QString choice = choiceText(column.longName, *words).name; // where the column has a key of the case
        return choice.isEmpty() ? readable(*words) : choice;
    }
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr) return QString(QChar(0x2013));
    return numberText(column.displayUnit.empty() ? *number : *number / unitFactor(column.displayUnit));
}

QVariant StudyTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    const StudyColumn& column = table_.columns[static_cast<std::size_t>(index.column())];
    const StudyValue& value =
        table_.rows[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())];
    if (role == Qt::DisplayRole) return text(column, value);
    if (role == Qt::ToolTipRole && std::holds_alternative<std::string>(value))
        return plainTip(text(column, value)); // it may be cut off
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue((std::holds_alternative<std::string>(value) ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
    if (role == SortRole) {
        if (const auto* number = std::get_if<double>(&value)) return *number;
        if (const auto* words = std::get_if<std::string>(&value)) return QString::fromStdString(*words);
    }
    return {};
}

QVariant StudyTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return QAbstractTableModel::headerData(section, orientation, role);
    const StudyColumn& column = table_.columns[static_cast<std::size_t>(section)];
    const QString title = readable(column.longName.empty() ? column.name : column.longName);
    const QString unit = unitText(column.displayUnit.empty() ? column.unit : column.displayUnit);
    if (role == Qt::DisplayRole) return unit.isEmpty() ? title : QStringLiteral("%1 [%2]").arg(title, unit);
    if (role == Qt::ToolTipRole)
        return plainTip(QStringLiteral("%1 (%2)").arg(title, QString::fromStdString(column.name)));
    return QAbstractTableModel::headerData(section, orientation, role);
}

bool StudyTableOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
    const QVariant a = left.data(StudyTableModel::SortRole), b = right.data(StudyTableModel::SortRole);
    // Unknown values come last in both directions.
    if (!a.isValid() || !b.isValid())
        return a.isValid() == b.isValid() ? false : a.isValid() == (sortOrder() == Qt::AscendingOrder);
    if (a.typeId() == QMetaType::Double && b.typeId() == QMetaType::Double) return a.toDouble() < b.toDouble();
    return a.toString().localeAwareCompare(b.toString()) < 0;
}

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
