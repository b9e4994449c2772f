// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/contact_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/quantity_format.h"

namespace touchdown {

namespace {

constexpr double weakPressure = 1e5; // what a logarithm about zero does not tell from zero [Pa]

MapKind kindOf(const Quantity& quantity)
{
    using Colours = MapKind::Colours;
    MapKind kind;
    kind.title = QString::fromStdString(quantity.longName);
    kind.units = {quantity.displayUnit};
    const auto offer = [&kind](const char* unit) {
        if (std::ranges::find(kind.units, unit) == kind.units.end()) kind.units.push_back(unit);
    };
    if (quantity.unit == "Pa") {
        offer("MPa");
        offer("GPa");
        kind.colours = Colours::Signed; // attraction is negative
        // Pressure of contact is zero where there is none, so that only what has two signs can have a logarithm.
        if (quantity.name != "contact_pressure") kind.logarithm = MapKind::Logarithm::Offered;
        kind.near = weakPressure;
    } else if (quantity.name == "gap") {
        kind.colours = Colours::BrightLow;
        kind.logarithm = MapKind::Logarithm::Offered;
    } else {
        kind.colours = Colours::Signed;
        kind.aboutZero = true;
    }
    if (quantity.unit == "m") {
        offer("nm");
        offer("um");
    }
    return kind;
}

/// On the tab; the map itself has the whole name.
QString shortName(const Quantity& quantity)
{
    if (quantity.name == "gap") return ContactMaps::tr("Gap");
    if (quantity.name == "adhesion_pressure") return ContactMaps::tr("Adhesion");
    if (quantity.name == "disk_surface") return ContactMaps::tr("Disk");
    return QString::fromStdString(quantity.longName);
}

bool sameRectangle(const CellGrid& grid, const SliderCase& slider)
{
    const double close = 1e-6 * slider.length;
    return std::abs(grid.x.front()) < close && std::abs(grid.y.front()) < close && std::abs(grid.x.back() - slider.length) < close
           && std::abs(grid.y.back() - slider.width) < close;
}

} // namespace

ContactMaps::ContactMaps(RunsModel& runs, QWidget* parent)
    : QWidget(parent),
      runs_(runs),
      tabs_(new QTabBar(this)),
      name_(new QLabel(this)),
      sameScale_(new QCheckBox(tr("Same sc&ale"), this)),
      view_(new FieldsView(this)),
      emptyText_(new QLabel(this)),
      pages_(new QStackedWidget(this)),
      foot_(new QWidget(this)),
      time_(new QSlider(Qt::Horizontal, this)),
      reading_(new QLabel(this))
{
    buildRows();
    connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) {
        if (tab >= 0) view_->setField(tab);
    });
    connect(sameScale_, &QCheckBox::toggled, this, &ContactMaps::showSnapshot);
    connect(time_, &QSlider::valueChanged, this, [this](int at) {
        follows_ = at == time_->maximum();
        showSnapshot();
        if (const RunRecord* shown = run()) emit timeChosen(shown->snapshots[static_cast<std::size_t>(at)].time);
    });
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        if (number == number_) showRun(-1);
    });
    refresh();
}

void ContactMaps::buildRows()
{
    tabs_->setAccessibleName(tr("Field"));
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    sameScale_->setChecked(true);
    sameScale_->setToolTip(tr("On: colours and sections span the whole run. Off: what is seen at this time."));
    time_->setAccessibleName(tr("Time of the maps"));
    time_->setToolTip(tr("Go through the times at which the run recorded its fields (arrow keys, Home, End)"));
    reading_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    emptyText_->setAlignment(Qt::AlignCenter);
    emptyText_->setWordWrap(true);
    emptyText_->setAutoFillBackground(true);
    emptyText_->setBackgroundRole(QPalette::Base); // as the maps that will stand there
    pages_->addWidget(view_);
    pages_->addWidget(emptyText_);

    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 4, 8, 4);
    row->setSpacing(8);
    row->addWidget(tabs_);
    row->addStretch(1);
    row->addWidget(name_);
    row->addWidget(sameScale_);
    row->addWidget(view_->controls());
    auto* below = new QHBoxLayout(foot_);
    below->setContentsMargins(10, 4, 10, 6);
    below->setSpacing(12);
    below->addWidget(time_, 1);
    below->addWidget(reading_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(row);
    layout->addWidget(pages_, 1);
    layout->addWidget(foot_);
}

void ContactMaps::showRun(int number)
{
    if (number == number_) return;
    number_ = number;
    follows_ = true;
    refresh();
}

void ContactMaps::dataArrived(int number)
{
    if (number == number_) refresh();
}

void ContactMaps::showTime(double time)
{
    const RunRecord* shown = run();
    if (!shown || shown->snapshots.empty() || stale_) return;
    const auto nearest = std::ranges::min_element(shown->snapshots, {}, [time](const FieldSnapshot& s) { return std::abs(s.time - time); });
    const QSignalBlocker quiet(time_);
    time_->setValue(static_cast<int>(nearest - shown->snapshots.begin()));
    follows_ = time_->value() == time_->maximum();
    showSnapshot();
}

void ContactMaps::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (stale_) refresh();
}

