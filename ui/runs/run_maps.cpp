// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/simulation/static_state/film_setup.h"
#include "ui/maps/field_map.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

bool sameRectangle(const CellGrid& grid, const SliderCase& slider)
{
    const double close = 1e-6 * slider.length;
    return std::abs(grid.x.front()) < close && std::abs(grid.y.front()) < close &&
           std::abs(grid.x.back() - slider.length) < close && std::abs(grid.y.back() - slider.width) < close;
}

/// The field shown first: the air pressure, or the contact pressure without air.
QString firstWanted(const std::vector<RecordedFields>& sets)
{
    for (const char* name : {"air_pressure", "contact_pressure"})
        for (const RecordedFields& set : sets)
            for (const Quantity& quantity : set.quantities)
                if (quantity.name == name) return QString::fromStdString(quantity.longName);
    return {};
}

} // namespace

RunMaps::RunMaps(RunsModel& runs, QWidget* parent)
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
        if (tab >= 0) showField(static_cast<std::size_t>(tab));
    });
    connect(sameScale_, &QCheckBox::toggled, this, &RunMaps::showSnapshot);
    connect(time_, &QSlider::valueChanged, this, [this](int at) {
        follows_ = at == time_->maximum();
        showSnapshot();
        if (const FieldHistory* shown = history()) emit timeChosen(shown->snapshots[static_cast<std::size_t>(at)].time);
    });
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        if (number == number_) showRun(-1);
    });
    refresh();
}

void RunMaps::buildRows()
{
    tabs_->setAccessibleName(tr("Field"));
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    sameScale_->setChecked(true);
    sameScale_->setToolTip(plainTip(
        tr("On: colours and sections have one range for the whole run, without a short peak such as that of a landing. "
           "Off: they span the values at this time.")));
    time_->setAccessibleName(tr("Time of the maps"));
    time_->setToolTip(tr("Select the time of the recorded fields (arrow keys, Home, End)"));
    reading_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    emptyText_->setAlignment(Qt::AlignCenter);
    emptyText_->setWordWrap(true);
    emptyText_->setAutoFillBackground(true);
    emptyText_->setBackgroundRole(QPalette::Base); // as the maps shown later
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

void RunMaps::showRun(int number)
{
    if (number == number_) return;
    number_ = number;
    follows_ = true;
    refresh();
}

void RunMaps::dataArrived(int number)
{
    if (number == number_) refresh();
}

void RunMaps::showTime(double time)
{
    const FieldHistory* shown = history();
    if (!shown || stale_) return;
    const QSignalBlocker quiet(time_);
    time_->setValue(static_cast<int>(shown->nearest(time)));
    follows_ = time_->value() == time_->maximum();
    showSnapshot();
}

void RunMaps::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (stale_) refresh();
}

/// History of the shown set; none while it has no snapshot.
const RunRecord* RunMaps::run() const { return runs_.find(number_); }

const FieldHistory* RunMaps::history() const
{
    const RunRecord* shown = run();
    if (!shown || set_ >= shown->fields.size() || shown->fields[set_].snapshots.empty()) return nullptr;
    return &shown->fields[set_];
}

void RunMaps::refresh()
{
    stale_ = !isVisible();
    if (stale_) return;
    const RunRecord* shown = run();
    const bool any =
        shown && std::ranges::any_of(shown->fields, [](const FieldHistory& set) { return !set.snapshots.empty(); });
    if (any && taken_ != number_) takeFields(*shown);
    if (any) takeTimes();
    pages_->setCurrentWidget(any ? static_cast<QWidget*>(view_) : emptyText_);
    emptyText_->setText(any ? QString() : whyEmpty());
    for (QWidget* part : {static_cast<QWidget*>(tabs_), static_cast<QWidget*>(name_), static_cast<QWidget*>(sameScale_),
                          view_->controls(), foot_})
        part->setVisible(any);
    showSnapshot();
}

