// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_table.h"

#include <cmath>

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

enum TableColumn { nameColumn, firstColumn, secondColumn, differenceColumn, unitColumn, columnCount };

constexpr int lookRole = Qt::UserRole; // of the line that a row shows

/// Another number for each look of a line.
int lookOf(const CursorReading& reading)
{
    return 1 + 100 * reading.style.colour + 10 * reading.style.dash + reading.pale;
}

QIcon lineSample(const CursorReading& reading, const PlotTheme& theme)
{
    constexpr double sharp = 2.0; // for dense screens
    QPixmap picture(static_cast<int>(22 * sharp), static_cast<int>(12 * sharp));
    picture.setDevicePixelRatio(sharp);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(reading.pale ? palePen(reading.style, theme) : curvePen(reading.style, theme));
    painter.drawLine(QPointF(1.0, 6.0), QPointF(21.0, 6.0));
    return picture;
}

} // namespace

CursorTable::CursorTable(PlotGroup* group, QWidget* parent)
    : QWidget(parent), group_(group), times_(new QLabel(this)), table_(new QTableWidget(0, columnCount, this))
{
    times_->setContentsMargins(6, 4, 6, 4);
    times_->setWordWrap(true);
    times_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    times_->setAccessibleName(tr("Times of the cursors"));
    table_->setAccessibleName(tr("Values at the cursors"));
    makePlainTable(table_, {tr("Quantity"), tr("At 1"), tr("At 2"), tr("2 \u2212 1"), tr("Unit")});
    table_->horizontalHeader()->setHighlightSections(false);
    for (int column = 0; column < columnCount; ++column) {
        const bool text = column == nameColumn || column == unitColumn;
        table_->horizontalHeaderItem(column)->setTextAlignment((text ? Qt::AlignLeft : Qt::AlignRight) |
                                                               Qt::AlignVCenter);
    }
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->setTextElideMode(Qt::ElideLeft); // "…Air springs, run 2" says more than "Energy: …"
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setIconSize({22, 12});
    table_->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(times_);
    layout->addWidget(table_);

    timer_.setSingleShot(true);
    timer_.setInterval(16);
    connect(&timer_, &QTimer::timeout, this, &CursorTable::fill);
    connect(group, &PlotGroup::cursorMoved, this, &CursorTable::scheduleUpdate);
    fill();
}

void CursorTable::scheduleUpdate()
{
    stale_ = true;
    if (isVisible() && !timer_.isActive()) timer_.start();
}

void CursorTable::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (stale_) fill();
}

void CursorTable::fill()
{
    stale_ = false;
    const auto readings = group_->readings();
    table_->setRowCount(static_cast<int>(readings.size()));
    const PlotTheme theme = plotTheme(palette());
    const auto put = [this](int row, int column, const QString& text) {
        QTableWidgetItem* item = table_->item(row, column);
        if (item == nullptr) {
            item = new QTableWidgetItem;
            if (column != nameColumn && column != unitColumn) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(row, column, item);
        }
        if (item->text() != text) item->setText(text);
        return item;
    };
    for (int row = 0; row < table_->rowCount(); ++row) {
        const CursorReading& reading = readings[static_cast<std::size_t>(row)];
        const PlotAxis& y = reading.plot->yAxis();
        const auto number = [&](std::optional<double> value) { return value ? y.reading(*value) : QString(); };
        const bool both = reading.first && reading.second;
        QTableWidgetItem* name = put(row, nameColumn, reading.name);
        if (name->data(lookRole).toInt() != lookOf(reading)) { // drawing one costs more than all the text of a row
            name->setData(lookRole, lookOf(reading));
            name->setIcon(lineSample(reading, theme));
        }
        if (name->toolTip() != reading.name) name->setToolTip(reading.name);
        put(row, firstColumn, number(reading.first));
        put(row, secondColumn, number(reading.second));
        put(row, differenceColumn, both ? number(*reading.second - *reading.first) : QString());
        put(row, unitColumn, y.label.unit);
    }

    // The second cursor's columns come with it: without them the names have room.
    const bool second = group_->cursor(1).has_value();
    table_->setColumnHidden(secondColumn, !second);
    table_->setColumnHidden(differenceColumn, !second);

    QStringList parts;
    const auto t1 = group_->cursor(0);
    const auto t2 = group_->cursor(1);
    const auto add = [&](const QString& symbol, double value) {
        const PlotAxis& x = readings.front().plot->xAxis();
        parts += QStringLiteral("%1\u00a0=\u00a0%2\u00a0%3").arg(symbol, x.number(value), x.label.unit);
    };
    if (!readings.empty()) {
        if (t1) add(QStringLiteral("t\u2081"), *t1);
        if (t2) add(QStringLiteral("t\u2082"), *t2);
        if (t1 && t2) add(QStringLiteral("\u0394t"), *t2 - *t1);
        if (t1 && t2 && *t1 != *t2)
            parts += QStringLiteral("1/\u2060\u0394t\u00a0=\u00a0") + frequencyText(1.0 / std::abs(*t2 - *t1));
    }
    times_->setText(parts.isEmpty() ? tr("Move over a plot; click sets cursor 1, Shift + click cursor 2.")
                                    : parts.join(QStringLiteral("    ")));
}

QString CursorTable::asText() const
{
    QStringList lines{times_->text()};
    QStringList header;
    for (int column = 0; column < columnCount; ++column) header += table_->horizontalHeaderItem(column)->text();
    lines += header.join(u'\t');
    for (int row = 0; row < table_->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < columnCount; ++column) cells += table_->item(row, column)->text();
        lines += cells.join(u'\t').replace(QChar(0x2212), u'-'); // a spreadsheet reads no other minus
    }
    return lines.join(u'\n') + u'\n';
}

bool CursorTable::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == table_ && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        QGuiApplication::clipboard()->setText(asText());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void CursorTable::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        table_->setRowCount(0); // the lines have other colours
        scheduleUpdate();
    }
    if (event->type() == QEvent::FontChange)
        table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
}

} // namespace touchdown