void ContactMaps::refresh()
{
    stale_ = !isVisible();
    if (stale_) return;
    const RunRecord* shown = run();
    const bool any = shown && !shown->snapshots.empty();
    if (any && taken_ != number_) takeFields(*shown);
    if (any) {
        const QSignalBlocker quiet(time_);
        const int last = static_cast<int>(shown->snapshots.size()) - 1;
        const int before = std::min(time_->value(), last);
        time_->setRange(0, last);
        time_->setPageStep(std::max(1, last / 10));
        time_->setValue(follows_ ? latestOf(*shown) : before);
    }
    pages_->setCurrentWidget(any ? static_cast<QWidget*>(view_) : emptyText_);
    emptyText_->setText(any ? QString() : whyEmpty());
    for (QWidget* part : {static_cast<QWidget*>(tabs_), static_cast<QWidget*>(name_), static_cast<QWidget*>(sameScale_), view_->controls(), foot_})
        part->setVisible(any);
    showSnapshot();
}

/// The last one; of a run that has ended the one nearest to the disk, as at its end pad and disk are apart again.
int ContactMaps::latestOf(const RunRecord& shown) const
{
    const MinMaxPyramid* separation = shown.pyramid("minimum_spacing");
    if (!shown.finished() || !separation) return static_cast<int>(shown.snapshots.size()) - 1;
    const auto nearest = std::ranges::min_element(shown.snapshots, {}, [&](const FieldSnapshot& snapshot) {
        return separation->valueAt(snapshot.time).value_or(std::numeric_limits<double>::infinity());
    });
    return static_cast<int>(nearest - shown.snapshots.begin());
}

void ContactMaps::takeFields(const RunRecord& run)
{
    taken_ = number_;
    const QString chosen = tabs_->tabText(tabs_->currentIndex());
    std::vector<MapKind> kinds;
    for (const Quantity& quantity : run.fields.quantities) kinds.push_back(kindOf(quantity));
    {
        const QSignalBlocker quiet(tabs_);
        while (tabs_->count() > 0) tabs_->removeTab(0);
        for (const Quantity& quantity : run.fields.quantities) {
            const int tab = tabs_->addTab(shortName(quantity));
            tabs_->setTabToolTip(tab, QString::fromStdString(quantity.longName));
            if (chosen.isEmpty() ? quantity.name == "contact_pressure" : tabs_->tabText(tab) == chosen) tabs_->setCurrentIndex(tab);
        }
    }
    view_->setKinds(std::move(kinds));
    view_->setField(std::max(0, tabs_->currentIndex()));
    const CellGrid& grid = run.fields.grid;
    if (sameRectangle(grid, run.value.slider)) view_->map()->setSlider(run.value.slider.length, run.value.slider.width);
    else view_->map()->setPiece({grid.x.front(), grid.y.front(), grid.x.back() - grid.x.front(), grid.y.back() - grid.y.front()});
    view_->map()->setSkew(run.value.disk.skew);
    if (!view_->pinned() || !view_->sectionPoint() || !view_->map()->onSlider(*view_->sectionPoint()))
        view_->setSectionPoint({grid.centreX(grid.nx() / 2), grid.centreY(grid.ny() / 2)}, false);
}

void ContactMaps::showSnapshot()
{
    const RunRecord* shown = run();
    if (!shown || shown->snapshots.empty() || !isVisible()) return;
    const auto index = static_cast<std::size_t>(std::clamp(time_->value(), 0, static_cast<int>(shown->snapshots.size()) - 1));
    view_->setFields(shown->fields.grid, shown->snapshots[index].values,
                     sameScale_->isChecked() ? shown->fieldRanges : std::vector<PlotRange>());
    name_->setText(runs_.count() > 1 ? tr("Run %1").arg(number_) : QString());
    reading_->setText(readingText(*shown, index));
    reading_->setToolTip(shown->fieldStride == 1 ? QString()
                                                 : tr("The run has recorded more than is kept in memory: of its times, one in %1 is here.")
                                                       .arg(shown->fieldStride));
}

QString ContactMaps::readingText(const RunRecord& shown, std::size_t index) const
{
    const double time = shown.snapshots[index].time;
    QStringList parts{timeText(time)};
    const MinMaxPyramid* separation = shown.pyramid("minimum_spacing");
    if (const auto at = separation ? separation->valueAt(time) : std::nullopt) parts << tr("separation %1").arg(readout(*at, "nm", 3).replace(QLatin1Char('-'), QChar(0x2212)));
    parts << tr("%1 of %2").arg(index + 1).arg(shown.snapshots.size());
    if (shown.fieldStride > 1) parts << tr("one in %1 kept").arg(shown.fieldStride);
    return parts.join(QStringLiteral("   ·   "));
}

QString ContactMaps::whyEmpty() const
{
    const RunRecord* shown = run();
    if (!shown) return tr("There are no maps yet: run the case.");
    if (!shown->finished()) return tr("The first maps come soon.");
    if (shown->fields.empty()) return tr("Run %1 has no maps: its contact law knows forces, not pressures on a surface.").arg(number_);
    return tr("Run %1 recorded no maps: its number of field snapshots is 0, or it was stopped before the first.").arg(number_);
}

} // namespace touchdown
