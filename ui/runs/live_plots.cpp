// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_plots.h"

#include <algorithm>
#include <utility>

#include <QRegularExpression>

#include "core/formats/units.h"
#include "core/simulation/run.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/drop_hint.h"
#include "ui/runs/live_spectrogram.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/foreign_text.h"
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

} // namespace

LivePlots::LivePlots(RunsModel& runs, QWidget* parent)
    : QWidget(parent),
      runs_(runs),
      group_(new PlotGroup(this)),
      columns_(new QHBoxLayout(this)),
      overTime_(new QVBoxLayout),
      portraits_(new QVBoxLayout),
      specs_(standardPlots()),
      differences_(new RunDifferences(runs_, this)),
      hint_(new DropHint(this))
{
    columns_->setContentsMargins(0, 0, 0, 0);
    columns_->setSpacing(0);
    columns_->addLayout(overTime_);
    columns_->addLayout(portraits_);
    for (QVBoxLayout* column : {overTime_, portraits_}) column->setSpacing(0);
    for (std::size_t s = 0; s < specs_.size(); ++s) makePlot(s);
    setAcceptDrops(true);
    spectrogram_ = new LiveSpectrogram(runs_, *plot(QStringLiteral("spectrogram")), this);
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
        for (std::size_t s = 0; s < specs_.size(); ++s) // a curve against another quantity stays as it is
            if (!specs_[s].across) entries_[s].plot->clearCurves();
        differences_->clear();
        rebuild();
        group_->fit();
        group_->followNewest();
    });
    connect(differences_, &RunDifferences::made, this, [this] {
        rebuild();
        emit differencesMade();
    });
}

/// The plot, in its column, and the entry of the menu that shows it.
void LivePlots::makePlot(std::size_t s)
{
    const PlotSpec& spec = specs_[s];
    auto* plot = new PlotWidget(this);
    auto* wanted = new QAction(onButton(spec.title), this);
    entries_.push_back({spec.name, spec.title, plot, wanted});
    labelAxes(s);
    placePlot(s);
    connect(plot, &PlotWidget::legendHovered, this, &LivePlots::raise);
    wanted->setCheckable(true);
    connect(wanted, &QAction::triggered, this, [this, name = spec.name](bool on) { chosen_[{model_, name}] = on; });
    connect(wanted, &QAction::toggled, this, [this] {
        updateVisibility();
        if (runs_.baseline() >= 0) rebuild(); // its differences
    });
    addMenus(spec.name);
}

void LivePlots::labelPlots()
{
    nameApart(specs_);
    for (std::size_t s = 0; s < specs_.size(); ++s) labelAxes(s);
}

/// What the plot and its axes are called.
void LivePlots::labelAxes(std::size_t s)
{
    const PlotSpec& spec = specs_[s];
    PlotWidget* plot = entries_[s].plot;
    entries_[s].title = spec.title;
    entries_[s].wanted->setText(onButton(spec.title));
    updateTitle(s);
    if (spec.across) {
        const Quantity& across = *spec.across;
        plot->setXLabel({QString::fromStdString(across.longName), unitText(across.displayUnit),
                         unitFactor(across.displayUnit), AxisScale::Linear});
    } else {
        plot->setXLabel({tr("Time"), QStringLiteral("ms"), unitFactor("ms"), AxisScale::Linear});
    }
    // Over time the title says what stands up. A spectrogram names itself.
    const QString up = spec.across && spec.curves.size() == 1 ? spec.curves.front().name : QString();
    if (!spec.spectrogram) plot->setYLabel({up, unitText(spec.unit), unitFactor(spec.unit), spec.scale});
}

/// A spectrogram has a title of its own.
void LivePlots::updateTitle(std::size_t s)
{
    const PlotSpec& spec = specs_[s];
    PlotWidget* plot = entries_[s].plot;
    QString title = spec.title;
    // Over a flat disk both are the same.
    if (spec.name == QLatin1String("spacing") && !flat_)
        title = model_ == ModelKind::Springs ? tr("%1 above the disk").arg(title)
                                             : tr("%1 above the mean plane of the disk").arg(title);
    if (runs_.baseline() >= 0 && !spec.across) {
        title = tr("%1 minus run %2").arg(title, QString::number(runs_.baseline()));
        title += missingDifference(s);
    }
    if (!spec.spectrogram && plot->title() != title) plot->setTitle(title);
    plot->setAccessibleName(spec.across ? tr("Plot: %1").arg(title) : tr("Plot of %1 over time").arg(title));
}