/// The slider has one place for each snapshot of the set.
void RunMaps::takeTimes()
{
    const FieldHistory* shown = history();
    const QSignalBlocker quiet(time_);
    const int last = shown ? static_cast<int>(shown->snapshots.size()) - 1 : 0;
    const int before = std::min(time_->value(), last);
    time_->setRange(0, last);
    time_->setPageStep(std::max(1, last / 10));
    time_->setValue(follows_ && shown ? latestOf(*shown) : before);
}

/// The last one; of a pad that was moved in and out the one nearest to the disk, as at the end both are apart again.
int RunMaps::latestOf(const FieldHistory& shown) const
{
    const MinMaxPyramid* separation = run()->pyramid("minimum_spacing");
    if (!run()->finished() || run()->value.model != ModelKind::Contact || !separation)
        return static_cast<int>(shown.snapshots.size()) - 1;
    const auto nearest = std::ranges::min_element(shown.snapshots, {}, [&](const FieldSnapshot& snapshot) {
        return separation->valueAt(snapshot.time).value_or(std::numeric_limits<double>::infinity());
    });
    return static_cast<int>(nearest - shown.snapshots.begin());
}

void RunMaps::takeFields(const RunRecord& run)
{
    taken_ = number_;
    const auto current = static_cast<std::size_t>(tabs_->currentIndex()); // -1 before there is one
    const QString chosen = current < fields_.size() ? fields_[current].name : QString();
    std::vector<RecordedFields> sets;
    for (const FieldHistory& history : run.fields) sets.push_back(history.fields);
    fields_ = runFields(sets);
    gap_.reset();
    if (run.value.model == ModelKind::Film) gap_.emplace(run.value);
    std::vector<MapKind> kinds;
    for (const RunField& field : fields_) kinds.push_back(field.kind);
    const auto called = [&](auto&& name, const QString& wanted) {
        return std::ranges::find(fields_, wanted, name) - fields_.begin();
    };
    auto first = called(&RunField::name, chosen);
    if (chosen.isEmpty() || first == std::ssize(fields_)) first = called(&RunField::longName, firstWanted(sets));
    {
        const QSignalBlocker quiet(tabs_);
        while (tabs_->count() > 0) tabs_->removeTab(0);
        for (const RunField& field : fields_)
            tabs_->setTabToolTip(tabs_->addTab(onButton(field.name)), plainTip(field.kind.title));
        tabs_->setCurrentIndex(first == std::ssize(fields_) ? 0 : static_cast<int>(first));
    }
    view_->setKinds(std::move(kinds));
    set_ = fields_[static_cast<std::size_t>(tabs_->currentIndex())].set;
    view_->setField(tabs_->currentIndex());
    takeArea();
}

/// The slider or the patch of it on which the set lies.
void RunMaps::takeArea()
{
    const RunRecord& shown = *run();
    const CellGrid& grid = shown.fields[set_].fields.grid;
    const bool isSlider = sameRectangle(grid, shown.value.slider);
    view_->map()->setRails(isSlider ? shown.value.surface.rails : std::vector<Rail>());
    if (isSlider)
        view_->map()->setSlider(shown.value.slider.length, shown.value.slider.width);
    else
        view_->map()->setPiece(
            {grid.x.front(), grid.y.front(), grid.x.back() - grid.x.front(), grid.y.back() - grid.y.front()});
    view_->map()->setSkew(shown.value.disk.skew);
    if (!view_->pinned() || !view_->sectionPoint() || !view_->map()->onSlider(*view_->sectionPoint()))
        view_->setSectionPoint({grid.centreX(grid.nx() / 2), grid.centreY(grid.ny() / 2)}, false);
}

/// Another field; of another set at the time shown now.
void RunMaps::showField(std::size_t index)
{
    const FieldHistory* before = history();
    const double time = before ? before->snapshots[static_cast<std::size_t>(time_->value())].time : 0.0;
    const bool sameSet = fields_[index].set == set_;
    set_ = fields_[index].set;
    view_->setField(static_cast<int>(index));
    if (sameSet) return;
    takeArea();
    takeTimes();
    if (const FieldHistory* now = history(); now && !follows_) {
        const QSignalBlocker quiet(time_);
        time_->setValue(static_cast<int>(now->nearest(time)));
    }
    showSnapshot();
    view_->fit();
}

