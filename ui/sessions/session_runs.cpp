// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeping a run while it lasts.
#include "ui/sessions/session.h"

#include <chrono>
#include <thread>
#include <utility>

#include "core/results/results_writer.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"

namespace touchdown {

namespace {

// A run that ends within this time has the processor to itself: its file is written afterwards.
constexpr auto restBeforeFile = std::chrono::milliseconds(100);

std::size_t bytesOf(const SampleBatch& samples)
{
    return samples.size() * (samples.columns.size() + 1) * sizeof(double);
}

std::size_t bytesOf(const std::vector<FieldSnapshot>& fields)
{
    std::size_t count = 0;
    for (const FieldSnapshot& snapshot : fields)
        for (const std::vector<double>& values : snapshot.values) count += values.size();
    return count * sizeof(double);
}

} // namespace

struct Session::Stream {
    int number = 0;
    bool opened = false; // or waits for it on the writer's thread
    ResultsWriter writer;
    bool whole = true;   // no samples or snapshots from before it are missing
    bool broken = false; // on the writer's thread
};

void Session::connectRuns()
{
    connect(&bench_.runWindow(), &RunWindow::started, this, &Session::onRunStarted);
    connect(&bench_.runWindow().controller(), &RunController::delivered, this, &Session::onDelivered);
    connect(&bench_.runWindow(), &RunWindow::ended, this, &Session::onRunEnded);
    connect(&bench_.runWindow().controller(), &RunController::recordingFailed, this, [this] {
        // The file that the user wanted has failed: the session keeps the run instead.
        if (RunRecord* run = bench_.runWindow().runUnderWay()) beginStream(*run);
    });
    connect(&bench_.runWindow().runs(), &RecordList::aboutToRemove, this, [this](int number) {
        if (folder_) removeFile(folder_->runFile(number));
    });
}

void Session::onRunStarted(int number)
{
    keepWithinBudget();
    // A run that the user records is in that file.
    if (RunRecord* run = bench_.runWindow().runs().find(number); run && run->file.isEmpty()) beginStream(*run);
}

void Session::beginStream(RunRecord& run)
{
    if (!folder_ || refuses(0)) return;
    stream_ = std::make_shared<Stream>();
    stream_->number = run.number;
    if (!run.finished() && fieldsKnownOf_ != run.number) return; // its first delivery says which fields it records
    std::vector<RecordedFields> sets;
    for (const FieldHistory& history : run.fields) sets.push_back(history.fields);
    openStream(run, sets);
    RunDelivery whole;
    stream_->whole = run.fieldsComplete();
    for (std::size_t part = 0; part < run.parts(); ++part) {
        whole.samples = run.samples(part);
        onDelivered(whole);
    }
    whole.samples = {};
    for (const FieldHistory& history : run.fields)
        for (std::size_t i = 0; i < history.snapshots.size(); ++i) whole.fields.push_back(history.snapshot(i));
    whole.checkpoints = run.checkpoints;
    onDelivered(whole);
}

void Session::openStream(const RunRecord& run, const std::vector<RecordedFields>& sets)
{
    stream_->opened = true;
    write([stream = stream_, file = folder_->runFile(run.number).toStdString(), c = run.value, text = run.caseText,
           quantities = run.quantities, sets] {
        std::this_thread::sleep_for(restBeforeFile);
        const std::string problem = stream->writer.open(file, c, text, quantities, sets);
        stream->broken = !problem.empty();
        return QString::fromStdString(problem);
    });
}

void Session::onDelivered(const RunDelivery& delivery)
{
    if (const RunRecord* run = bench_.runWindow().runUnderWay(); run && delivery.sets) {
        fieldsKnownOf_ = run->number;
        if (stream_) openStream(*run, *delivery.sets);
    }
    const std::size_t bytes = bytesOf(delivery.samples) + bytesOf(delivery.fields);
    if (!stream_ || (bytes == 0 && !delivery.checkpoints.newest)) return;
    if (results_.pending() + bytes > mostPending) {
        results_.post([stream = std::exchange(stream_, nullptr)] {
            stream->broken = true;
            return QString();
        });
        report(tr("The disk is slower than the run."));
        return;
    }
    write(
        [stream = stream_, samples = delivery.samples, fields = delivery.fields, states = delivery.checkpoints] {
            if (stream->broken) return QString();
            std::string problem = stream->writer.append(samples, fields);
            for (const auto& state : {states.extends, states.newest})
                if (state && problem.empty()) problem = stream->writer.keep(state);
            stream->broken = !problem.empty();
            return QString::fromStdString(problem);
        },
        {}, bytes);
}

void Session::onRunEnded(int number, const Summary& summary)
{
    schedule();
    if (!stream_ || stream_->number != number) return;
    if (!stream_->opened) return stream_.reset(); // it failed before it began
    write(
        [stream = std::exchange(stream_, nullptr), summary] {
            if (stream->broken || !stream->whole) return tr("The file of the run is not complete.");
            return QString::fromStdString(stream->writer.finish(summary));
        },
        [this, number, file = folder_->runFile(number)] { bench_.runWindow().runs().setKept(number, file); });
}

bool Session::recordsWholeRun() const
{
    const RunRecord* underWay = bench_.runWindow().runUnderWay();
    return !underWay || !underWay->file.isEmpty() || (stream_ && stream_->whole);
}

} // namespace touchdown
