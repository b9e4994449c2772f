// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_spectrum.h"

#include <algorithm>

#include <QElapsedTimer>
#include <QVBoxLayout>

#include "core/simulation/recording/run_statistics.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/simulation/static_state/steady.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

namespace touchdown {

namespace {

constexpr int gentleInterval = 250; // [ms]
constexpr double mostLiveSamples = 131072.0;
constexpr int costShare = 20; // rest this many times as long as the last computation took

QString idOf(int number) { return QStringLiteral("run %1").arg(number); }

/// -1: of no run.
int numberOf(const QString& id)
{
    bool is = false;
    const int number = id.mid(4).toInt(&is);
    return is ? number : -1;
}

} // namespace

/// The modes of a static state that was solved.
struct LiveSpectrum::FilmModes {
    Case solved;
    Attitude attitude;
    std::vector<ReferenceFrequency> list;
};

LiveSpectrum::LiveSpectrum(RunsModel& runs, QWidget* parent)
    : QWidget(parent), runs_(runs), view_(new SpectrumView(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(view_);
    view_->plot()->setAccessibleName(tr("Plot of the power spectrum"));
    timer_.setSingleShot(true);
    timer_.setInterval(gentleInterval);
    connect(&timer_, &QTimer::timeout, this, &LiveSpectrum::computeStale);
    connect(view_, &SpectrumView::requested, this, &LiveSpectrum::recomputeAll);
    connect(&runs_, &RunsModel::added, this, [this](int number) {
        const RunRecord& run = *runs_.find(number);
        view_->group()->followNewest();
        if (run.finished()) dataArrived(number); // read from a file: nothing more will arrive
        const std::vector<Quantity>& quantities = run.quantities;
        const auto names = [](const std::vector<Quantity>& list) {
            std::vector<std::string> made;
            for (const Quantity& quantity : list) made.push_back(quantity.name);
            return made;
        };
        if (names(quantities) == names(offered_)) return;
        const bool first = offered_.empty();
        offered_ = quantities;
        view_->setQuantities(offered_);
        if (first) view_->setQuantity(QStringLiteral("minimum_spacing"));
    });
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        stale_.erase(number);
        whole_.erase(number);
        kept_.erase(number);
        view_->removeSpectrum(idOf(number));
    });
    connect(&runs_, &RunsModel::rowsRemoved, this, &LiveSpectrum::restyle);
    connect(&runs_, &RunsModel::shownChanged, this, [this](int number, bool shown) {
        if (shown && !whole_.contains(number)) runFinished(number);
        restyle();
    });
    connect(&runs_, &RunsModel::speakerChanged, this, &LiveSpectrum::restyle);
    connect(&runs_, &RunsModel::namesChanged, this, &LiveSpectrum::restyle);
    connect(view_->plot(), &PlotWidget::legendHovered, this, [this](const QString& id) { runs_.raise(numberOf(id)); });
}

LiveSpectrum::~LiveSpectrum() = default;

void LiveSpectrum::setOptionsOf(const Case& c) { view_->setOptions(welchOptions(c.spectrum, c.run.sampleInterval)); }

void LiveSpectrum::setFilmModes(const Case& solved, const ModesResult& result)
{
    filmModes_ = std::make_unique<FilmModes>(FilmModes{solved, result.steady.attitude, {}});
    for (const AirBearingMode& mode : result.modes)
        if (mode.frequency > 0.0)
            filmModes_->list.push_back({FrequencyKind::Mode, mode.frequency, mode.kind + " mode"});
    updateReferences();
}

void LiveSpectrum::updateReferences()
{
    const RunRecord* leads = runs_.find(leader_);
    std::vector<ReferenceFrequency> list;
    if (leads) list = referenceFrequencies(leads->value);
    if (leads && filmModes_ && leads->value.model == ModelKind::Film &&
        hasStaticState(leads->value, filmModes_->solved, filmModes_->attitude))
        list.insert(list.begin(), filmModes_->list.begin(), filmModes_->list.end());
    view_->setReferences(std::move(list));
}

void LiveSpectrum::dataArrived(int number)
{
    stale_.insert(number);
    if (!timer_.isActive()) timer_.start();
}

void LiveSpectrum::runFinished(int number)
{
    stale_.insert(number);
    const qint64 rest = last_.isValid() ? gentleInterval - last_.elapsed() : 0;
    if (rest <= 0)
        computeStale();
    else
        timer_.start(static_cast<int>(rest));
}

void LiveSpectrum::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    computeStale();
}

