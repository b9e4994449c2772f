// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_table.h"

#include <algorithm>
#include <cmath>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/plot/cursor_place.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

enum TableColumn { nameColumn, firstColumn, secondColumn, differenceColumn, ratioColumn, columnCount };

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
    painter.drawLine(QPointF(1.0, 6.5), QPointF(21.0, 6.5)); // fills one row of pixels
    return picture;
}

bool overFrequency(const PlotGroup& group) { return group.across() == PlotGroup::Across::Frequency; }

/// 10 log10 of the ratio of two powers [dB]; nothing where one of them is not positive.
std::optional<double> ratioOf(const CursorReading& reading)
{
    if (!reading.first || !reading.second || !(*reading.first > 0.0) || !(*reading.second > 0.0)) return std::nullopt;
    return 10.0 * std::log10(*reading.second / *reading.first);
}

/// The quantities that the ratio compares, by the unit of the spectrum.
QString powersName(const CursorReading& reading)
{
    const bool density = reading.plot->yAxis().label.unit.endsWith(QLatin1String("/Hz"));
    return density ? CursorTable::tr("densities") : CursorTable::tr("squared amplitudes");
}

/// A power with three digits, so that a narrow table has room for the names.
QString powerText(double value, const AxisLabel& label)
{
    const double shown = value / label.factor;
    const int exponent = shown == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(shown))));
    if (exponent >= -2 && exponent < 4) return typeset(shown, std::max(0, 2 - exponent));
    return typeset(shown / std::pow(10.0, exponent), 2) + QChar(0x00b7) + powerOfTen(exponent);
}

/// Whether readings() would give any, at little cost.
bool hasReadings(const PlotGroup* group)
{
    return std::ranges::any_of(group->plots(), [](const PlotWidget* plot) {
        const auto isRead = [](const PlotCurve& curve) { return curve.visible && curve.data; };
        return !plot->isPhasePortrait() && std::ranges::any_of(plot->curves(), isRead);
    });
}

QString signedFrequency(double hertz)
{
    return (hertz < 0.0 ? QStringLiteral("\u2212") : QString()) + frequencyText(std::abs(hertz));
}

/// A number for a spreadsheet, in the display unit.
QString plainNumber(std::optional<double> value, double factor)
{
    return value ? QLocale().toString(*value / factor, 'g', 6).replace(QChar(0x2212), u'-') : QString();
}

QString withUnit(const QString& name, const QString& unit)
{
    return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

} // namespace

CursorTable::CursorTable(PlotGroup* group, QWidget* parent)
    : QWidget(parent),
      shown_(group),
      tabs_(new QTabBar(this)),
      copy_(new QToolButton(this)),
      places_(new QLabel(this)),
      table_(new QTableWidget(0, columnCount, this))
{
    tabs_->setAccessibleName(tr("Cursors that are read"));
    tabs_->setDrawBase(false);
    tabs_->setDocumentMode(true);
    tabs_->setExpanding(false);
    copy_->setText(tr("Copy table"));
    copy_->setToolTip(
        plainTip(tr("Copy the table for a spreadsheet: tab separated, with the units in the heads (Ctrl+C)")));
    copy_->setAccessibleName(tr("Copy the table of the values at the cursors"));
    copy_->setAutoRaise(true);
    copy_->setFocusPolicy(Qt::TabFocus);
    places_->setContentsMargins(6, 4, 6, 4);
    places_->setWordWrap(true);
    places_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    table_->setAccessibleName(tr("Values at the cursors"));
    makePlainTable(table_, {tr("Quantity"), tr("At 1"), tr("At 2"), tr("2 \u2212 1"), tr("dB")});
    table_->horizontalHeader()->setHighlightSections(false);
    for (int column = 0; column < columnCount; ++column)
        table_->horizontalHeaderItem(column)->setTextAlignment((column == nameColumn ? Qt::AlignLeft : Qt::AlignRight) |
                                                               Qt::AlignVCenter);
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    table_->setTextElideMode(Qt::ElideMiddle);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setIconSize({22, 12});
    table_->installEventFilter(this);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 4, 0);
    row->addWidget(tabs_);
    row->addStretch(1);
    row->addWidget(copy_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(row);
    layout->addWidget(places_);
    layout->addWidget(table_);

    timer_.setSingleShot(true);
    timer_.setInterval(16);
    connect(&timer_, &QTimer::timeout, this, &CursorTable::fill);
    add(group);
    connect(tabs_, &QTabBar::currentChanged, this,
            [this](int tab) { showGroup(groups_[static_cast<std::size_t>(tab)]); });
    connect(copy_, &QToolButton::clicked, this, &CursorTable::copy);
    fill();
}

