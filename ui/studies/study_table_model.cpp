// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_table_model.h"

#include <cmath>

#include <QLocale>

#include "core/formats/units.h"
#include "ui/plot/plot_axis.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int digits = 5; // significant

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
    if (size >= 1e-3 && size < 1e6) return plain(QString::number(value, 'g', size >= 1e5 ? 6 : digits));
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    return plain(QString::number(value / std::pow(10.0, exponent), 'g', digits)) + QChar(0x00B7) + powerOfTen(exponent);
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
    if (const auto* words = std::get_if<std::string>(&value)) return QString::fromStdString(*words);
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
        return text(column, value); // it may be cut off
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
    const QString title = QString::fromStdString(column.longName.empty() ? column.name : column.longName);
    const QString unit = unitText(column.displayUnit.empty() ? column.unit : column.displayUnit);
    if (role == Qt::DisplayRole) return unit.isEmpty() ? title : QStringLiteral("%1 [%2]").arg(title, unit);
    if (role == Qt::ToolTipRole) return QStringLiteral("%1 (%2)").arg(title, QString::fromStdString(column.name));
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

} // namespace touchdown
