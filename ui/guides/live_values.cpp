// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/live_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QLocale>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "ui/case/parameter_text.h"
#include "ui/guides/marked_slider.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int digits = 3;

const Parameter& parameterOf(const LiveValue& value) { return *findParameter(value.keys.front()); }

/// From 0 at the lower end to 1 at the upper one.
double shareOf(const LiveValue& value, double number)
{
    const double within = std::clamp(number, value.from, value.until);
    return value.logarithmic() ? std::log(within / value.from) / std::log(value.until / value.from)
                               : (within - value.from) / (value.until - value.from);
}

double numberAt(const LiveValue& value, double share)
{
    return value.logarithmic() ? value.from * std::pow(value.until / value.from, share)
                               : value.from + share * (value.until - value.from);
}

/// In the display unit, as a case file has it; rounded there, so that it is read back with these digits.
std::string textOf(const LiveValue& value, double number)
{
    const std::string& unit = parameterOf(value).displayUnit;
    const QString shown = QLocale::c().toString(number / unitFactor(unit), 'g', digits);
    return (unit.empty() ? shown : shown + u' ' + QString::fromStdString(unit)).toStdString();
}

QString endText(const LiveValue& value, double number)
{
    const std::string& unit = parameterOf(value).displayUnit;
    const QString shown = QLocale().toString(number / unitFactor(unit), 'g', digits);
    return unit.empty() ? shown : shown + u'\u00a0' + unitText(unit);
}

} // namespace

LiveValues::LiveValues(QWidget* parent, Qt::Orientation rows) : QWidget(parent)
{
    const bool beside = rows == Qt::Horizontal;
    auto* cells = new QBoxLayout(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, this);
    cells->setContentsMargins(0, 0, 0, 0);
    cells->setSpacing(beside ? 24 : 2);
    hide();
}

void LiveValues::setStep(const LessonStep& step)
{
    const bool ofCase = !step.runs.empty() && step.runs.front().kind.empty();
    setValues(ofCase ? step.live : std::vector<LiveValue>(), ofCase ? caseOf(step.runs.front()) : Case());
}

void LiveValues::setValues(const std::vector<LiveValue>& values, const Case& own)
{
    settle(); // the reader may not have let go
    for (const Row& row : rows_) delete row.cell;
    rows_.clear();
    for (const LiveValue& value : values) {
        const Parameter& parameter = parameterOf(value);
        auto* cell = new QWidget(this);
        Row row{value, numberOf(parameter, own), toText(own, parameter),
                cell,  new MarkedSlider(cell),   new QLabel(cell)};
        auto* column = new QVBoxLayout(cell);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(2);
        row.label->setWordWrap(true);
        row.label->setBuddy(row.slider);
        row.slider->setAccessibleName(sentence(parameter.label).chopped(1));
        row.label->setTextFormat(Qt::RichText);
        row.slider->setToolTip(plainTip(QString::fromStdString(parameter.help)));
        row.slider->setMark(shareOf(value, row.own));
        row.slider->setEnds(endText(value, value.from), endText(value, value.until));
        connect(
            row.slider, &MarkedSlider::movedTo, this, [this, value, own = row.ownText, slider = row.slider](int at) {
                moving_ = true;
                emit moved(value, at == slider->markedStep() ? own : textOf(value, numberAt(value, slider->share())));
            });
        connect(row.slider, &MarkedSlider::settled, this, &LiveValues::settle);
        column->addWidget(row.label);
        column->addWidget(row.slider);
        layout()->addWidget(cell);
        rows_.push_back(row);
    }
    setVisible(!rows_.empty());
    showCase(own);
}

void LiveValues::settle()
{
    if (!std::exchange(moving_, false)) return;
    emit settled();
    showCase(case_); // the sliders stand where the case is
}

void LiveValues::showCase(const Case& c)
{
    case_ = c;
    for (const Row& row : rows_) {
        const Parameter& parameter = parameterOf(row.value);
        row.slider->setEnabled(parameter.used(c));
        row.slider->setShare(shareOf(row.value, numberOf(parameter, c)));
    }
    write();
}

void LiveValues::write()
{
    const QString muted = meaningColours(palette()).muted.name();
    for (const Row& row : rows_) {
        const Parameter& parameter = parameterOf(row.value);
        const QString number = valueText(case_, parameter);
        row.slider->setAccessibleDescription(number);
        const QString label = QString::fromStdString(row.value.label.empty() ? parameter.label : row.value.label);
        const bool named = row.value.label.empty() && !parameter.symbol.empty();
        const QString symbol = named ? symbolText(parameter.symbol) + u' ' : QString();
        row.label->setText(QStringLiteral("%1<span style='color:%2'>%3</span>&nbsp; <b>%4</b>")
                               .arg(symbol, muted, label.toHtmlEscaped(), number.toHtmlEscaped()));
        row.label->setEnabled(row.slider->isEnabled());
    }
}

std::vector<QWidget*> LiveValues::inputs() const
{
    std::vector<QWidget*> all;
    for (const Row& row : rows_) all.push_back(row.slider);
    return all;
}

void LiveValues::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) write();
}

} // namespace touchdown