void RunMaps::showSnapshot()
{
    const RunRecord* shown = run();
    if (!shown || !isVisible() || fields_.empty()) return;
    name_->setText(runs_.count() > 1 ? tr("Run %1").arg(number_) : QString());
    const FieldHistory* history = this->history();
    if (!history) {
        view_->setFields({}, {});
        reading_->clear();
        return;
    }
    const auto index =
        static_cast<std::size_t>(std::clamp(time_->value(), 0, static_cast<int>(history->snapshots.size()) - 1));
    const double ambient = airOf(shown->value.air).pressure;
    std::vector<std::vector<double>> values(fields_.size());
    std::vector<PlotRange> ranges(fields_.size());
    std::vector<FieldAtPoints> points(fields_.size());
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        if (fields_[i].set != set_) continue;
        const double zero = fields_[i].aboveAmbient ? ambient : 0.0;
        const std::span<const double> recorded = history->values(index, fields_[i].field);
        values[i].assign(recorded.begin(), recorded.end());
        for (double& value : values[i]) value -= zero;
        if (set_ == 0 && history->fields.quantities[fields_[i].field].name == "gap")
            points[i] = gapAt(*shown, history->snapshots[index].time);
        const PlotRange range = history->usualRange(fields_[i].field);
        ranges[i] = {range.low - zero, range.high - zero};
    }
    view_->setFields(history->fields.grid, std::move(values),
                     sameScale_->isChecked() ? std::move(ranges) : std::vector<PlotRange>(), std::move(points));
    reading_->setText(readingText(*shown, *history, index));
    reading_->setToolTip(
        plainTip(history->stride == 1
                     ? QString()
                     : tr("The run recorded more snapshots than are kept. One in %1 is shown.").arg(history->stride)));
}

namespace {

/// As the samples have it; before the first and after the last sample, which may be a part of a step away, that sample.
std::optional<double> recorded(const RunRecord& run, std::string_view quantity, double time)
{
    const MinMaxPyramid* samples = run.pyramid(quantity);
    if (!samples || samples->empty()) return std::nullopt;
    return samples->valueAt(std::clamp(time, samples->firstTime(), samples->lastTime()));
}

} // namespace

/// Nothing where the run is no film, or has not recorded it.
FieldAtPoints RunMaps::gapAt(const RunRecord& run, double time) const
{
    const auto least = recorded(run, "minimum_spacing", time), pitch = recorded(run, "pitch", time),
               roll = recorded(run, "roll", time);
    return gap_ && least && pitch && roll ? gap_->at(*least, *pitch, *roll) : FieldAtPoints();
}

QString RunMaps::readingText(const RunRecord& shown, const FieldHistory& history, std::size_t index) const
{
    const double time = history.snapshots[index].time;
    QStringList parts{timeText(time)};
    if (const auto at = recorded(shown, "minimum_spacing", time)) {
        const QString text = readout(*at, "nm", 3);
        parts << (shown.value.model == ModelKind::Contact ? tr("separation %1") : tr("minimum spacing %1")).arg(text);
    }
    parts << tr("%1 of %2").arg(index + 1).arg(history.snapshots.size());
    if (history.stride > 1) parts << tr("one in %1 kept").arg(history.stride);
    return parts.join(QStringLiteral("   ·   "));
}

QString RunMaps::whyEmpty() const
{
    const RunRecord* shown = run();
    if (!shown) return tr("There are no maps yet: run the case.");
    if (!shown->finished()) return tr("The first maps are not ready yet.");
    if (shown->fields.empty() && shown->value.model == ModelKind::Contact)
        return tr("Run %1 has no maps: its contact law has forces only, no pressures on a surface.").arg(number_);
    return tr("Run %1 recorded no maps: its number of field snapshots is 0, or it was stopped before the first.")
        .arg(number_);
}

} // namespace touchdown
