// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_writer.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "core/formats/output_file.h"
#include "core/results/file_header.h"
#include "core/results/results_exchange.h"

namespace touchdown {
namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

// Samples that may wait for the disk before a flush begins early, and before append() waits [numbers].
constexpr std::size_t earlyFlush = std::size_t{2} << 20;
constexpr std::size_t mostPending = std::size_t{6} << 20;

void append(SampleBatch& target, const SampleBatch& batch)
{
    if (target.columns.empty()) target.columns.resize(batch.columns.size());
    target.time.insert(target.time.end(), batch.time.begin(), batch.time.end());
    for (std::size_t i = 0; i < batch.columns.size(); ++i)
        target.columns[i].insert(target.columns[i].end(), batch.columns[i].begin(), batch.columns[i].end());
}

bool fits(const SampleBatch& batch, std::size_t columns)
{
    if (batch.size() == 0) return true;
    if (batch.columns.size() != columns) return false;
    for (const auto& column : batch.columns)
        if (column.size() != batch.size()) return false;
    return true;
}

bool fits(const std::vector<FieldSnapshot>& snapshots, const std::vector<RecordedFields>& sets)
{
    return std::ranges::all_of(snapshots, [&](const FieldSnapshot& snapshot) {
        if (snapshot.set >= sets.size()) return false;
        const RecordedFields& set = sets[snapshot.set];
        return snapshot.values.size() == set.quantities.size() &&
               std::ranges::all_of(snapshot.values,
                                   [&](const auto& values) { return values.size() == set.grid.cells(); });
    });
}

} // namespace

struct ResultsWriter::File {
    fs::path path;
    std::size_t columns;
    std::vector<RecordedFields> fields;
    ResultsExchange exchange;
    std::chrono::milliseconds interval;

    std::mutex mutex; // of all below
    std::condition_variable_any changed;
    SampleBatch pending;
    std::vector<FieldSnapshot> pendingFields;
    std::vector<ResultsSpectrum> spectra;
    std::string problem;
    std::jthread thread; // last: its end comes before that of what it uses

    File(const fs::path& file, ResultsHeader header, std::chrono::milliseconds flushInterval)
        : path(file),
          columns(header.quantities.size()),
          fields(header.fields),
          exchange(file, std::move(header)),
          interval(flushInterval),
          thread([this](std::stop_token stop) { flushUntil(stop); })
    {}
    // Without finish(): what came is still worth keeping.
    ~File()
    {
        stop();
        if (problem.empty() && somethingPending()) flush(pending, pendingFields, nullptr);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    std::size_t numbersPending() const
    {
        std::size_t numbers = pending.size() * (columns + 1);
        for (const FieldSnapshot& snapshot : pendingFields)
            numbers += fields[snapshot.set].quantities.size() * fields[snapshot.set].grid.cells();
        return numbers;
    }
    bool somethingPending() const { return pending.size() > 0 || !pendingFields.empty(); }

    void flushUntil(const std::stop_token& stop)
    {
        std::unique_lock lock(mutex);
        while (true) {
            const auto due = Clock::now() + interval;
            changed.wait_until(lock, stop, due, [&] { return numbersPending() >= earlyFlush; });
            if (stop.stop_requested()) return;
            changed.wait(lock, stop, [&] { return somethingPending(); });
            if (stop.stop_requested()) return;
            const SampleBatch batch = std::exchange(pending, {});
            const std::vector<FieldSnapshot> snapshots = std::exchange(pendingFields, {});
            lock.unlock();
            changed.notify_all();
            const std::string failure = flush(batch, snapshots, nullptr);
            lock.lock();
            if (failure.empty()) continue;
            problem = failure;
            changed.notify_all();
            return;
        }
    }

    std::string flush(const SampleBatch& batch, std::span<const FieldSnapshot> snapshots, const Summary* summary)
    {
        try {
            if (summary)
                exchange.publish(batch, snapshots, spectra, summary);
            else
                exchange.publish(batch, snapshots);
            return {};
        } catch (const std::exception& error) {
            return "cannot write results to " + path.string() + ": " + error.what();
        }
    }

    void stop()
    {
        thread.request_stop();
        if (thread.joinable()) thread.join();
    }
};

ResultsWriter::ResultsWriter(std::chrono::milliseconds flushInterval) : flushInterval_(flushInterval) {}
ResultsWriter::~ResultsWriter() = default;
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

std::string ResultsWriter::open(const fs::path& file, const Case& c, const std::string& caseText,
                                const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& fields)
{
    file_.reset();
    if (std::string problem = checkOutputFile(file); !problem.empty()) return problem;
    try {
        file_ = std::make_unique<File>(linkTarget(file), ResultsHeader{c, caseText, dateNow(), quantities, fields},
                                       flushInterval_);
    } catch (const std::exception& failure) {
        return "cannot write results to " + file.string() + ": " + failure.what();
    }
    return {};
}

std::string ResultsWriter::append(const SampleBatch& batch, const std::vector<FieldSnapshot>& fields)
{
    if (!file_) return "no results file is open";
    if (!fits(batch, file_->columns)) return "the samples do not fit the columns of " + file_->path.string();
    if (!fits(fields, file_->fields)) return "the snapshots do not fit the grid of " + file_->path.string();
    std::unique_lock lock(file_->mutex);
    file_->changed.wait(lock, [&] { return !file_->problem.empty() || file_->numbersPending() < mostPending; });
    if (!file_->problem.empty()) return file_->problem;
    touchdown::append(file_->pending, batch);
    file_->pendingFields.insert(file_->pendingFields.end(), fields.begin(), fields.end());
    lock.unlock();
    file_->changed.notify_all();
    return {};
}

std::string ResultsWriter::addSpectrum(const Quantity& quantity, const Spectrum& spectrum, const SpectrumCase& options)
{
    if (!file_) return "no results file is open";
    const std::lock_guard lock(file_->mutex);
    if (!file_->problem.empty()) return file_->problem;
    file_->spectra.push_back({quantity, spectrum, options});
    return {};
}

std::string ResultsWriter::finish(const Summary& summary)
{
    if (!file_) return "no results file is open";
    file_->stop();
    std::string problem = file_->problem;
    const SampleBatch rest = std::exchange(file_->pending, {});
    const std::vector<FieldSnapshot> snapshots = std::exchange(file_->pendingFields, {});
    if (problem.empty()) problem = file_->flush(rest, snapshots, &summary);
    file_.reset();
    return problem;
}

} // namespace touchdown
