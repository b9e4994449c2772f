// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_worker.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/results/results_writer.h"

namespace touchdown {

namespace {

constexpr double pictureRate = 60.0;  // [1/s]
constexpr double stepsPerRun = 200.0; // of a paused run at full speed
constexpr auto shortestWait = std::chrono::milliseconds(8);
// What one delivery may hold: the window takes it in within a few milliseconds, however fast the solver is.
constexpr std::size_t mostSamplesInMail = 16384;
constexpr std::size_t mostFieldValuesInMail = std::size_t(1) << 21; // 16 MB

std::size_t valuesOf(std::span<const FieldSnapshot> fields)
{
    std::size_t count = 0;
    for (const FieldSnapshot& snapshot : fields)
        for (const std::vector<double>& field : snapshot.values) count += field.size();
    return count;
}

/// How many of those from `begin` on are not after `time`.
template <typename Dated>
std::size_t countUntil(const std::vector<Dated>& all, std::size_t begin, double time)
{
    std::size_t end = begin;
    while (end < all.size() && all[end].time <= time) ++end;
    return end - begin;
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

std::size_t firstAfter(const SampleBatch& batch, std::size_t begin, double time)
{
    const auto from = batch.time.begin() + static_cast<std::ptrdiff_t>(begin);
    return static_cast<std::size_t>(std::upper_bound(from, batch.time.end(), time) - batch.time.begin());
}

} // namespace

struct RunController::Worker::Recorder {
    ResultsWriter writer;
    bool working = false;
};

RunController::Worker::Worker(Solver solver, RunRequest request, double pace, std::function<void()> notify)
    : solver_(std::move(solver)),
      request_(std::move(request)),
      notify_(std::move(notify)),
      pace_(pace),
      thread_([this] { work(); })
{}

RunController::Worker::~Worker()
{
    stop();
    join();
}

RunController::Worker::Mail RunController::Worker::take()
{
    // Cleared before the swap: mail that comes in between rings again rather than being left lying.
    pending_.store(false);
    Mail mail;
    const std::lock_guard lock(mailbox_);
    std::swap(mail, mail_);
    // The time reached holds until there is news of it.
    mail_.delivery.time = mail.delivery.time;
    mail_.delivery.duration = mail.delivery.duration;
    emptied_.notify_all();
    return mail;
}

void RunController::Worker::setPaused(bool paused)
{
    {
        const std::lock_guard lock(orders_);
        paused_ = paused;
        steps_ = 0;
        paceAnchored_ = false;
    }
    ordered_.notify_all();
}

void RunController::Worker::step()
{
    {
        const std::lock_guard lock(orders_);
        ++steps_;
    }
    ordered_.notify_all();
}

void RunController::Worker::stop()
{
    {
        const std::scoped_lock lock(orders_, mailbox_);
        stopped_ = true;
    }
    ordered_.notify_all();
    emptied_.notify_all();
}

void RunController::Worker::setPace(double pace)
{
    {
        const std::lock_guard lock(orders_);
        pace_ = pace;
        paceAnchored_ = false;
    }
    ordered_.notify_all();
}

void RunController::Worker::join()
{
    if (thread_.joinable()) thread_.join();
}

void RunController::Worker::work()
{
    std::string recordingProblem;
    if (!request_.recordTo.empty()) {
        recorder_ = std::make_unique<Recorder>();
        recordingProblem = recorder_->writer.open(request_.recordTo, request_.value, request_.caseText,
                                                  recordedQuantities(request_.value), recordedFields(request_.value));
        recorder_->working = recordingProblem.empty();
    }
    if (!recordingProblem.empty()) {
        const std::lock_guard lock(mailbox_);
        mail_.recordingProblem = recordingProblem;
    }

    Summary summary;
    try {
        summary = solver_(request_.value, [this](const RunUpdate& update) { return handOut(update); });
    } catch (const std::exception& problem) {
        summary.status = RunStatus::Failed;
        summary.message = std::string("The calculation broke off: ") + problem.what();
        summary.endTime = shownTime_;
    }
    summary = shownSummary(std::move(summary));

    std::string closingProblem;
    if (recorder_ && recorder_->working) closingProblem = recorder_->writer.finish(summary);
    {
        const std::lock_guard lock(mailbox_);
        if (!closingProblem.empty()) mail_.recordingProblem = closingProblem;
        mail_.summary = std::move(summary);
    }
    ring();
}

bool RunController::Worker::handOut(const RunUpdate& update)
{
    const SampleBatch& batch = update.samples;
    Slice slice;
    std::size_t eventsBegin = 0;
    std::size_t fieldsBegin = 0;
    while (slice.end < batch.size()) {
        slice.begin = slice.end;
        const std::optional<std::size_t> end = waitForSlice(batch, slice.begin, update.duration);
        if (!end) {
            heldBack_ = true;
            return false;
        }
        slice.end = *end;
        shownTime_ = batch.time[*end - 1];
        const double until = *end == batch.size() ? std::numeric_limits<double>::infinity() : shownTime_;
        slice.events = std::span(update.events).subspan(eventsBegin, countUntil(update.events, eventsBegin, until));
        slice.fields = std::span(update.fields).subspan(fieldsBegin, countUntil(update.fields, fieldsBegin, until));
        post(update, slice);
        eventsBegin += slice.events.size();
        fieldsBegin += slice.fields.size();
    }
    if (batch.size() == 0) post(update, {0, 0, update.events, update.fields});
    // At the end there is nothing to hold back any more.
    return update.time >= update.duration ? !stopRequested() : waitWhilePaused();
}

/// The end of the slice that may be shown now; none when the run is to stop.
std::optional<std::size_t> RunController::Worker::waitForSlice(const SampleBatch& batch, std::size_t begin,
                                                               double duration)
{
    std::unique_lock lock(orders_);
    for (;;) {
        if (stopped_) return std::nullopt;
        if (paused_) {
            if (steps_ > 0) {
                --steps_;
                const double length = std::isfinite(pace_) ? pace_ / pictureRate : duration / stepsPerRun;
                // Where samples are further apart than that, a step goes to the next sample.
                stepUntil_ = std::max(batch.time[begin], shownTime_ + length);
            }
            const std::size_t end = firstAfter(batch, begin, stepUntil_);
            if (end > begin) return end;
            ordered_.wait(lock);
            continue;
        }
        stepUntil_ = -std::numeric_limits<double>::infinity();
        if (!std::isfinite(pace_)) return batch.size();

        const Clock::time_point now = Clock::now();
        if (!paceAnchored_) {
            paceAnchored_ = true;
            wallAnchor_ = now;
            timeAnchor_ = shownTime_;
        }
        const double horizon = timeAnchor_ + pace_ * std::chrono::duration<double>(now - wallAnchor_).count();
        const std::size_t end = firstAfter(batch, begin, horizon);
        if (end > begin) return end;

        const double due = (batch.time[begin] - timeAnchor_) / pace_; // [s] after the anchor
        constexpr double longest = 1.0;                               // [s], asks again then
        const double wait = due - std::chrono::duration<double>(now - wallAnchor_).count();
        const auto nap =
            std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(wait, longest)));
        ordered_.wait_until(lock, now + std::max<Clock::duration>(nap, shortestWait));
    }
}