void CursorTable::add(PlotGroup* group)
{
    groups_.push_back(group);
    tabs_->addTab(overFrequency(*group) ? tr("Frequency") : tr("Time"));
    connect(group, &PlotGroup::cursorMoved, this, [this, group] { cursorMoved(group); });
    scheduleUpdate();
}

/// The cursor that leaves with the pointer gives the table back to the plots whose cursors are pinned.
void CursorTable::cursorMoved(PlotGroup* group)
{
    const auto used = std::ranges::find_if(groups_, &PlotGroup::hasCursors);
    if (group->hasCursors())
        showGroup(group);
    else if (group == shown_ && used != groups_.end())
        showGroup(*used);
    scheduleUpdate();
}

void CursorTable::showGroup(PlotGroup* group)
{
    shown_ = group;
    tabs_->setCurrentIndex(static_cast<int>(std::ranges::find(groups_, group) - groups_.begin()));
    scheduleUpdate();
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
    const auto full = std::ranges::find_if(groups_, hasReadings);
    tabs_->setVisible(std::ranges::count_if(groups_, hasReadings) > 1);
    if (full != groups_.end() && !hasReadings(shown_)) showGroup(*full);
    const bool frequency = overFrequency(*shown_);
    // Names without numbers would tell nothing, and each new run would write them all anew.
    const auto readings = shown_->hasCursors() ? shown_->readings() : std::vector<CursorReading>{};
    QStringList headings; // of each row
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const QString& heading = readings[i].heading;
        if (!heading.isEmpty() && (i == 0 || readings[i - 1].heading != heading)) headings += heading;
        headings += QString();
    }
    if (headings != headings_) { // other kinds of rows
        table_->setRowCount(0);
        table_->clearSpans();
        table_->setRowCount(static_cast<int>(headings.size()));
        headings_ = headings;
    }
    int row = 0;
    for (const CursorReading& reading : readings) {
        if (!headings[row].isEmpty()) fillHeading(row++, reading);
        fillRow(row++, reading);
    }
    table_->horizontalHeaderItem(nameColumn)->setText(frequency ? tr("Run") : tr("Quantity"));

    // The second cursor's columns come with it: without them the names have room.
    const bool second = shown_->cursor(1).has_value();
    table_->setColumnHidden(secondColumn, !second);
    table_->setColumnHidden(differenceColumn, !second);
    table_->setColumnHidden(ratioColumn, !second || !frequency);
    copy_->setEnabled(shown_->hasCursors() && !readings.empty());

    places_->setAccessibleName(frequency ? tr("Frequencies of the cursors") : tr("Times of the cursors"));
    const QString places = placesText();
    places_->setText(places.isEmpty() ? tr("Move over a plot; click sets cursor 1, Shift + click cursor 2.") : places);
}

QTableWidgetItem* CursorTable::put(int row, int column, const QString& text)
{
    QTableWidgetItem* item = table_->item(row, column);
    if (item == nullptr) {
        item = new QTableWidgetItem;
        if (column != nameColumn) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        table_->setItem(row, column, item);
    }
    if (item->text() != text) item->setText(text);
    return item;
}

/// The quantity over the whole width, with its unit.
void CursorTable::fillHeading(int row, const CursorReading& reading)
{
    QTableWidgetItem* item = put(row, nameColumn, withUnit(reading.heading, reading.plot->yAxis().label.unit));
    if (table_->columnSpan(row, nameColumn) == columnCount) return;
    table_->setSpan(row, nameColumn, 1, columnCount);
    QFont bold = table_->font();
    bold.setBold(true);
    item->setFont(bold);
    item->setFlags(Qt::ItemIsEnabled);
}

void CursorTable::fillRow(int row, const CursorReading& reading)
{
    const bool frequency = overFrequency(*shown_);
    const PlotAxis& y = reading.plot->yAxis();
    const auto number = [&](std::optional<double> value) {
        return !value ? QString() : frequency ? powerText(*value, y.label) : y.reading(*value);
    };
    // The number in front tells runs apart however their names are cut.
    QString text = reading.entry;
    if (reading.run > 0) text = QStringLiteral("%1  %2").arg(QString::number(reading.run), reading.entry);
    // The unit stands in the heading, of spectra above the table.
    if (reading.heading.isEmpty() && !frequency) text = withUnit(text, y.label.unit);
    QTableWidgetItem* item = put(row, nameColumn, text);
    if (item->data(lookRole).toInt() != lookOf(reading)) { // drawing one costs more than all the text of a row
        item->setData(lookRole, lookOf(reading));
        QIcon& sample = samples_[lookOf(reading)];
        if (sample.isNull()) sample = lineSample(reading, plotTheme(palette()));
        item->setIcon(sample);
    }
    item->setToolTip(plainTip(reading.name));
    const bool both = reading.first && reading.second;
    const auto ratio = frequency ? ratioOf(reading) : std::nullopt;
    put(row, firstColumn, number(reading.first));
    put(row, secondColumn, number(reading.second));
    put(row, differenceColumn, both ? number(*reading.second - *reading.first) : QString());
    put(row, ratioColumn, ratio ? typesetChange(*ratio, 1) : QString());
}

