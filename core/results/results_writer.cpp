// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_writer.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "core/formats/hdf5_group.h"
#include "core/formats/output_file.h"
#include "core/results/file_header.h"
#include "core/results/results_exchange.h"

namespace touchdown {
namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

// What may wait for the disk before append() waits [numbers]; as much as a flush writes in flushTime.
constexpr std::size_t leastPending = std::size_t{1} << 18;
constexpr std::size_t mostPending = std::size_t{6} << 20;
// Of a flush. On a machine that is too slow for the samples, the file then lacks those of about twice this time.
constexpr std::chrono::milliseconds flushTime(200);

void append(SampleBatch& target, const SampleBatch& batch)
{
    if (target.columns.empty()) target.columns.resize(batch.columns.size());
    target.time.insert(target.time.end(), batch.time.begin(), batch.time.end());
    for (std::size_t i = 0; i < batch.columns.size(); ++i)
        target.columns[i].insert(target.columns[i].end(), batch.columns[i].begin(), batch.columns[i].end());
}

/// Takes the last samples out of a batch.
SampleBatch takeLast(SampleBatch& batch, std::size_t count)
{
    SampleBatch last;
    const auto take = [count](std::vector<double>& from) {
        const auto begin = from.end() - static_cast<std::ptrdiff_t>(count);
        std::vector<double> taken(begin, from.end());
        from.erase(begin, from.end());
        return taken;
    };
    last.time = take(batch.time);
    for (std::vector<double>& column : batch.columns) last.columns.push_back(take(column));
    return last;
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
    std::optional<std::chrono::milliseconds> interval;

    std::mutex mutex; // of all below
    std::condition_variable_any changed;
    SampleBatch pending;
    std::vector<FieldSnapshot> pendingFields;
    ResultsCheckpoints pendingCheckpoints;
    std::size_t samples = 0;            // that came
    std::vector<std::size_t> snapshots; // that came, of each set
    std::vector<ResultsSpectrum> spectra;
    std::size_t stored = 0;                 // samples that were handed to a flush
    std::size_t mayWait = 2 * leastPending; // [numbers]
    std::string problem;
    std::jthread thread; // last: its end comes before that of what it uses

    File(const fs::path& file, ResultsHeader header, FirstSeen seen,
         std::optional<std::chrono::milliseconds> flushInterval)
        : path(file),
          columns(header.quantities.size()),
          fields(header.fields),
          exchange(file, std::move(header), seen),
          interval(flushInterval),
          snapshots(fields.size(), 0),
          thread([this](std::stop_token stop) { flushUntil(stop); })
    {}
    // Without finish(): what came is still worth keeping.
    ~File()
    {
        stop();
        if (problem.empty() && somethingPending()) flush(pending, pendingFields, pendingCheckpoints, nullptr);
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
    bool somethingPending() const { return pending.size() > 0 || !pendingFields.empty() || pendingCheckpoints.newest; }

    void flushUntil(const std::stop_token& stop)
    {
        std::unique_lock lock(mutex);
        const auto isEarly = [&] { return numbersPending() >= mayWait; };
        auto begin = Clock::now();
        while (true) {
            if (interval)
                changed.wait_until(lock, stop, begin + *interval, isEarly);
            else
                changed.wait(lock, stop, isEarly);
            if (stop.stop_requested()) return;
            changed.wait(lock, stop, [&] { return somethingPending(); });
            if (stop.stop_requested()) return;
            begin = Clock::now();
            const std::size_t numbers = numbersPending();
            // No map and no state may be later than the samples.
            const bool wholeChunks = isEarly() && pendingFields.empty() && !pendingCheckpoints.newest;
            SampleBatch batch = std::exchange(pending, {});
            // While samples come fast, only whole chunks: one that is rewritten costs as much as a new one.
            const std::size_t beyond = (stored + batch.size()) % numbersPerChunk;
            if (wholeChunks && beyond < batch.size()) pending = takeLast(batch, beyond);
            stored += batch.size();
            const std::vector<FieldSnapshot> maps = std::exchange(pendingFields, {});
            const ResultsCheckpoints checkpoints = std::exchange(pendingCheckpoints, {});
            lock.unlock();
            changed.notify_all();
            const std::string failure = flush(batch, maps, checkpoints, nullptr);
            lock.lock();
            adapt(numbers, Clock::now() - begin);
            problem = failure;
            changed.notify_all(); // one that waits may go on: mayWait has changed, too
            if (!problem.empty()) return;
        }
    }

    /// After a flush of so many numbers. On a busy machine, less is written at a time.
    void adapt(std::size_t numbers, Clock::duration took)
    {
        const double share = std::chrono::duration<double>(flushTime) / took;
        if (share < 1.0 || numbers > mayWait / 2)
            mayWait = static_cast<std::size_t>(std::clamp(static_cast<double>(numbers) * share,
                                                          static_cast<double>(leastPending),
                                                          static_cast<double>(mostPending)));
    }

    std::string flush(const SampleBatch& batch, std::span<const FieldSnapshot> maps,
                      const ResultsCheckpoints& checkpoints, const Summary* summary)
    {
        try {
            if (checkpoints.extends) exchange.keep(checkpoints.extends);
            if (checkpoints.newest) exchange.keep(checkpoints.newest);
            if (summary)
                exchange.publish(batch, maps, spectra, summary);
            else
                exchange.publish(batch, maps);
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

ResultsWriter::ResultsWriter(std::optional<std::chrono::milliseconds> flushInterval) : flushInterval_(flushInterval) {}
ResultsWriter::~ResultsWriter() = default;
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

std::string ResultsWriter::open(const fs::path& file, const Case& c, const std::string& caseText,
                                const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& fields)
{
    return open(file, {c, caseText, dateNow(), quantities, fields}, std::nullopt);
}

std::string ResultsWriter::openAgain(const fs::path& file, const Case& c, const std::string& caseText,
                                     const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& fields,
                                     double seenFrom, const std::string& remark)
{
    return open(file, {c, caseText, dateNow(), quantities, fields, remark}, seenFrom);
}

std::string ResultsWriter::open(const fs::path& file, ResultsHeader header, std::optional<double> seenFrom)
{
    file_.reset();
    if (std::string problem = checkOutputFile(file); !problem.empty()) return problem;
    FirstSeen seen;
    if (!flushInterval_)
        seen.when = FirstSeen::When::AtEnd;
    else if (seenFrom)
        seen = {FirstSeen::When::FromTime, *seenFrom};
    try {
        file_ = std::make_unique<File>(file, std::move(header), seen, flushInterval_);
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
    file_->changed.wait(lock, [&] { return !file_->problem.empty() || file_->numbersPending() < file_->mayWait; });
    if (!file_->problem.empty()) return file_->problem;
    touchdown::append(file_->pending, batch);
    file_->pendingFields.insert(file_->pendingFields.end(), fields.begin(), fields.end());
    file_->samples += batch.size();
    for (const FieldSnapshot& snapshot : fields) ++file_->snapshots[snapshot.set];
    lock.unlock();
    file_->changed.notify_all();
    return {};
}

std::string ResultsWriter::keep(const RunCheckpoint& checkpoint)
{
    if (!file_) return "no results file is open";
    std::unique_lock lock(file_->mutex);
    auto stored = std::make_shared<const StoredCheckpoint>(StoredCheckpoint{
        checkpoint, checkpointLayout, TOUCHDOWN_VERSION, thisMachine(), file_->samples, file_->snapshots});
    lock.unlock();
    return keep(std::move(stored));
}

std::string ResultsWriter::keep(std::shared_ptr<const StoredCheckpoint> checkpoint)
{
    if (!file_) return "no results file is open";
    std::unique_lock lock(file_->mutex);
    if (!file_->problem.empty()) return file_->problem;
    if (checkpoint->snapshots.size() != file_->fields.size())
        return "a state does not fit the maps of " + file_->path.string();
    file_->pendingCheckpoints.add(std::move(checkpoint));
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
    const std::vector<FieldSnapshot> maps = std::exchange(file_->pendingFields, {});
    const ResultsCheckpoints checkpoints = std::exchange(file_->pendingCheckpoints, {});
    if (problem.empty()) problem = file_->flush(rest, maps, checkpoints, &summary);
    if (problem.empty() && !file_->exchange.isSeen())
        problem = "the run ended before it came beyond what " + file_->path.string() + " holds, which stays as it was" +
                  (summary.message.empty() ? "" : ": " + summary.message);
    file_.reset();
    return problem;
}

} // namespace touchdown
