// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_setup.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int mostStates = 101;

const char* keyOf(Varied varied)
{
    switch (varied) {
    case Varied::Skew: return "disk.skew";
    case Varied::Speed: return "disk.speed";
    case Varied::Altitude: return "air.altitude";
    default: return "disk.radius";
    }
}

void setUnit(QDoubleSpinBox* box, Varied varied)
{
    const Quantity quantity = quantityOf(varied);
    const Parameter* parameter = findParameter(keyOf(varied));
    const double unit = unitFactor(quantity.displayUnit);
    const double least = parameter->minimumAllowed ? parameter->minimum / unit : 0.01;
    box->setDecimals(varied == Varied::Speed || varied == Varied::Altitude ? 0 : 2);
    box->setRange(least, parameter->maximum / unit);
    box->setSingleStep(varied == Varied::Speed || varied == Varied::Altitude ? 100.0 : 1.0);
    box->setSuffix(QChar(0x00A0) + unitText(quantity.displayUnit));
}

/// The value in the box, or `set` where it is that one rounded [SI].
double exactValue(const QDoubleSpinBox* box, double unit, double set)
{
    const double half = 0.51 * std::pow(10.0, -box->decimals());
    return std::abs(box->value() - set / unit) < half ? set : box->value() * unit;
}

} // namespace

SeriesSetup::SeriesSetup(QWidget* parent)
    : QWidget(parent),
      varied_(new QComboBox(this)),
      from_(new QDoubleSpinBox(this)),
      to_(new QDoubleSpinBox(this)),
      skewFrom_(new QDoubleSpinBox(this)),
      skewTo_(new QDoubleSpinBox(this)),
      states_(new QSpinBox(this)),
      lists_(new QLabel(this))
{
    varied_->addItems({tr("Radius"), tr("Skew"), tr("Speed"), tr("Altitude")}); // in the order of Varied
    varied_->setAccessibleName(tr("What varies in the series"));
    from_->setAccessibleName(tr("First value of the series"));
    to_->setAccessibleName(tr("Last value of the series"));
    skewFrom_->setAccessibleName(tr("Skew at the first radius"));
    skewTo_->setAccessibleName(tr("Skew at the last radius"));
    states_->setAccessibleName(tr("Number of states"));
    states_->setRange(2, mostStates);
    setUnit(skewFrom_, Varied::Skew);
    setUnit(skewTo_, Varied::Skew);

    const auto label = [&](const QString& text, QWidget* buddy) {
        auto* made = new QLabel(text, this);
        made->setBuddy(buddy);
        return made;
    };
    ends_ = {label(tr("from"), from_), from_,   label(tr("to"), to_),        to_,
             label(tr("in"), states_), states_, label(tr("states"), states_)};
    skews_ = {label(tr("with a skew from"), skewFrom_), skewFrom_, label(tr("to"), skewTo_), skewTo_};
    auto* upper = new QHBoxLayout;
    upper->addWidget(varied_);
    for (QWidget* widget : ends_) upper->addWidget(widget);
    upper->addWidget(lists_);
    upper->addStretch(1);
    auto* lower = new QHBoxLayout; // two rows: the window may be narrow
    for (QWidget* widget : skews_) lower->addWidget(widget);
    lower->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (QHBoxLayout* row : {upper, lower}) {
        row->setSpacing(6);
        layout->addLayout(row);
    }
    for (QDoubleSpinBox* box : {from_, to_, skewFrom_, skewTo_}) box->setKeyboardTracking(false);
    states_->setKeyboardTracking(false);
    connect(varied_, &QComboBox::currentIndexChanged, this, &SeriesSetup::takeUsual);
    open(Case{});
}

Varied SeriesSetup::varied() const { return static_cast<Varied>(std::max(0, varied_->currentIndex())); }

void SeriesSetup::offerLists()
{
    const int lists = static_cast<int>(Varied::Lists);
    const QSignalBlocker quiet(varied_);
    if (hasLists(case_) && varied_->count() == lists) varied_->addItem(tr("Lists of the case"));
    if (!hasLists(case_) && varied_->count() > lists) varied_->removeItem(lists);
    lists_->setText(tr("%1 states, as the case lists them").arg(seriesOf(case_).size()));
}

void SeriesSetup::open(const Case& c)
{
    case_ = c;
    offerLists();
    const QSignalBlocker quiet(varied_);
    varied_->setCurrentIndex(static_cast<int>(hasLists(c) ? Varied::Lists : Varied::Radius));
    takeUsual();
}

void SeriesSetup::setCase(const Case& c)
{
    const Varied before = varied();
    const bool followed = choice() == usualChoice(case_, before);
    case_ = c;
    offerLists();
    if (followed || varied() != before) takeUsual();
}

void SeriesSetup::takeUsual() { setChoice(usualChoice(case_, varied())); }

void SeriesSetup::setChoice(const SeriesChoice& choice)
{
    {
        const QSignalBlocker quiet(varied_);
        varied_->setCurrentIndex(static_cast<int>(choice.varied));
    }
    set_ = choice;
    showUnits();
    const double unit = unitFactor(quantityOf(choice.varied).displayUnit), degree = unitFactor("deg");
    from_->setValue(choice.from / unit);
    to_->setValue(choice.to / unit);
    skewFrom_->setValue(choice.skewFrom / degree);
    skewTo_->setValue(choice.skewTo / degree);
    states_->setValue(choice.states);
}

SeriesChoice SeriesSetup::choice() const
{
    const double unit = unitFactor(quantityOf(varied()).displayUnit), degree = unitFactor("deg");
    return {varied(),
            exactValue(from_, unit, set_.from),
            exactValue(to_, unit, set_.to),
            exactValue(skewFrom_, degree, set_.skewFrom),
            exactValue(skewTo_, degree, set_.skewTo),
            states_->value()};
}

QString SeriesSetup::problem() const
{
    if (varied() == Varied::Lists || from_->value() != to_->value()) return {};
    return tr("The first and the last value are equal: nothing varies.");
}

void SeriesSetup::showUnits()
{
    const bool listed = varied() == Varied::Lists;
    if (!listed)
        for (QDoubleSpinBox* box : {from_, to_}) setUnit(box, varied());
    for (QWidget* widget : ends_) widget->setVisible(!listed);
    for (QWidget* widget : skews_) widget->setVisible(varied() == Varied::Radius);
    lists_->setVisible(listed);
    varied_->setToolTip(plainTip(varied() == Varied::Altitude
                                     ? tr("The air is then that of the standard atmosphere at each altitude")
                                     : tr("What varies from state to state; the rest is that of the case")));
}

} // namespace touchdown
