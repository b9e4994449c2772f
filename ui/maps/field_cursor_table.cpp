// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_cursor_table.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QHeaderView>

#include "core/formats/units.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int distanceColumn = 3;

QString titled(const QString& name, const QString& unit) { return QStringLiteral("%1 [%2]").arg(name, unit); }

/// As the map reads it, without the unit.
QString placeNumber(const FieldMap& map, double at)
{
    return typeset(at / unitFactor(map.lengthUnit()), map.lengthUnit() == "mm" ? 4 : 2);
}

std::optional<double> valueOf(const OtherField& field, const SurfacePoint& point)
{
    const int i = cellIndex(field.grid.x, point.x), j = cellIndex(field.grid.y, point.y);
    if (i < 0 || j < 0) return std::nullopt;
    return field.points.at(point).value_or(field.values[static_cast<std::size_t>(j * field.grid.nx() + i)]);
}

std::optional<double> difference(std::optional<double> from, std::optional<double> to)
{
    return from && to ? std::optional(*to - *from) : std::nullopt;
}

} // namespace

FieldCursorTable::FieldCursorTable(QWidget* parent)
    : QWidget(parent), table_(new ResultTable(tr("Values at the cursors of the map"), this))
{
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->setToolTip(plainTip(tr(
        "Click on the map sets cursor 1, Shift + click cursor 2; Shift + arrows move 1, Ctrl + Shift + arrows move 2; "
        "Escape takes cursor 2 away")));
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* copy = quietButton(
        tr("Copy table"), tr("Copy the table for a spreadsheet: tab separated, with the units in the heads (Ctrl+C)"),
        tr("Copy the table of the values at the cursors of the map"), this);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 4, 0);
    row->addWidget(table_, 1);
    row->addWidget(copy, 0, Qt::AlignTop);
    connect(copy, &QToolButton::clicked, table_, &ResultTable::copy);
    hide();
}

void FieldCursorTable::show(const FieldMap& map, const FieldCursors& cursors, const QString& name,
                            const std::vector<OtherField>& others)
{
    const FieldLook& look = map.look();
    const QString length = unitText(map.lengthUnit());
    TableRow heads{{tr("Cursor")},
                   {titled(QStringLiteral("x"), length)},
                   {titled(QStringLiteral("y"), length)},
                   {titled(tr("Distance"), length)},
                   {titled(others.empty() ? look.title : tr("%1, %2").arg(look.title, name), look.unit)}};
    for (const OtherField& other : others) heads.push_back({titled(other.name, look.unit)});

    // The values at each cursor, in the order of the columns.
    std::array<std::optional<SurfacePoint>, 2> seen;
    std::array<std::vector<std::optional<double>>, 2> values;
    for (std::size_t which = 0; which < 2; ++which) {
        const auto value = cursors[which] ? map.valueAt(*cursors[which]) : std::nullopt;
        if (!value) continue;
        seen[which] = cursors[which];
        values[which].push_back(value);
        for (const OtherField& other : others) values[which].push_back(valueOf(other, *cursors[which]));
    }
    setVisible(seen[0].has_value());
    if (!seen[0]) return;

    std::vector<TableRow> rows;
    const auto add = [&](const QString& head, double x, double y, const QString& distance, const auto& numbers) {
        TableRow row{{head}, numberCell(placeNumber(map, x)), numberCell(placeNumber(map, y)), numberCell(distance)};
        for (const auto& number : numbers) row.push_back(numberCell(number ? fieldNumber(*number, look) : QString()));
        rows.push_back(std::move(row));
    };
    add(QStringLiteral("1"), seen[0]->x, seen[0]->y, {}, values[0]);
    if (seen[1]) {
        add(QStringLiteral("2"), seen[1]->x, seen[1]->y, {}, values[1]);
        std::vector<std::optional<double>> changes;
        for (std::size_t k = 0; k < values[0].size(); ++k) changes.push_back(difference(values[0][k], values[1][k]));
        const double dx = seen[1]->x - seen[0]->x, dy = seen[1]->y - seen[0]->y;
        add(QStringLiteral("2 \u2212 1"), dx, dy, placeNumber(map, std::hypot(dx, dy)), changes);
    }
    table_->setRows(heads, rows);
    table_->setColumnHidden(distanceColumn, !seen[1]);
    fitHeight();
}

/// As high as its rows.
void FieldCursorTable::fitHeight()
{
    const int height = table_->horizontalHeader()->sizeHint().height() + table_->verticalHeader()->length();
    table_->setFixedHeight(height + 2 * table_->frameWidth() + 2);
}

} // namespace touchdown
