// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/live_runs.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/simulation/run.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/window/main_window.h"

namespace touchdown {

namespace {

constexpr int mergeOfMovements = 1 << 16; // with the number of the movement: of edits that are one for undo

/// The whole run of a case; nothing where the solver broke off.
std::unique_ptr<RunRecord> performed(int number, const Case& c)
{
    auto record = std::make_unique<RunRecord>(number, c, std::string(), recordedQuantities(c), recordedFields(c));
    try {
        record->finish(run(c, [&record](const RunUpdate& update) {
            record->append(update.samples, update.events, update.fields);
            return true;
        }));
    } catch (const std::exception&) {
        return nullptr;
    }
    return record;
}

} // namespace

Case coarser(const Case& c)
{
    Case coarse = c;
    const Parameter& nodes = *findParameter("film.nodes");
    for (int& count : coarse.film.nodes) {
        const int intervals = (count - 1) / 2 / nodes.stride * nodes.stride;
        count = std::max(intervals + 1, static_cast<int>(nodes.minimum));
    }
    if (c.contact == ContactKind::Elastic) coarse.elastic.cell *= 2.0;
    if (c.contact == ContactKind::Elastic && c.diskSurface.kind != DiskSurfaceKind::Flat)
        coarse.diskSurface.cell = std::max(coarse.diskSurface.cell, coarse.elastic.cell);
    return checkCombinations(coarse).empty() ? coarse : c;
}

LiveRuns::LiveRuns(MainWindow& window) : QObject(&window), window_(window), queue_(nullptr)
{
    connect(&window_.runWindow(), &RunWindow::ended, this, &LiveRuns::onEnded);
}

void LiveRuns::move(const LiveValue& value, double number)
{
    if (!std::exchange(moving_, true)) {
        ++movement_;
        number_ = -1;
    }
    CaseEdits& edits = window_.edits();
    Case changed = edits.value();
    for (const std::string& key : value.keys)
        if (setFromNumber(changed, *findParameter(key), number)) return; // out of its range: it stays
    if (changed == edits.value()) return;
    const QString label = QString::fromStdString(findParameter(value.keys.front())->label);
    edits.setAll(changed, tr("move %1").arg(label), mergeOfMovements + movement_);
    if (changed.model != ModelKind::Springs || !edits.reasonNotToRun().isEmpty()) return;
    if (busy_)
        again_ = true;
    else
        runOnce();
}

void LiveRuns::settle()
{
    if (!std::exchange(moving_, false)) return;
    if (!window_.edits().reasonNotToRun().isEmpty()) return;
    if (window_.edits().value().model == ModelKind::Film)
        runFilm();
    else if (!busy_)
        window_.startRunInPlaceOf(number_);
}

void LiveRuns::runOnce()
{
    busy_ = true;
    again_ = false;
    // A run that the user started meanwhile has its own row, below.
    const RunsModel& runs = window_.runs();
    if (runs.count() == 0 || runs.rowOf(number_) != runs.count() - 1) number_ = window_.runs().nextNumber();
    auto record = std::make_shared<std::unique_ptr<RunRecord>>();
    queue_.post(
        [record, number = number_, c = window_.edits().value()] {
            *record = performed(number, c);
            return QString();
        },
        [this, record](const QString&) { show(std::move(*record)); });
}

void LiveRuns::show(std::unique_ptr<RunRecord> record)
{
    busy_ = false;
    RunsModel& runs = window_.runs();
    const bool ofThis =
        record && record->number == number_ && (number_ == runs.nextNumber() || runs.rowOf(number_) >= 0);
    if (ofThis) {
        if (const int row = runs.rowOf(number_); row >= 0) runs.remove(row);
        runs.add(std::move(record));
        emit shown(number_);
    }
    if (!moving_)
        window_.startRunInPlaceOf(number_);
    else if (again_)
        runOnce();
}

void LiveRuns::runFilm()
{
    const Case own = window_.edits().value();
    const Case coarse = coarser(own);
    coarse_ = fine_ = -1;
    if (coarse == own) return window_.startRun();
    window_.runWindow().start({coarse, updateCaseText(window_.files().wholeText(), coarse), {}});
    if (const RunRecord* run = window_.runWindow().runUnderWay()) coarse_ = run->number;
}

void LiveRuns::onEnded(int number, const Summary& summary)
{
    RunsModel& runs = window_.runs();
    if (number == coarse_ && fine_ < 0) {
        if (summary.status == RunStatus::Cancelled) {
            coarse_ = -1;
            return;
        }
        // After the window has shown the end of this run.
        QMetaObject::invokeMethod(
            this,
            [this, number] {
                if (coarse_ != number || window_.runWindow().runUnderWay()) return;
                window_.startRun();
                if (const RunRecord* run = window_.runWindow().runUnderWay()) fine_ = run->number;
            },
            Qt::QueuedConnection);
    } else if (number == fine_) {
        const int row = runs.rowOf(std::exchange(coarse_, -1));
        if (row >= 0 && summary.status == RunStatus::Completed) runs.remove(row);
        fine_ = -1;
    }
}

} // namespace touchdown