/// In the column of its kind. The forces of a pad are its first plot, above those over time.
void LivePlots::placePlot(std::size_t s)
{
    const PlotSpec& spec = specs_[s];
    PlotWidget* plot = entries_[s].plot;
    for (QVBoxLayout* each : {overTime_, portraits_}) each->removeWidget(plot);
    QVBoxLayout* column = spec.across && spec.choosable ? portraits_ : overTime_;
    int above = 0; // plots of that column that stand before it
    for (std::size_t k = 0; k < std::min(s, entries_.size()); ++k)
        above += column->indexOf(entries_[k].plot) >= 0 ? 1 : 0;
    column->insertWidget(above, plot, spec.across ? 3 : spec.spectrogram ? 2 : 1);
    group_->remove(plot);
    plot->setPhasePortrait(spec.across.has_value());
    group_->add(plot);
}

void LivePlots::raise(const QString& curve)
{
    static const QRegularExpression id(QStringLiteral("^run (\\d+)/"));
    const QRegularExpressionMatch found = id.match(curve);
    runs_.raise(found.hasMatch() ? found.captured(1).toInt() : -1);
}

const LivePlots::Entry& LivePlots::entry(const QString& name) const { return entries_[indexOf(name)]; }

const PlotSpec& LivePlots::spec(const QString& name) const { return specs_[indexOf(name)]; }

std::size_t LivePlots::indexOf(const QString& name) const
{
    const auto found = std::ranges::find(entries_, name, &Entry::name);
    Q_ASSERT(found != entries_.end());
    return static_cast<std::size_t>(found - entries_.begin());
}

void LivePlots::setCase(const Case& c)
{
    model_ = c.model;
    ready_ = recordedQuantities(c);
    rollIsHeld_ = c.degreesOfFreedom == 2;
    flat_ = c.diskSurface.kind == DiskSurfaceKind::Flat;
    updateTitle(indexOf(QStringLiteral("spacing")));
    updateWanted();
    updateVisibility();
    emit quantitiesChanged();
}

/// As the user chose for this model, or as it is at first.
void LivePlots::updateWanted()
{
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        // A contact run shows forces against the separation, a flying slider shows them over time.
        bool atFirst = model_ == ModelKind::Contact ? entries_[s].name != QLatin1String("forces") : specs_[s].atFirst;
        if (specs_[s].choosable) atFirst = specs_[s].atFirst;
        if (entries_[s].name == QLatin1String("roll") && rollIsHeld_) atFirst = false;
        // The spacings of the springs are those above the disk.
        if (entries_[s].name == QLatin1String("above_disk") && model_ == ModelKind::Springs) atFirst = false;
        const auto chosen = chosen_.find({model_, entries_[s].name});
        entries_[s].wanted->setChecked(chosen != chosen_.end() ? chosen->second : atFirst);
    }
}

void LivePlots::dataArrived(int number)
{
    const RunRecord* run = runs_.find(number);
    if (run && run == runs_.newestShown() && run->events.size() != marksShown_) updateMarks();
    group_->dataChanged();
    spectrogram_->update();
}

void LivePlots::runFinished(int number)
{
    spectrogram_->update();
    if (runs_.baseline() >= 0 || number != leader_) rebuild();
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
    std::set<RunDifferences::Key> used;
    for (std::size_t s = 0; s < specs_.size(); ++s) {
        entries_[s].plot->setCurves(curvesOf(s, used));
        updateTitle(s);
    }
    differences_->keepOnly(used);
    updateMarks();
    updateVisibility();
    spectrogram_->setQuantity(spec(QStringLiteral("spectrogram")).curves.front().quantity);
    spectrogram_->update();
    emit curvesChanged();
    emit quantitiesChanged();
    group_->dataChanged();
}

/// `used`: receives the differences that are shown.
std::vector<PlotCurve> LivePlots::curvesOf(std::size_t s, std::set<RunDifferences::Key>& used)
{
    const PlotSpec& spec = specs_[s];
    std::vector<PlotCurve> curves;
    if (spec.spectrogram) return curves;
    const bool subtracted = runs_.baseline() >= 0 && !spec.across; // a curve against another quantity has no difference
    if (subtracted && !isShown(s)) return curves;
    for (int row = 0; row < runs_.count(); ++row) {
        const RunRecord& run = runs_.record(row);
        for (std::size_t i = 0; i < spec.curves.size(); ++i) {
            const std::string& quantity = spec.curves[i].quantity;
            const MinMaxPyramid* up = run.pyramid(quantity);
            if (subtracted && !run.shown) continue;
            if (subtracted) {
                up = differences_->of(run, quantity);
                used.insert({run.number, quantity});
            }
            const MinMaxPyramid* across = spec.across ? run.pyramid(spec.across->name) : nullptr;
            if (!up || (spec.across && !across)) continue;
            curves.push_back(curveOf(run, s, i));
            curves.back().data = up;
            curves.back().xData = across;
        }
    }
    return curves;
}

