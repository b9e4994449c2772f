// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_controller.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/results/results_writer.h"
#include "core/simulation/run.h"

namespace touchdown {

namespace {

// Most that one delivery holds: the window takes it in within a few milliseconds, however fast the solver is.
constexpr std::size_t mostSamplesInMail = 16384;
constexpr double secondsBetweenCheckpoints = 1.0;
constexpr std::size_t mostFieldValuesInMail = std::size_t(1) << 21; // 16 MB

std::size_t valuesOf(std::span<const FieldSnapshot> fields)
{
    std::size_t count = 0;
    for (const FieldSnapshot& snapshot : fields)
        for (const std::vector<double>& field : snapshot.values) count += field.size();
    return count;
}

/// Those from `begin` on that are not after `time`.
template <typename Dated>
std::span<const Dated> until(const std::vector<Dated>& all, std::size_t begin, double time)
{
    std::size_t end = begin;
    while (end < all.size() && all[end].time <= time) ++end;
    return std::span(all).subspan(begin, end - begin);
}

void appendSlice(SampleBatch& target, const SampleBatch& source, std::size_t begin, std::size_t end)
{
    const auto from = static_cast<std::ptrdiff_t>(begin);
    const auto to = static_cast<std::ptrdiff_t>(end);
    target.columns.resize(source.columns.size());
    target.time.insert(target.time.end(), source.time.begin() + from, source.time.begin() + to);
    for (std::size_t i = 0; i < source.columns.size(); ++i)
        target.columns[i].insert(target.columns[i].end(), source.columns[i].begin() + from,
                                 source.columns[i].begin() + to);
}

/// One run on the worker's thread: calls the solver, hands its batches out slice by slice at the pace that the window
/// asks for, and records them to a results file.
class RunWorker {
public:
    RunWorker(const RunController::Solver& solver, RunRequest request, RunPace& pace, Mailbox<RunMail>& mailbox,
              std::stop_token stop);

    void work();

private:
    /// The part of an update that is handed out together.
    struct Slice {
        std::size_t begin = 0, end = 0; // of the samples
        std::span<const RunEvent> events;
        std::span<const FieldSnapshot> fields;
    };

    bool handOut(const RunUpdate& update);
    void post(const RunUpdate& update, const Slice& slice);
    void openRecording(const std::vector<RecordedFields>& sets);
    /// What came before in a run that continues, at once.
    void postEarlier();
    void keep(std::shared_ptr<const StoredCheckpoint> checkpoint);
    void report(const std::string& recordingProblem);
    Summary shownSummary(Summary summary) const;

    const RunController::Solver& solver_;
    RunRequest request_;
    RunPace& pace_;
    Mailbox<RunMail>& mailbox_;
    std::stop_token stop_;

