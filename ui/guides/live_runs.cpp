// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/live_runs.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <time.h>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/simulation/run.h"
#include "core/simulation/small_motions/linear_state.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/style/quantity_format.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

namespace {

constexpr int mergeOfMovements = 1 << 16; // with the number of the movement: of edits that are one for undo
constexpr double quick = 0.3;             // processor time of a run that follows the hand [s]

/// Of this thread [s]: what other programs do does not decide whether a case is quick.
double processorTime()
{
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The run of a case until a time [s], or to its end, maybe about a similar state; nothing where it takes too long, is
/// left, or breaks off.
std::unique_ptr<RunRecord> performed(const Case& c, double until, bool similar, bool limited,
                                     const std::atomic<bool>& left)
{
    const double start = processorTime();
    bool whole = true;
    std::unique_ptr<RunRecord> record;
    try {
        const auto goOn = [&] {
            whole = !left && !(limited && processorTime() - start > quick);
            return whole;
        };
        record = performedRecord(c, until, goOn, {.kept = similar ? KeptStates::Similar : KeptStates::Own});
    } catch (const std::exception&) {
        return nullptr;
    }
    if (until < c.run.duration) record->note = LiveRuns::tr("first %1").arg(timeText(until));
    if (similar && limited) record->note = LiveRuns::tr("preview");
    return whole ? std::move(record) : nullptr;
}

} // namespace

bool isLinearFilm(const Case& c) { return c.model == ModelKind::Film && c.film.motion == FilmMotion::Linear; }

bool followsHand(const Case& c) { return c.model == ModelKind::Springs || isLinearFilm(c); }

double neededUntil(const RunView& view, const Case& c)
{
    const LivePlots& plots = *view.plots();
    const std::optional<PlotRange> range = plots.group()->fixedRange();
    const bool byTime = view.page() == RunView::Page::Plots && view.spectrum()->isHidden() &&
                        plots.plot(QStringLiteral("spectrogram"))->isHidden() && range && range->high > 0.0;
    Case part = c;
    part.run.duration = byTime ? std::min(range->high, c.run.duration) : c.run.duration;
    return checkCombinations(part).empty() ? part.run.duration : c.run.duration;
}

Case coarser(const Case& c)
{
    Case coarse = c;
    const Parameter& nodes = *findParameter("film.nodes");
    for (int& count : coarse.film.nodes) {
        const int intervals = (count - 1) / 2 / nodes.stride * nodes.stride;
        count = std::max(intervals + 1, static_cast<int>(nodes.minimum));
    }
    const bool onCells = contactLaw(c).recordsSurfaces;
    if (onCells) coarse.elastic.cell *= 2.0;
    if (onCells && c.diskSurface.kind != DiskSurfaceKind::Flat)
        coarse.diskSurface.cell = std::max(coarse.diskSurface.cell, coarse.elastic.cell);
    return checkCombinations(coarse).empty() ? coarse : c;
}

LiveRuns::LiveRuns(Workbench& bench, QObject* parent) : QObject(parent), bench_(bench), queue_(nullptr)
{
    connect(&bench_.runWindow(), &RunWindow::ended, this, &LiveRuns::onEnded);
    connect(&bench_.files(), &CaseFiles::opened, this, &LiveRuns::leave);
}

LiveRuns::~LiveRuns()
{
    for (const std::weak_ptr<Movement>& each : all_)
        if (const auto movement = each.lock()) movement->left = true;
}

void LiveRuns::leave()
{
    for (const std::weak_ptr<Movement>& each : std::exchange(all_, {}))
        if (const auto movement = each.lock()) stop(*movement);
    movement_.reset();
    grids_.reset();
    emit busyChanged();
}

void LiveRuns::stop(Movement& movement)
{
    movement.left = true;
    forgetPart(movement);
}

/// A run of the beginning alone, or a preview, is no result.
void LiveRuns::forgetPart(Movement& movement)
{
    const RunRecord* run = movement.number < 0 ? nullptr : bench_.runWindow().runs().find(movement.number);
    if (run && (movement.preview || run->lastTime() < run->value.run.duration * (1.0 - 1e-9)))
        bench_.runWindow().runs().remove(bench_.runWindow().runs().rowOf(movement.number));
}

std::shared_ptr<LiveRuns::Movement> LiveRuns::begun()
{
    std::erase_if(all_, [](const std::weak_ptr<Movement>& each) { return each.expired(); });
    auto movement = std::make_shared<Movement>();
    all_.push_back(movement);
    return movement;
}

void LiveRuns::move(const LiveValue& value, const std::string& text)
{
    CaseEdits& edits = bench_.edits();
    Case changed = edits.value();
    for (const std::string& key : value.keys)
        if (setFromText(changed, *findParameter(key), text)) return; // out of its range: it stays
    if (changed == edits.value()) return;
    if (!movement_ || movement_->settled) {
        if (movement_ && movement_->finds) stop(*movement_); // it would keep the next runs waiting
        movement_ = begun();
        movement_->merge = mergeOfMovements + ++movements_;
    }
    movement_->value = changed;
    const QString label = QString::fromStdString(findParameter(value.keys.front())->label);
    edits.setAll(changed, tr("move %1").arg(label), movement_->merge);
    const bool runs = followsHand(changed) && edits.reasonNotToRun().isEmpty();
    if (runs && !movement_->busy && !movement_->slow) runOnce(movement_);
}

void LiveRuns::settle()
{
    if (!movement_ || movement_->settled) return;
    movement_->settled = true;
    if (!bench_.edits().reasonNotToRun().isEmpty()) return forgetPart(*movement_);
    movement_->text = bench_.files().wholeText();
    if (!followsHand(movement_->value) && movement_->value.model == ModelKind::Film)
        runFilm();
    else if (!followsHand(movement_->value) || movement_->slow)
        bench_.startRun();
    else if (!movement_->busy)
        movement_->part ? runOnce(movement_) : finish(*movement_);
}

void LiveRuns::runAnew()
{
    const Case& now = bench_.edits().value();
    if (movement_ && movement_->anew && movement_->busy) { // its next run is of the newest values
        movement_->value = now;
        movement_->text = bench_.files().wholeText();
        return;
    }
    if (movement_ && !movement_->settled) stop(*movement_); // undone before the reader let go
    movement_ = begun();
    movement_->value = now;
    movement_->anew = movement_->part = true; // there is no run of it
    settle();
}

void LiveRuns::runOnce(const std::shared_ptr<Movement>& movement)
{
    movement->busy = true;
    const Case& now = movement->value;
    const double until = movement->settled ? now.run.duration : neededUntil(*bench_.runWindow().view(), now);
    const bool similar = isLinearFilm(now) && !movement->settled && !hasLinearState(now);
    movement->part = until < now.run.duration || similar;
    movement->finds = isLinearFilm(now) && (similar ? !nearestLinearState(now) : !hasLinearState(now));
    emit busyChanged();
    auto record = std::make_shared<std::unique_ptr<RunRecord>>();
    queue_.post(
        [record, movement, until, similar, limited = !movement->finds, c = now] {
            *record = performed(c, until, similar, limited, movement->left);
            return QString();
        },
        [this, record, movement, preview = similar && !movement->finds](const QString&) {
            if (*record) movement->preview = preview;
            show(movement, std::move(*record));
        });
}

void LiveRuns::show(const std::shared_ptr<Movement>& movement, std::unique_ptr<RunRecord> record)
{
    movement->busy = movement->finds = false;
    emit busyChanged();
    if (movement->left) return;
    if (!record) {
        movement->slow = true;
        forgetPart(*movement);
        if (!movement->settled) return;
        if (movement == movement_)
            bench_.startRun();
        else // another movement has begun: the case in the window is that one's
            bench_.runWindow().start({movement->value, movement->text, {}});
        return;
    }
    const bool newest = record->value == movement->value;
    RunsModel& runs = bench_.runWindow().runs();
    // The reader may have removed it.
    const int row = movement->number < 0 ? -1 : runs.rowOf(movement->number);
    if (row >= 0) runs.remove(row);
    record->ofGuide = true;
    record->number = row >= 0 ? movement->number : runs.nextNumber();
    movement->number = runs.add(std::move(record)).number;
    emit shown(movement->number);
    if (!newest || (movement->settled && movement->part))
        runOnce(movement);
    else if (movement->settled)
        finish(*movement);
}

/// From now on its run stays as it is.
void LiveRuns::finish(Movement& movement)
{
    RunRecord* run = movement.number < 0 ? nullptr : bench_.runWindow().runs().find(movement.number);
    if (!run) return;
    run->caseText = movement.text;
    bench_.runWindow().announce(movement.number);
}

void LiveRuns::runFilm()
{
    RunsModel& runs = bench_.runWindow().runs();
    // That of an earlier movement, whose finer run did not come to its end.
    if (const int row = grids_ ? runs.rowOf(grids_->coarse) : -1; row >= 0) {
        bench_.runWindow().controller().stopAndWait();
        if (const int left = runs.rowOf(grids_->coarse); left >= 0) runs.remove(left);
    }
    const Case coarse = coarser(movement_->value);
    grids_.reset();
    if (coarse == movement_->value) return bench_.startRun();
    TwoGrids grids{movement_->value, movement_->text, -1, -1};
    bench_.runWindow().start({coarse, updateCaseText(grids.text, coarse), {}});
    RunRecord* run = bench_.runWindow().runUnderWay();
    if (!run) return;
    run->note = tr("coarse grid");
    run->ofGuide = true;
    grids.coarse = run->number;
    grids_ = grids;
}

void LiveRuns::onEnded(int number, const Summary& summary)
{
    if (!grids_) return;
    if (number == grids_->coarse) {
        if (summary.status == RunStatus::Cancelled) return grids_.reset();
        // After the window has shown the end of this run.
        QMetaObject::invokeMethod(
            this,
            [this, number] {
                RunWindow& runs = bench_.runWindow();
                if (!grids_ || grids_->coarse != number || runs.runUnderWay()) return;
                if (bench_.edits().value() != grids_->own) return grids_.reset();
                runs.start({grids_->own, grids_->text, {}});
                if (RunRecord* run = runs.runUnderWay()) {
                    run->ofGuide = true;
                    grids_->fine = run->number;
                }
            },
            Qt::QueuedConnection);
    } else if (number == grids_->fine) {
        const int row = bench_.runWindow().runs().rowOf(grids_->coarse);
        if (row >= 0 && summary.status == RunStatus::Completed) bench_.runWindow().runs().remove(row);
        grids_.reset();
    }
}

} // namespace touchdown
