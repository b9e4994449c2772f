// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_plots.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QRegularExpression>

#include "core/formats/units.h"
#include "core/simulation/run.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

/// Key of a choice of the user in the menu of a plot.
std::string curveKey(const QString& plot, const QString& quantity)
{
    return (plot + QLatin1Char('/') + quantity).toStdString();
}

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
    auto made = std::make_unique<MinMaxPyramid>(run.times());
    made->append(times, values);
    return made;
}

} // namespace

struct LivePlots::Spec {
    struct Curve {
        const char* quantity;
        const char* name; // in the legend of a plot with several
        bool visible = true;
        int colour = -1; // -1: as it comes in the list
        int dash = 0;    // added to the dash of the run
    };
    const char* name;
    const char* title;
    const char* unit; // displayed
    std::vector<Curve> curves;
    const char* against = nullptr; // a quantity instead of the time
    bool atFirst = true;           // shown for a flying slider until the user changes it
    AxisScale scale = AxisScale::Linear;
};

const std::vector<LivePlots::Spec>& LivePlots::specs()
{
    static const std::vector<Spec> list{
        {"force_separation",
         QT_TR_NOOP("Force against separation"),
         "mN",
         {{"contact_force", QT_TR_NOOP("Contact")},
          {"adhesion_force", QT_TR_NOOP("Adhesion")},
          {"net_contact_force", QT_TR_NOOP("Net")},
          {"fitted_contact_force", QT_TR_NOOP("Fitted"), true, 6, 1},
          {"fitted_adhesion_force", QT_TR_NOOP("Fitted"), true, 6, 1}},
         "minimum_spacing",
         false},
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
          {"film_energy", QT_TR_NOOP("Air film"), true, 1}, // no case has both kinds of air
          {"energy", QT_TR_NOOP("Total without contact"), true, 6}}},
        {"forces",
         QT_TR_NOOP("Contact forces"),
         "mN",
         {{"contact_force", QT_TR_NOOP("Contact")},
          {"adhesion_force", QT_TR_NOOP("Adhesion")},
          {"net_contact_force", QT_TR_NOOP("Net")},
          {"friction_force", QT_TR_NOOP("Friction"), false}}},
        {"air_bearing",
         QT_TR_NOOP("Air bearing force"),
         "mN",
         {{"air_bearing_force", QT_TR_NOOP("Air bearing")}},
         nullptr,
         false},
        {"velocity",
         QT_TR_NOOP("Vertical velocity"),
         "mm/s",
         {{"vertical_velocity", QT_TR_NOOP("Vertical velocity")}},
         nullptr,
         false},
        {"angular_velocity",
         QT_TR_NOOP("Angular velocities"),
         "rad/s",
         {{"pitch_velocity", QT_TR_NOOP("Pitch")}, {"roll_velocity", QT_TR_NOOP("Roll")}},
         nullptr,
         false},
        {"area", QT_TR_NOOP("Contact area"), "um^2", {{"contact_area", QT_TR_NOOP("Contact area")}}, nullptr, false},
        {"pressure",
         QT_TR_NOOP("Peak contact pressure"),
         "MPa",
         {{"peak_contact_pressure", QT_TR_NOOP("Peak contact pressure")}},
         nullptr,
         false},
        {"step",
         QT_TR_NOOP("Time step"),
         "ns",
         {{"time_step", QT_TR_NOOP("Time step")}},
         nullptr,
         false,
         AxisScale::Logarithmic},
    };
    return list;
}