    std::size_t samples_ = 0;            // posted
    std::vector<std::size_t> snapshots_; // posted, of each set
    bool heldBack_ = false;              // stopped with samples that were not shown
    std::vector<double> lastSample_;
    std::optional<ResultsWriter> recorder_; // none after a problem
};

RunWorker::RunWorker(const RunController::Solver& solver, RunRequest request, RunPace& pace, Mailbox<RunMail>& mailbox,
                     std::stop_token stop)
    : solver_(solver), request_(std::move(request)), pace_(pace), mailbox_(mailbox), stop_(std::move(stop))
{}

void RunWorker::work()
{
    Summary summary;
    try {
        std::vector<RecordedFields> sets = recordedFields(request_.value, [this] { return !stop_.stop_requested(); });
        snapshots_.assign(sets.size(), 0);
        openRecording(sets);
        mailbox_.post([&](RunMail& mail) { mail.delivery.sets = std::move(sets); });
        postEarlier();
        request_.options.checkpointEach = secondsBetweenCheckpoints;
        summary = solver_(
            request_.value, [this](const RunUpdate& update) { return handOut(update); }, request_.options);
    } catch (const std::exception& problem) {
        summary.status = RunStatus::Failed;
        summary.message = std::string("The calculation stopped with an error: ") + problem.what();
        summary.endTime = pace_.shownTime();
    }
    summary = shownSummary(std::move(summary));
    if (recorder_) report(recorder_->finish(summary));
    mailbox_.post([&](RunMail& mail) { mail.summary = std::move(summary); });
}

void RunWorker::openRecording(const std::vector<RecordedFields>& sets)
{
    if (request_.recordTo.empty()) return;
    ResultsWriter& writer = recorder_.emplace();
    const std::vector<Quantity> quantities = recordedQuantities(request_.value);
    report(request_.earlier ? writer.openAgain(request_.recordTo, request_.value, request_.caseText, quantities, sets,
                                               0.0, request_.earlier->remark)
                            : writer.open(request_.recordTo, request_.value, request_.caseText, quantities, sets));
}

void RunWorker::postEarlier()
{
    if (!request_.earlier) return;
    const EarlierRun& earlier = *request_.earlier;
    const StoredCheckpoint& from = *earlier.states.back();
    if (from.snapshots.size() != snapshots_.size()) throw std::runtime_error("its maps are not those of the run");
    const double time = from.at.time, duration = request_.value.run.duration;
    const std::vector<RunEvent> none;
    const std::vector<FieldSnapshot> noMaps;
    for (const SampleBatch& part : earlier.samples)
        post({time, duration, part, none, noMaps}, {0, part.size(), {}, {}});
    const SampleBatch empty{{}, std::vector<std::vector<double>>(recordedQuantities(request_.value).size())};
    post({time, duration, empty, earlier.events, earlier.fields}, {0, 0, earlier.events, earlier.fields});
    for (const auto& state : earlier.states) keep(state);
    request_.options.from = {earlier.states.back(), &from.at};
    pace_.begin(time);
    request_.earlier.reset();
}

void RunWorker::keep(std::shared_ptr<const StoredCheckpoint> checkpoint)
{
    if (recorder_) report(recorder_->keep(checkpoint));
    mailbox_.post([&](RunMail& mail) { mail.delivery.checkpoints.add(std::move(checkpoint)); });
}

bool RunWorker::handOut(const RunUpdate& update)
{
    const SampleBatch& batch = update.samples;
    if (batch.size() == 0) post(update, {0, 0, update.events, update.fields});
    Slice slice;
    std::size_t events = 0, fields = 0; // handed out
    while (slice.end < batch.size()) {
        slice.begin = slice.end;
        const auto end = pace_.waitForSlice(batch.time, slice.begin, update.duration, stop_);
        if (!end) {
            heldBack_ = true;
            return false;
        }
        slice.end = *end;
        const double time = *end == batch.size() ? std::numeric_limits<double>::infinity() : batch.time[*end - 1];
        slice.events = until(update.events, events, time);
        slice.fields = until(update.fields, fields, time);
        events += slice.events.size();
        fields += slice.fields.size();
        post(update, slice);
    }
    if (update.checkpoint)
        keep(std::make_shared<const StoredCheckpoint>(StoredCheckpoint{
            *update.checkpoint, checkpointLayout, TOUCHDOWN_VERSION, thisMachine(), samples_, snapshots_}));
    if (update.time < update.duration) pace_.waitWhilePaused(stop_); // at the end all samples are handed out
    return !stop_.stop_requested();
}

void RunWorker::post(const RunUpdate& update, const Slice& slice)
{
    const auto [begin, end, events, fields] = slice;
    const SampleBatch& batch = update.samples;
    const std::size_t samples = end - begin;
    SampleBatch part;
    appendSlice(part, batch, begin, end);
    if (samples > 0) {
        lastSample_.clear();
        for (const std::vector<double>& column : batch.columns) lastSample_.push_back(column[end - 1]);
    }
    samples_ += samples;
    for (const FieldSnapshot& snapshot : fields)
        if (snapshot.set < snapshots_.size()) ++snapshots_[snapshot.set];
    if (recorder_ && (samples > 0 || !fields.empty()))
        report(recorder_->append(samples > 0 ? part : SampleBatch{}, {fields.begin(), fields.end()}));

    // A solver that is faster than the window waits, so that neither memory nor a delivery grows without bound.
    const std::size_t fieldValues = valuesOf(fields);
    mailbox_.waitForRoom(stop_, [&](RunMail& mail) {
        const std::size_t held = mail.delivery.samples.size();
        const std::size_t fieldsHeld = valuesOf(mail.delivery.fields);
        const bool room = (held == 0 || held + samples <= mostSamplesInMail) &&
                          (fieldsHeld == 0 || fieldsHeld + fieldValues <= mostFieldValuesInMail);
        mail.wasFull = mail.wasFull || !room;
        return room;
    });
    mailbox_.post([&](RunMail& mail) {
        RunDelivery& delivery = mail.delivery;
        appendSlice(delivery.samples, part, 0, samples);
        delivery.events.insert(delivery.events.end(), events.begin(), events.end());
        delivery.fields.insert(delivery.fields.end(), fields.begin(), fields.end());
        delivery.time = end == batch.size() ? update.time : batch.time[end - 1];
        delivery.duration = update.duration;
    });
}

/// After a problem the run continues without its file.
void RunWorker::report(const std::string& recordingProblem)
{
    if (recordingProblem.empty()) return;
    recorder_.reset();
    mailbox_.post([&](RunMail& mail) { mail.recordingProblem = recordingProblem; });
}

/// The solver may be ahead of the samples that were shown: a run that was stopped ends with the last of these.
Summary RunWorker::shownSummary(Summary summary) const
{
    if (!heldBack_) return summary;
    summary.status = RunStatus::Cancelled;
    summary.message = "The run was stopped.";
    summary.endTime = pace_.shownTime();
    const std::vector<Quantity> quantities = recordedQuantities(request_.value);
    summary.final.clear();
    for (std::size_t i = 0; i < std::min(quantities.size(), lastSample_.size()); ++i)
        summary.final.emplace_back(quantities[i].name, lastSample_[i]);
    summary.tail.clear();
    summary.peaks.clear();
    summary.extremes.clear();
    summary.verdict = {};
    summary.stepCheck.reset();
    std::erase_if(summary.events, [this](const RunEvent& event) { return event.time > pace_.shownTime(); });
    return summary;
}

} // namespace

RunController::RunController(QObject* parent) : RunController(run, parent) {}

RunController::RunController(Solver solver, QObject* parent) : CalculationController(parent), solver_(std::move(solver))
{}

int RunController::start(RunRequest request)
{
    stopAndWait();
    pace_.reset();
    return begin([this, request = std::move(request)](const std::stop_token& stop) {
        RunWorker(solver_, request, pace_, mailbox_, stop).work();
    });
}

void RunController::pause()
{
    if (setPaused(true)) pace_.setPaused(true);
}

void RunController::resume()
{
    if (setPaused(false)) pace_.setPaused(false);
}

void RunController::step()
{
    if (state() == State::Paused) pace_.step();
}

void RunController::deliver()
{
    RunMail mail = mailbox_.take();
    mail.delivery.run = current();
    if (!mail.recordingProblem.empty()) emit recordingFailed(current(), QString::fromStdString(mail.recordingProblem));
    emit delivered(mail.delivery);
    if (mail.delivery.duration > 0.0)
        emit progressed(current(), runProgress(mail.delivery.time, mail.delivery.duration));
    // A solver that waits for room gets it at once: the plots draw at their own rate.
    setInterval(mail.wasFull ? 0 : shortestInterval);
    if (!mail.summary) return;
    end();
    emit finished(current(), *mail.summary);
}

} // namespace touchdown