bool RunController::Worker::stopRequested()
{
    const std::lock_guard lock(orders_);
    return stopped_;
}

bool RunController::Worker::waitWhilePaused()
{
    std::unique_lock lock(orders_);
    ordered_.wait(lock, [this] { return stopped_ || !paused_ || steps_ > 0 || stepUntil_ > shownTime_; });
    return !stopped_;
}

/// Holds a solver back that is faster than the window, so that neither memory nor a delivery grows without bound.
void RunController::Worker::waitForRoom(std::size_t samples, std::size_t fieldValues)
{
    std::unique_lock lock(mailbox_);
    emptied_.wait(lock, [&] {
        const std::size_t held = mail_.delivery.samples.size();
        const std::size_t fieldsHeld = valuesOf(mail_.delivery.fields);
        const bool room = (held == 0 || held + samples <= mostSamplesInMail) &&
                          (fieldsHeld == 0 || fieldsHeld + fieldValues <= mostFieldValuesInMail);
        mail_.wasFull = mail_.wasFull || !room;
        return room || stopped_;
    });
}

void RunController::Worker::post(const RunUpdate& update, const Slice& slice)
{
    const auto [begin, end, events, fields] = slice;
    const SampleBatch& batch = update.samples;
    if (recorder_ && recorder_->working && end == begin && !fields.empty()) record({}, fields);
    if (end > begin) {
        lastSample_.clear();
        for (const std::vector<double>& column : batch.columns) lastSample_.push_back(column[end - 1]);
        if (recorder_ && recorder_->working) {
            if (begin == 0 && end == batch.size()) {
                record(batch, fields);
            } else {
                SampleBatch part;
                appendSlice(part, batch, begin, end);
                record(part, fields);
            }
        }
    }
    waitForRoom(end - begin, valuesOf(fields));
    {
        const std::lock_guard lock(mailbox_);
        RunDelivery& delivery = mail_.delivery;
        appendSlice(delivery.samples, batch, begin, end);
        delivery.events.insert(delivery.events.end(), events.begin(), events.end());
        delivery.fields.insert(delivery.fields.end(), fields.begin(), fields.end());
        delivery.time = end == batch.size() ? update.time : batch.time[end - 1];
        delivery.duration = update.duration;
    }
    ring();
}

void RunController::Worker::record(const SampleBatch& samples, std::span<const FieldSnapshot> fields)
{
    const std::string problem = recorder_->writer.append(samples, {fields.begin(), fields.end()});
    if (problem.empty()) return;
    recorder_->working = false;
    const std::lock_guard lock(mailbox_);
    mail_.recordingProblem = problem;
}

void RunController::Worker::ring()
{
    if (!pending_.exchange(true)) notify_();
}

/// A run that was stopped ends where it was seen to stop: the solver may have been ahead of it.
Summary RunController::Worker::shownSummary(Summary summary) const
{
    if (!heldBack_) return summary;
    summary.status = RunStatus::Cancelled;
    summary.message = "The run was stopped.";
    summary.endTime = shownTime_;
    const std::vector<Quantity> quantities = recordedQuantities(request_.value);
    summary.final.clear();
    for (std::size_t i = 0; i < std::min(quantities.size(), lastSample_.size()); ++i)
        summary.final.emplace_back(quantities[i].name, lastSample_[i]);
    summary.tail.clear();
    summary.peaks.clear();
    summary.bouncing = false;
    summary.bouncingRule.clear();
    summary.stepCheck.reset();
    std::erase_if(summary.events, [this](const RunEvent& event) { return event.time > shownTime_; });
    return summary;
}

} // namespace touchdown
