// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live_plots.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QVBoxLayout>

#include "core/simulation/units.h"
#include "ui/plot_menu.h"
#include "ui/quantity_format.h"

namespace touchdown {

namespace {

constexpr std::size_t mostMarks = 2000; // ticks closer than pixels say nothing

QString curveId(const RunRecord& run, const std::string& quantity)
{
    return QStringLiteral("run %1/%2").arg(run.number).arg(QString::fromStdString(quantity));
}

/// `run` minus `baseline` at the samples of `run`, where both are known.
std::unique_ptr<MinMaxPyramid> difference(const MinMaxPyramid& run, const MinMaxPyramid& baseline)
{
    std::vector<double> times, values;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const std::optional<double> other = baseline.valueAt(run.time(k));
        if (!other) continue;
        times.push_back(run.time(k));
        values.push_back(run.value(k) - *other);
    }
    auto made = std::make_unique<MinMaxPyramid>(RunRecord::capacity);
    made->append(times, values);
    return made;
}

} // namespace

struct LivePlots::Spec {
    struct Curve {
        const char* quantity;
        const char* name; // in the legend of a plot with several
        bool visible = true;
    };
    const char* name;
    const char* title;
    const char* unit; // displayed
    std::vector<Curve> curves;
};

const std::vector<LivePlots::Spec>& LivePlots::specs()
{
    static const std::vector<Spec> list{
        {"spacing", QT_TR_NOOP("Minimum spacing"), "nm", {{"minimum_spacing", QT_TR_NOOP("Minimum spacing")}}},
        {"pitch", QT_TR_NOOP("Pitch"), "urad", {{"pitch", QT_TR_NOOP("Pitch")}}},
        {"roll", QT_TR_NOOP("Roll"), "urad", {{"roll", QT_TR_NOOP("Roll")}}},
        {"energy",
         QT_TR_NOOP("Energy"),
         "pJ",
         {{"kinetic_energy", QT_TR_NOOP("Kinetic")},
          {"air_spring_energy", QT_TR_NOOP("Air springs")},
          {"suspension_energy", QT_TR_NOOP("Suspension")},
          {"contact_energy", QT_TR_NOOP("Contact")},
          {"energy", QT_TR_NOOP("Total without contact")}}},
        {"forces",
         QT_TR_NOOP("Contact forces"),
         "mN",
         {{"contact_force", QT_TR_NOOP("Contact")},
          {"adhesion_force", QT_TR_NOOP("Adhesion")},
          {"net_contact_force", QT_TR_NOOP("Net")},
          {"friction_force", QT_TR_NOOP("Friction"), false},
          {"air_bearing_force", QT_TR_NOOP("Air bearing"), false}}},
    };
    return list;
}