LivePlots::LivePlots(RunsModel& runs, QWidget* parent)
    : QWidget(parent), runs_(runs), group_(new PlotGroup(this)), layout_(new QVBoxLayout(this))
{
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(0);
    for (const Spec& spec : specs()) {
        auto* plot = new PlotWidget(this);
        plot->setTitle(tr(spec.title));
        if (spec.against) {
            plot->setXLabel({tr("Separation"), QStringLiteral("nm"), unitFactor("nm"), AxisScale::Linear});
        } else {
            plot->setAccessibleName(tr("Plot of %1 over time").arg(tr(spec.title)));
            plot->setXLabel({tr("Time"), QStringLiteral("ms"), unitFactor("ms"), AxisScale::Linear});
        }
        plot->setYLabel({{}, unitText(spec.unit), unitFactor(spec.unit), spec.scale});
        group_->add(plot);
        connect(plot, &PlotWidget::legendHovered, this, &LivePlots::raise);
        layout_->addWidget(plot, spec.against ? 3 : 1);
        auto* wanted = new QAction(tr(spec.title), this);
        wanted->setCheckable(true);
        connect(wanted, &QAction::triggered, this, [this, name = QString::fromLatin1(spec.name)](bool on) {
            chosen_[{model_, name}] = on;
        });
        connect(wanted, &QAction::toggled, this, &LivePlots::updateVisibility);
        entries_.push_back({QString::fromLatin1(spec.name), tr(spec.title), plot, wanted});
    }
    setCase({});

    connect(&runs_, &RunsModel::added, this, [this] {
        rebuild();
        group_->followNewest();
        group_->forgetHistory();
    });
    connect(&runs_, &RunsModel::aboutToRemove, this, &LivePlots::removeRun);
    connect(&runs_, &RunsModel::shownChanged, this, &LivePlots::rebuild);
    connect(&runs_, &RunsModel::speakerChanged, this, &LivePlots::rebuild);
    connect(&runs_, &RunsModel::namesChanged, this, &LivePlots::rebuild);
    connect(&runs_, &RunsModel::baselineChanged, this, [this] {
        noteHiddenCurves();
        for (const Entry& entry : entries_) entry.plot->clearCurves();
        differences_.clear();
        const int baseline = runs_.baseline();
        for (std::size_t s = 0; s < specs().size(); ++s) {
            if (specs()[s].against) continue;
            const QString& title = entries_[s].title;
            entries_[s].plot->setTitle(baseline < 0 ? title : tr("%1 minus run %2").arg(title).arg(baseline));
        }
        rebuild();
        group_->fit();
        group_->followNewest();
    });
}

void LivePlots::raise(const QString& curve)
{
    static const QRegularExpression id(QStringLiteral("^run (\\d+)/"));
    const QRegularExpressionMatch found = id.match(curve);
    runs_.raise(found.hasMatch() ? found.captured(1).toInt() : -1);
}

const LivePlots::Entry& LivePlots::entry(const QString& name) const
{
    const auto found = std::ranges::find(entries_, name, &Entry::name);
    Q_ASSERT(found != entries_.end());
    return *found;
}

void LivePlots::setCase(const Case& c)
{
    model_ = c.model;
    ready_.clear();
    for (const Quantity& quantity : recordedQuantities(c)) ready_.push_back(quantity.name);
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        // A contact run shows forces against the separation, a flying slider shows them over time.
        bool atFirst = model_ == ModelKind::Contact ? entries_[s].name != QLatin1String("forces") : specs()[s].atFirst;
        if (entries_[s].name == QLatin1String("roll") && c.degreesOfFreedom == 2) atFirst = false; // it is held
        const auto chosen = chosen_.find({model_, entries_[s].name});
        entries_[s].wanted->setChecked(chosen != chosen_.end() ? chosen->second : atFirst);
    }
    updateVisibility();
}

void LivePlots::dataArrived(int number)
{
    const RunRecord* run = runs_.find(number);
    if (run && run == runs_.newestShown() && run->events.size() != marksShown_) updateMarks();
    group_->dataChanged();
}

void LivePlots::runFinished(int number)
{
    if ((runs_.baseline() >= 0 && runs_.baseline() != number) || number != leader_) rebuild();
    updateMarks();
    group_->dataChanged();
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
    const RunRecord* newest = runs_.newestShown();
    leader_ = newest ? newest->number : -1;
    speaker_ = runs_.speaker();
    drawn_.clear();
    for (int row = 0; row < runs_.count(); ++row)
        if (runs_.record(row).shown) drawn_.insert(runs_.record(row).number);
    for (std::size_t s = 0; s < specs().size(); ++s) entries_[s].plot->setCurves(curvesOf(s));
    std::erase_if(differences_, [this](const auto& item) {
        return std::ranges::none_of(
            drawn_, [&item](int number) { return item.first.startsWith(QStringLiteral("run %1/").arg(number)); });
    });
    updateMarks();
    updateVisibility();
    emit curvesChanged();
    group_->dataChanged();
}