QString CursorTable::placesText() const
{
    const auto readings = shown_->readings();
    const auto first = shown_->cursor(0);
    const auto second = shown_->cursor(1);
    if (readings.empty()) return {};
    const PlotWidget& plot = *readings.front().plot;
    const bool frequency = overFrequency(*shown_);
    QStringList parts;
    const auto add = [&](const QString& symbol, double value) {
        const QString number =
            frequency ? signedFrequency(value) : plot.xAxis().number(value) + QChar(0x00a0) + plot.xAxis().label.unit;
        parts += QStringLiteral("%1\u00a0=\u00a0%2").arg(symbol, number);
    };
    const auto addPlace = [&](int which, const QString& time, const QString& hertz) {
        const auto at = shown_->cursor(which);
        if (!at) return;
        add(frequency ? hertz : time, *at);
        if (frequency && isAtPeak(plot, *at)) parts.back() += QChar(0x00a0) + tr("(peak)");
    };
    addPlace(0, QStringLiteral("t\u2081"), QStringLiteral("f\u2081"));
    addPlace(1, QStringLiteral("t\u2082"), QStringLiteral("f\u2082"));
    if (first && second) {
        add(frequency ? QStringLiteral("\u0394f") : QStringLiteral("\u0394t"), *second - *first);
        if (!frequency && *first != *second)
            parts += QStringLiteral("1/\u2060\u0394t\u00a0=\u00a0") + frequencyText(1.0 / std::abs(*second - *first));
    }
    if (frequency && shown_->hasCursors()) {
        parts += withUnit(powersName(readings.front()), plot.yAxis().label.unit);
        if (first && second) parts.back() += tr(", dB:\u00a010\u00a0log\u2081\u2080\u00a0of\u00a02\u00a0/\u00a01");
    }
    return parts.join(QStringLiteral("    "));
}

QString CursorTable::asText() const
{
    const auto readings = shown_->readings();
    if (readings.empty()) return {};
    const bool frequency = overFrequency(*shown_);
    const PlotWidget& plot = *readings.front().plot;
    const AxisLabel& x = plot.xAxis().label;
    const auto first = shown_->cursor(0);
    const auto second = shown_->cursor(1);
    const auto difference = [](std::optional<double> from, std::optional<double> to) {
        return from && to ? std::optional(*to - *from) : std::nullopt;
    };
    const auto head = [&](const QString& text, std::optional<double> at) {
        return frequency && at && isAtPeak(plot, *at) ? tr("%1 (peak)").arg(text) : text;
    };
    QStringList lines;
    const auto add = [&](QStringList cells) {
        if (!frequency) cells.removeLast(); // the ratio
        lines += cells.replaceInStrings(QStringLiteral("\t"), QStringLiteral(" ")).join(u'\t');
    };
    add({frequency ? tr("Run") : tr("Quantity"), head(tr("At 1"), first), head(tr("At 2"), second), tr("2 - 1"),
         tr("2 / 1 [dB, 10 log10 of the %1]").arg(powersName(readings.front()))});
    add({withUnit(x.title, x.unit),
         plainNumber(first, x.factor),
         plainNumber(second, x.factor),
         plainNumber(difference(first, second), x.factor),
         {}});
    if (!frequency && first && second && *first != *second)
        add({tr("1/(2 - 1) [kHz]"), {}, {}, plainNumber(1.0 / std::abs(*second - *first), 1e3), {}});
    for (const CursorReading& reading : readings) {
        const AxisLabel& y = reading.plot->yAxis().label;
        add({withUnit(reading.name, y.unit), plainNumber(reading.first, y.factor),
             plainNumber(reading.second, y.factor), plainNumber(difference(reading.first, reading.second), y.factor),
             plainNumber(ratioOf(reading), 1.0)});
    }
    return lines.join(u'\n') + u'\n';
}

void CursorTable::copy() const { QGuiApplication::clipboard()->setText(asText()); }

bool CursorTable::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == table_ && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        copy();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void CursorTable::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        headings_.clear(); // the lines have other colours, the headings another font
        samples_.clear();
        scheduleUpdate();
    }
    if (event->type() == QEvent::FontChange)
        table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
}

} // namespace touchdown