LivePlots::LivePlots(RunsModel& runs, QWidget* parent) : QWidget(parent), runs_(runs), group_(new PlotGroup(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (const Spec& spec : specs()) {
        auto* plot = new PlotWidget(this);
        plot->setTitle(tr(spec.title));
        plot->setAccessibleName(tr("Plot of %1 over time").arg(tr(spec.title)));
        plot->setXLabel({tr("Time"), QStringLiteral("ms"), unitFactor("ms"), AxisScale::Linear});
        plot->setYLabel({{}, unitText(spec.unit), unitFactor(spec.unit), AxisScale::Linear});
        group_->add(plot);
        installPlotMenu(plot, group_);
        layout->addWidget(plot, 1);
        entries_.push_back({QString::fromLatin1(spec.name), tr(spec.title), plot});
    }

    connect(&runs_, &RunsModel::added, this, &LivePlots::addRun);
    connect(&runs_, &RunsModel::aboutToRemove, this, &LivePlots::removeRun);
    connect(&runs_, &RunsModel::shownChanged, this, &LivePlots::rebuild);
    connect(&runs_, &RunsModel::baselineChanged, this, [this] {
        differences_.clear();
        const int baseline = runs_.baseline();
        for (const Entry& entry : entries_)
            entry.plot->setTitle(baseline < 0 ? entry.title : tr("%1 minus run %2").arg(entry.title).arg(baseline));
        rebuild();
        group_->fit();
    });
    updateVisibility();
}

PlotWidget* LivePlots::plot(const QString& name) const
{
    const auto found = std::ranges::find(entries_, name, &Entry::name);
    return found == entries_.end() ? nullptr : found->plot;
}

void LivePlots::setWanted(const QString& name, bool wanted)
{
    const auto found = std::ranges::find(entries_, name, &Entry::name);
    if (found == entries_.end()) return;
    found->wanted = wanted;
    updateVisibility();
}

void LivePlots::dataArrived(int number)
{
    const RunRecord* run = runs_.find(number);
    if (run && run == newestShown() && run->events.size() != marksShown_) updateMarks();
    group_->dataChanged();
}

void LivePlots::runFinished(int number)
{
    if (runs_.baseline() >= 0 && runs_.baseline() != number) rebuild();
    updateMarks();
    group_->dataChanged();
}

void LivePlots::addRun(int)
{
    rebuild();
    group_->forgetHistory();
}

void LivePlots::removeRun(int number)
{
    const QString prefix = QStringLiteral("run %1/").arg(number);
    for (const Entry& entry : entries_) {
        QStringList gone;
        for (const PlotCurve& curve : entry.plot->curves())
            if (curve.id.startsWith(prefix)) gone << curve.id;
        for (const QString& id : gone) entry.plot->removeCurve(id);
    }
    std::erase_if(differences_, [&prefix](const auto& item) { return item.first.startsWith(prefix); });
    updateMarks();
    emit curvesChanged();
    group_->dataChanged();
}

void LivePlots::rebuild()
{
    noteHiddenCurves();
    for (int row = 0; row < runs_.count(); ++row) addCurves(runs_.record(row));
    drawn_.clear();
    for (int row = 0; row < runs_.count(); ++row)
        if (runs_.record(row).shown) drawn_.insert(runs_.record(row).number);
    updateMarks();
    updateVisibility();
    emit curvesChanged();
    group_->dataChanged();
}

void LivePlots::addCurves(const RunRecord& run)
{
    const bool several = runs_.count() > 1;
    for (std::size_t s = 0; s < specs().size(); ++s) {
        const Spec& spec = specs()[s];
        PlotWidget* plot = entries_[s].plot;
        const bool single = spec.curves.size() == 1;
        for (std::size_t i = 0; i < spec.curves.size(); ++i) {
            const Spec::Curve& wanted = spec.curves[i];
            const MinMaxPyramid* samples = dataFor(run, wanted.quantity);
            const QString id = curveId(run, wanted.quantity);
            if (!samples) {
                plot->removeCurve(id);
                continue;
            }
            PlotCurve curve;
            curve.id = id;
            curve.name = several ? (single ? tr("Run %1").arg(run.number) : tr("%1, run %2").arg(tr(wanted.name)).arg(run.number))
                                 : tr(wanted.name);
            curve.style = RunsModel::style(run);
            if (!single) curve.style.colour = static_cast<int>(i) == 4 ? 6 : static_cast<int>(i);
            curve.data = samples;
            curve.visible = run.shown && wanted_.try_emplace(wanted.quantity, wanted.visible).first->second;
            plot->addCurve(curve);
        }
    }
}

/// What the user chose in the plots' menus holds for the runs that come.
void LivePlots::noteHiddenCurves()
{
    for (const int number : drawn_) {
        const QString prefix = QStringLiteral("run %1/").arg(number);
        for (const Entry& entry : entries_)
            for (const PlotCurve& curve : entry.plot->curves())
                if (curve.id.startsWith(prefix)) wanted_[curve.id.mid(prefix.size()).toStdString()] = curve.visible;
    }
}

/// The pyramid to draw: the run's own, or its difference to the baseline; nullptr for nothing.
const MinMaxPyramid* LivePlots::dataFor(const RunRecord& run, const std::string& quantity)
{
    const MinMaxPyramid* own = run.pyramid(quantity);
    const RunRecord* baseline = runs_.find(runs_.baseline());
    if (!own || !baseline) return own;
    if (baseline == &run) return nullptr;
    const MinMaxPyramid* other = baseline->pyramid(quantity);
    if (!other || !run.finished()) return nullptr;
    std::unique_ptr<MinMaxPyramid>& made = differences_[curveId(run, quantity)];
    if (!made) made = difference(*own, *other);
    return made.get();
}

void LivePlots::updateMarks()
{
    const RunRecord* run = newestShown();
    std::vector<EventMark> marks;
    std::vector<ReferenceLine> spacing;
    std::vector<ReferenceLine> pitch;
    marksShown_ = 0;
    if (run) {
        marksShown_ = run->events.size();
        for (std::size_t i = 0; i < std::min(mostMarks, run->events.size()); ++i)
            marks.push_back({run->events[i].time, QString::fromStdString(run->events[i].name)});
        if (runs_.baseline() < 0) {
            const Case& c = run->value;
            const auto line = [](const char* symbol, double value) {
                return ReferenceLine{value, QStringLiteral("%1 = %2").arg(QString::fromUtf8(symbol),
                                                                         QString::fromStdString(formatQuantity(value, "nm")))};
            };
            spacing.push_back(line("d₁", c.springs.cutoff));
            if (c.contact == ContactKind::OnoYamane) {
                spacing.push_back(line("dₛ", c.onoYamane.touchDown));
                spacing.push_back(line("dₑ", c.onoYamane.takeOff));
            }
            pitch.push_back({c.springs.pitch, tr("static")});
        }
    }
    for (const Entry& entry : entries_) entry.plot->setEventMarks(marks);
    plot(QStringLiteral("spacing"))->setReferenceLines(spacing);
    plot(QStringLiteral("pitch"))->setReferenceLines(pitch);
}

void LivePlots::updateVisibility()
{
    PlotWidget* lowest = nullptr;
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        const Entry& entry = entries_[s];
        // Before there is any run, the plots that every model has stand ready.
        bool recorded = runs_.count() == 0 && entry.name != QLatin1String("roll");
        for (const PlotCurve& curve : entry.plot->curves()) recorded = recorded || curve.data;
        entry.plot->setVisible(recorded && entry.wanted);
        if (recorded && entry.wanted) lowest = entry.plot;
    }
    for (const Entry& entry : entries_) entry.plot->setXNumbersVisible(entry.plot == lowest);
}

const RunRecord* LivePlots::newestShown() const
{
    for (int row = runs_.count() - 1; row >= 0; --row)
        if (runs_.record(row).shown) return &runs_.record(row);
    return nullptr;
}

} // namespace touchdown
