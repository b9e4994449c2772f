// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_table.h"

#include <cmath>

#include <QLocale>

#include "core/formats/units.h"
#include "ui/case/choice_text.h"
#include "ui/plot/plot_axis.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

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

TableCell cellOf(const StudyColumn& column, const StudyValue& value)
{
    if (const auto* words = std::get_if<std::string>(&value)) {
        const QString choice = choiceText(column.longName, *words).name; // where the column has a key of the case
        const QString text = choice.isEmpty() ? readable(*words) : choice;
        return {text, Qt::AlignLeft, text, QString::fromStdString(*words)}; // the tip: it may be cut off
    }
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr) return numberCell(QString(QChar(0x2013)));
    return {numberText(column.displayUnit.empty() ? *number : *number / unitFactor(column.displayUnit)),
            Qt::AlignRight,
            {},
            *number};
}

} // namespace

TableRow headsOf(const StudyTable& table)
{
    TableRow heads;
    for (const StudyColumn& column : table.columns) {
        const QString title = readable(column.longName.empty() ? column.name : column.longName);
        const QString unit = unitText(column.displayUnit.empty() ? column.unit : column.displayUnit);
        heads.push_back({unit.isEmpty() ? title : QStringLiteral("%1 [%2]").arg(title, unit), Qt::AlignLeft,
                         QStringLiteral("%1 (%2)").arg(title, QString::fromStdString(column.name))});
    }
    return heads;
}

std::vector<TableRow> rowsOf(const StudyTable& table)
{
    std::vector<TableRow> rows;
    for (const std::vector<StudyValue>& values : table.rows) {
        TableRow row;
        for (std::size_t i = 0; i < values.size(); ++i) row.push_back(cellOf(table.columns[i], values[i]));
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace touchdown
