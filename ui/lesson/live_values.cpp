// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/live_values.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "ui/case/parameter_text.h"
#include "ui/lesson/marked_slider.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int digits = 3;

const Parameter& parameterOf(const LiveValue& value) { return *findParameter(value.keys.front()); }

double rounded(double number)
{
    if (number == 0.0) return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(number))) + 1 - digits);
    return std::round(number / unit) * unit;
}

/// From 0 at the lower end to 1 at the upper one.
double shareOf(const LiveValue& value, double number)
{
    const double within = std::clamp(number, value.from, value.until);
    return value.logarithmic() ? std::log(within / value.from) / std::log(value.until / value.from)
                               : (within - value.from) / (value.until - value.from);
}

double numberAt(const LiveValue& value, double share)
{
    const double number = value.logarithmic() ? value.from * std::pow(value.until / value.from, share)
                                              : value.from + share * (value.until - value.from);
    return std::clamp(rounded(number), value.from, value.until);
}

QString endText(const LiveValue& value, double number)
{
    return roundedText(number, parameterOf(value).displayUnit, digits);
}

} // namespace

LiveValues::LiveValues(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    hide();
}

void LiveValues::setValues(const std::vector<LiveValue>& values, const Case& own)
{
    for (const Row& row : rows_) {
        delete row.label;
        delete row.slider;
    }
    rows_.clear();
    for (const LiveValue& value : values) {
        const Parameter& parameter = parameterOf(value);
        Row row{value, numberOf(parameter, own), new MarkedSlider(this), new QLabel(this)};
        row.slider->setAccessibleName(sentence(parameter.label).chopped(1));
        row.slider->setToolTip(QString::fromStdString(parameter.help));
        row.slider->setMark(shareOf(value, row.own));
        row.slider->setEnds(endText(value, value.from), endText(value, value.until));
        connect(row.slider, &MarkedSlider::movedTo, this, [this, value, own = row.own, slider = row.slider](int step) {
            const bool atMark = step == slider->markedStep();
            emit moved(value, atMark ? own : numberAt(value, slider->share()));
        });
        connect(row.slider, &MarkedSlider::settled, this, &LiveValues::settled);
        layout()->addWidget(row.label);
        layout()->addWidget(row.slider);
        rows_.push_back(row);
    }
    setVisible(!rows_.empty());
    showCase(own);
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
        const QString symbol = parameter.symbol.empty() ? QString() : symbolText(parameter.symbol) + u' ';
        row.label->setText(QStringLiteral("%1<span style='color:%2'>%3</span>&nbsp; <b>%4</b>")
                               .arg(symbol, muted, QString::fromStdString(parameter.label).toHtmlEscaped(),
                                    valueText(case_, parameter).toHtmlEscaped()));
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