std::vector<PlotCurve> LivePlots::curvesOf(std::size_t s)
{
    const Spec& spec = specs()[s];
    std::vector<PlotCurve> curves;
    for (int row = 0; row < runs_.count(); ++row) {
        const RunRecord& run = runs_.record(row);
        for (std::size_t i = 0; i < spec.curves.size(); ++i) {
            // A curve of force against separation has no difference to a baseline.
            const std::string quantity = spec.curves[i].quantity;
            const MinMaxPyramid* up = spec.against ? run.pyramid(quantity) : dataFor(run, quantity);
            const MinMaxPyramid* across = spec.against ? run.pyramid(spec.against) : nullptr;
            if (!up || (spec.against && !across)) continue;
            curves.push_back(curveOf(run, s, i));
            curves.back().data = up;
            curves.back().xData = across;
        }
    }
    return curves;
}

PlotCurve LivePlots::curveOf(const RunRecord& run, std::size_t spec, std::size_t index) const
{
    const Spec::Curve& wanted = specs()[spec].curves[index];
    const bool single = specs()[spec].curves.size() == 1;
    PlotCurve curve;
    curve.id = curveId(run, wanted.quantity);
    // The total energy of a film includes that of the contact, the total energy of the springs does not.
    const bool whole = run.value.model == ModelKind::Film && std::string_view(wanted.quantity) == "energy";
    const QString name = whole ? tr("Total") : tr(wanted.name);
    curve.name = name;
    if (runs_.count() > 1) curve.name = single ? run.label : tr("%1, %2").arg(name, run.label);
    if (!single) curve.legend = name;
    curve.pale = run.number != speaker_;
    curve.leads = run.number == leader_;
    curve.still = run.finished();
    curve.inLegend = single || !curve.pale;
    if (!run.finished()) curve.end = run.value.run.duration;
    curve.style = RunsModel::style(run);
    curve.printDash = run.number - 1;
    if (!single) curve.style = {wanted.colour < 0 ? static_cast<int>(index) : wanted.colour, wanted.dash};
    const auto chosen =
        wanted_.find(curveKey(QString::fromLatin1(specs()[spec].name), QString::fromLatin1(wanted.quantity)));
    // Without adhesion the net force is the contact force.
    const bool same = std::string_view(wanted.quantity) == "net_contact_force" && !run.pyramid("adhesion_force");
    curve.visible = run.shown && (chosen == wanted_.end() ? wanted.visible && !same : chosen->second);
    curve.arrows = wanted.dash == 0;
    return curve;
}

/// Choices in the plots' menus hold for later runs.
void LivePlots::noteHiddenCurves()
{
    for (const int number : drawn_) {
        const QString prefix = QStringLiteral("run %1/").arg(number);
        for (const Entry& entry : entries_)
            for (const PlotCurve& curve : entry.plot->curves())
                if (curve.id.startsWith(prefix))
                    wanted_[curveKey(entry.name, curve.id.mid(prefix.size()))] = curve.visible;
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
    if (!other || !run.finished() || !run.shown) return nullptr;
    std::unique_ptr<MinMaxPyramid>& made = differences_[curveId(run, quantity)];
    if (!made) made = difference(*own, *other);
    return made.get();
}

void LivePlots::updateVisibility()
{
    const bool anyShown = runs_.newestShown() != nullptr;
    PlotWidget* lowest = nullptr;
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        const Entry& entry = entries_[s];
        bool recorded = false;
        // Before the first run, the plots of the quantities that the case will record are shown.
        for (const Spec::Curve& curve : specs()[s].curves)
            recorded = recorded || (!anyShown && std::ranges::find(ready_, curve.quantity) != ready_.end());
        for (int row = 0; row < runs_.count(); ++row)
            for (const Spec::Curve& curve : specs()[s].curves)
                recorded = recorded || (runs_.record(row).shown && runs_.record(row).pyramid(curve.quantity));
        const bool visible = recorded && entry.wanted->isChecked();
        entry.plot->setVisible(visible);
        if (visible && !specs()[s].against) lowest = entry.plot;
    }
    for (std::size_t s = 0; s < entries_.size(); ++s)
        entries_[s].plot->setXNumbersVisible(entries_[s].plot == lowest || specs()[s].against);
}

} // namespace touchdown