void LiveSpectrum::recomputeAll()
{
    view_->clear();
    whole_.clear();
    for (int row = 0; row < runs_.count(); ++row) stale_.insert(runs_.record(row).number);
    computeStale();
}

void LiveSpectrum::computeStale()
{
    // An invisible plot costs nothing.
    if (!isVisible()) return;
    timer_.stop();
    QElapsedTimer clock;
    clock.start();
    const long long before = computed_;
    for (const int number : stale_)
        if (const RunRecord* run = runs_.find(number); run && run->shown) compute(*run);
    stale_.clear();
    restyle();
    if (computed_ > before) last_.start();
    timer_.setInterval(std::max(gentleInterval, costShare * static_cast<int>(clock.elapsed())));
}

void LiveSpectrum::compute(const RunRecord& run)
{
    const std::string quantity = view_->quantity().toStdString();
    const WelchOptions options = view_->options();
    const auto show = [&](const Spectrum& spectrum, const std::vector<Peak>& peaks) {
        view_->setSpectrum(idOf(run.number), run.label, RunsModel::style(run), spectrum, peaks);
        if (run.finished()) whole_.insert(run.number);
    };
    const auto [first, last] = kept_.equal_range(run.number);
    for (auto kept = first; kept != last; ++kept)
        if (kept->second.quantity == quantity && kept->second.options == options)
            return show(kept->second.spectrum, kept->second.peaks);
    if (run.finished() && static_cast<double>(run.sampleCount()) > mostLiveSamples)
        return computeElsewhere(run, quantity, options);
    // During a long run the spectrum is that of its newest part, at the end that of the whole run.
    const double recent = run.lastTime() - mostLiveSamples * run.value.run.sampleInterval;
    const double start = run.finished() ? run.value.spectrum.start : std::max(run.value.spectrum.start, recent);
    Spectrum spectrum = spectrumOf(run, quantity, options, start);
    ++computed_;
    if (spectrum.empty()) return;
    const std::vector<Peak> peaks = findPeaks(spectrum, options.scaling);
    show(spectrum, peaks);
    if (run.finished()) keep(run.number, {quantity, options, std::move(spectrum), peaks});
}

void LiveSpectrum::keep(int number, Kept kept)
{
    constexpr std::size_t mostKept = 4; // of a run
    if (kept_.count(number) >= mostKept) kept_.erase(kept_.lower_bound(number));
    kept_.emplace(number, std::move(kept));
}

void LiveSpectrum::computeElsewhere(const RunRecord& run, const std::string& quantity, const WelchOptions& options)
{
    const auto same = [quantity, options](const auto& each) {
        return each.second.quantity == quantity && each.second.options == options;
    };
    const auto [first, last] = begun_.equal_range(run.number);
    if (std::any_of(first, last, same)) return;
    begun_.emplace(run.number, Kept{quantity, options, {}, {}});
    auto made = std::make_shared<Kept>(Kept{quantity, options, {}, {}});
    queue_.post(
        [made, signal = signalOf(run, quantity, run.value.spectrum.start)] {
            made->spectrum = spectrumOf(signal, made->options);
            made->peaks = findPeaks(made->spectrum, made->options.scaling);
            return QString();
        },
        [this, made, same, number = run.number](const QString&) {
            const auto [from, to] = begun_.equal_range(number);
            if (const auto begun = std::find_if(from, to, same); begun != to) begun_.erase(begun);
            ++computed_;
            if (!runs_.find(number) || made->spectrum.empty()) return restyle();
            keep(number, std::move(*made));
            runFinished(number); // shows it, if it is still what is wanted
        });
}

/// Until the newest run has a spectrum, the one before it leads.
void LiveSpectrum::restyle()
{
    const auto has = [this](int number) {
        return std::ranges::find(view_->plot()->curves(), idOf(number), &PlotCurve::id) !=
               view_->plot()->curves().end();
    };
    int leader = -1;
    for (int row = runs_.count() - 1; row >= 0 && leader < 0; --row)
        if (runs_.record(row).shown && has(runs_.record(row).number)) leader = runs_.record(row).number;
    if (leader != leader_) {
        leader_ = leader;
        updateReferences();
    }
    const int speaker = has(runs_.speaker()) ? runs_.speaker() : leader;
    view_->updateCurves([&](PlotCurve& curve) {
        const int number = numberOf(curve.id);
        const RunRecord* run = runs_.find(number);
        if (!run) return;
        curve.name = curve.runName = run->label;
        curve.run = number;
        curve.visible = run->shown;
        curve.pale = number != speaker;
        curve.leads = number == leader;
        curve.still = whole_.contains(number);
    });
}

} // namespace touchdown
