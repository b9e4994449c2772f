// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_spectrum.h"

#include <algorithm>

#include <QElapsedTimer>
#include <QVBoxLayout>

#include "core/simulation/recording/run_statistics.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

namespace touchdown {

namespace {

constexpr int gentleInterval = 250; // [ms]
constexpr double mostLiveSamples = 131072.0;
constexpr int costShare = 20; // rest this many times as long as the last computation took

QString idOf(int number) { return QStringLiteral("run %1").arg(number); }

} // namespace

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
        view_->removeSpectrum(idOf(number));
    });
    connect(&runs_, &RunsModel::shownChanged, this, [this](int number, bool shown) {
        if (shown)
            runFinished(number);
        else
            view_->removeSpectrum(idOf(number));
    });
}

void LiveSpectrum::setOptionsOf(const Case& c) { view_->setOptions(welchOptions(c.spectrum, c.run.sampleInterval)); }

void LiveSpectrum::dataArrived(int number)
{
    stale_.insert(number);
    if (!timer_.isActive()) timer_.start();
}

void LiveSpectrum::runFinished(int number)
{
    stale_.insert(number);
    computeStale();
}

void LiveSpectrum::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    computeStale();
}

void LiveSpectrum::recomputeAll()
{
    view_->clear();
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
    for (const int number : stale_)
        if (const RunRecord* run = runs_.find(number); run && run->shown) compute(*run);
    stale_.clear();
    timer_.setInterval(std::max(gentleInterval, costShare * static_cast<int>(clock.elapsed())));
}

void LiveSpectrum::compute(const RunRecord& run)
{
    const std::string quantity = view_->quantity().toStdString();
    const WelchOptions options = view_->options();
    // During a long run the spectrum is that of its newest part, at the end that of the whole run.
    const double recent = run.lastTime() - mostLiveSamples * run.value.run.sampleInterval;
    const double start = run.finished() ? run.value.spectrum.start : std::max(run.value.spectrum.start, recent);
    const Spectrum spectrum = spectrumOf(run, quantity, options, start);
    if (spectrum.empty()) return;
    const bool newest = runs_.record(runs_.count() - 1).number == run.number;
    view_->setSpectrum(idOf(run.number), tr("Run %1").arg(run.number), RunsModel::style(run), spectrum,
                       newest ? findPeaks(spectrum, options.scaling) : std::vector<Peak>{});
}

} // namespace touchdown