PlotCurve LivePlots::curveOf(const RunRecord& run, std::size_t spec, std::size_t index) const
{
    const PlotSpec::Curve& wanted = specs_[spec].curves[index];
    const bool single = specs_[spec].curves.size() == 1;
    PlotCurve curve;
    curve.id = curveId(run, wanted.quantity);
    // The total energy of a film includes that of the contact, the total energy of the springs does not.
    const bool whole = run.value.model == ModelKind::Film && wanted.quantity == "energy";
    const QString name = whole ? tr("Total") : wanted.name;
    curve.name = name;
    if (runs_.count() > 1) curve.name = single ? run.label : tr("%1, %2").arg(name, run.label);
    if (!single) curve.legend = name;
    if (runs_.count() > 1) curve.run = run.number;
    curve.runName = run.label;
    curve.pale = run.number != speaker_;
    curve.leads = run.number == leader_;
    curve.still = run.finished();
    curve.inLegend = single || !curve.pale;
    if (!run.finished()) curve.end = run.value.run.duration;
    curve.style = RunsModel::style(run);
    if (!single) curve.style = {wanted.colour < 0 ? static_cast<int>(index) : wanted.colour, wanted.dash};
    const auto chosen = wanted_.find(curveKey(specs_[spec].name, QString::fromStdString(wanted.quantity)));
    // Without adhesion the net force is the contact force.
    const bool same = wanted.quantity == "net_contact_force" && !run.pyramid("adhesion_force");
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

/// Why a difference that the plot shows is not there yet, behind the title; empty: all are there.
QString LivePlots::missingDifference(std::size_t s) const
{
    if (!isShown(s)) return {};
    const auto runs = [this](int number) {
        const RunRecord* run = runs_.find(number);
        return run && !run->finished();
    };
    if (runs(runs_.baseline())) return tr(": shown when run %1 ends").arg(runs_.baseline());
    QString remark;
    for (const int number : drawn_)
        if (runs(number)) remark = tr(": run %1 is shown when it ends").arg(number);
    for (const PlotSpec::Curve& curve : specs_[s].curves)
        for (const int number : drawn_) {
            if (differences_->isBegun(number, curve.quantity)) return tr(": being computed");
            if (const QString problem = differences_->problem(number, curve.quantity); !problem.isEmpty())
                remark = tr(": run %1 could not be computed: %2").arg(number).arg(problem);
        }
    return remark;
}

void LivePlots::setStage(const std::optional<QStringList>& names)
{
    stage_ = names;
    // Its runs are there to be compared: the ranges are those of all.
    for (const Entry& entry : entries_) entry.plot->setAllDecide(stage_.has_value());
    updateVisibility();
    if (runs_.baseline() >= 0) rebuild();
}

/// Whether a plot is wanted, and a shown run has its quantities. Before the first run, the plots of the quantities that
/// the case will record are shown.
bool LivePlots::isShown(std::size_t s) const
{
    const auto isRecorded = [this](const std::string& quantity) {
        if (!runs_.newestShown()) return findQuantity(ready_, quantity) >= 0;
        for (int row = 0; row < runs_.count(); ++row)
            if (runs_.record(row).shown && runs_.record(row).pyramid(quantity)) return true;
        return false;
    };
    const PlotSpec& spec = specs_[s];
    const bool wanted = stage_ ? stage_->contains(entries_[s].name) : entries_[s].wanted->isChecked();
    return wanted && (!spec.across || isRecorded(spec.across->name)) &&
           std::ranges::any_of(spec.curves, isRecorded, &PlotSpec::Curve::quantity);
}

void LivePlots::updateVisibility()
{
    PlotWidget* lowest = nullptr;
    bool beside = false;
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        const PlotSpec& spec = specs_[s];
        const bool visible = isShown(s);
        entries_[s].plot->setVisible(visible);
        if (visible && !spec.across) lowest = entries_[s].plot;
        beside = beside || (visible && portraits_->indexOf(entries_[s].plot) >= 0);
    }
    // A layout within another does not notice what is hidden while no page shows it.
    for (QVBoxLayout* column : {overTime_, portraits_}) column->invalidate();
    columns_->invalidate();
    updateGeometry();
    columns_->setStretch(0, lowest ? 1 : 0);
    columns_->setStretch(1, beside ? 1 : 0);
    for (std::size_t s = 0; s < entries_.size(); ++s)
        entries_[s].plot->setXNumbersVisible(entries_[s].plot == lowest || specs_[s].across);
}

} // namespace touchdown
