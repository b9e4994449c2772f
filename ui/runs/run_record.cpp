// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_record.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <QDir>
#include <QFileInfo>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/numerics/spectrum.h"
#include "core/results/csv_writer.h"
#include "core/results/results_reader.h"
#include "core/results/results_writer.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/simulation/run.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

QString incompleteProblem(const RunRecord& record)
{
    return tr("Run %1 has %2 snapshots of fields, more than are kept; switch on \"Record to file\" before such a run "
              "to "
              "keep them all.")
        .arg(record.number)
        .arg(record.snapshotsArrived());
}

/// A file that has all of the run; empty: there is none.
QString wholeFile(const RunRecord& record)
{
    if (QFileInfo::exists(record.kept)) return record.kept;
    return record.fromFile && record.identity && record.isInFile() ? record.file : QString();
}

QString replacedProblem(const RunRecord& record)
{
    const QString file = QDir::toNativeSeparators(record.file);
    const QString cause = file.isEmpty()            ? tr("this file is gone or holds another run now")
                          : QFileInfo::exists(file) ? tr("%1 has been changed or replaced since").arg(file)
                                                    : tr("%1 is gone or cannot be reached").arg(file);
    return tr("Run %1 was read from a file, and %2. The window holds only a part of the run. Its time series can be "
              "saved as CSV. For all of it, bring the file back.")
        .arg(record.number)
        .arg(cause);
}

RunStatus statusFromName(const std::string& text)
{
    for (const RunStatus status : {RunStatus::Completed, RunStatus::Cancelled, RunStatus::Diverged, RunStatus::Failed})
        if (text == name(status)) return status;
    return RunStatus::Cancelled; // "interrupted"
}

Motion motionFromName(const std::string& text)
{
    for (const Motion motion :
         {Motion::AtRest, Motion::Settles, Motion::Swings, Motion::Vibrates, Motion::Bounces, Motion::TooShort})
        if (text == name(motion)) return motion;
    return Motion::NotJudged;
}

} // namespace

RunRecord::RunRecord(int runNumber, const Case& c, std::string text, std::vector<Quantity> recorded,
                     const std::vector<RecordedFields>& sets)
    : caseText(std::move(text)), quantities(std::move(recorded))
{
    number = runNumber;
    name = QString::fromStdString(c.title);
    value = c;
    setFields(sets);
    for (std::size_t i = 0; i < quantities.size(); ++i) columns.emplace_back(times);
}

void RunRecord::setFields(const std::vector<RecordedFields>& sets)
{
    for (const RecordedFields& set : sets) fields.push_back({set, fieldCapacity / sets.size(), {}, {}});
}

void RunRecord::append(const SampleBatch& batch, const std::vector<RunEvent>& newEvents,
                       const std::vector<FieldSnapshot>& newFields)
{
    for (std::size_t i = 0; i < std::min(columns.size(), batch.columns.size()); ++i)
        columns[i].append(batch.time, batch.columns[i]);
    events.insert(events.end(), newEvents.begin(), newEvents.end());
    for (const FieldSnapshot& snapshot : newFields) fields[snapshot.set].add(snapshot);
}

void RunRecord::finish(const Summary& ended)
{
    summary = ended;
    checkpoints.leave(ended.status);
    // Of a run that continued a file, the summary alone knows the first ones.
    if (events.size() < ended.events.size()) events = ended.events;
    times->shrink();
    for (MinMaxPyramid& column : columns) column.shrink();
}

const MinMaxPyramid* RunRecord::pyramid(std::string_view quantity) const
{
    const int index = findQuantity(quantities, quantity);
    return index < 0 ? nullptr : &columns[static_cast<std::size_t>(index)];
}

std::optional<double> RunRecord::last(std::string_view quantity) const
{
    const MinMaxPyramid* column = pyramid(quantity);
    if (!column || column->empty()) return std::nullopt;
    return column->lastValue();
}

std::optional<EndHeight> endHeight(const RunRecord& run)
{
    const char* name = run.value.model == ModelKind::Film ? "minimum_spacing" : "flying_height";
    const int index = findQuantity(run.quantities, name);
    const std::optional<double> value = run.last(name);
    if (!value || !run.caseProblem.isEmpty() || run.value.model == ModelKind::Contact) return std::nullopt;
    return EndHeight{&run.quantities[static_cast<std::size_t>(index)], *value};
}

double endSwing(const Summary& summary)
{
    const Statistics* tail = valueIn(summary.tail, "minimum_spacing");
    return tail ? tail->max - tail->min : summary.verdict.swing;
}

QString endText(const RunRecord& run)
{
    const Summary& summary = *run.summary;
    if (lasts(summary.verdict.motion)) return tr("swings by %1").arg(lengthText(endSwing(summary), 3));
    const std::optional<EndHeight> end = endHeight(run);
    if (!end) return {};
    // A guide shows the first part of a run while its slider is moved.
    const bool goesOn = (run.ofGuide && summary.endTime < run.value.run.duration * (1.0 - 1e-9)) ||
                        summary.verdict.motion == Motion::TooShort;
    return (goesOn ? tr("at %1") : tr("ends at %1")).arg(readout(end->value, *end->quantity));
}

bool RunRecord::fieldsComplete() const
{
    return std::ranges::all_of(fields, [](const FieldHistory& history) { return history.stride == 1; });
}

std::size_t RunRecord::snapshotsArrived() const
{
    std::size_t count = 0;
    for (const FieldHistory& history : fields) count += history.arrived;
    return count;
}

SampleBatch RunRecord::samples(std::size_t part) const
{
    SampleBatch batch;
    const std::span<const double> at = times->column().piece(part);
    batch.time.assign(at.begin(), at.end());
    for (const MinMaxPyramid& column : columns) {
        std::vector<double>& values = batch.columns.emplace_back();
        if (column.times() == times && column.size() == times->size()) {
            const std::span<const double> all = column.values().piece(part);
            values.assign(all.begin(), all.end());
            continue;
        }
        // A damaged file had no number there.
        for (const double time : at)
            values.push_back(column.valueAt(time).value_or(column.empty() ? 0.0 : column.lastValue()));
    }
    return batch;
}

std::vector<SampleColumn*> RunRecord::numbers()
{
    std::vector<SampleColumn*> all{&times->column()};
    const auto add = [&](MinMaxPyramid& column) {
        all.push_back(&column.values());
        if (column.times() != times) all.push_back(&column.times()->column());
    };
    for (MinMaxPyramid& column : columns) add(column);
    for (auto& [quantity, column] : differences) add(column);
    return all;
}

std::vector<const MinMaxPyramid*> RunRecord::pyramids() const
{
    std::vector<const MinMaxPyramid*> all;
    for (const MinMaxPyramid& column : columns) all.push_back(&column);
    for (const auto& [quantity, column] : differences) all.push_back(&column);
    return all;
}

std::size_t RunRecord::bytesInMemory() const
{
    std::size_t bytes = times->bytesInMemory() + events.capacity() * sizeof(RunEvent);
    for (const MinMaxPyramid* column : pyramids())
        bytes += column->bytesInMemory() + (column->times() == times ? 0 : column->times()->bytesInMemory());
    for (const FieldHistory& history : fields) bytes += history.bytesInMemory();
    return bytes;
}

std::size_t RunRecord::bytesOnDisk() const
{
    std::size_t bytes = times->column().bytesOnDisk();
    for (const MinMaxPyramid* column : pyramids())
        bytes +=
            column->values().bytesOnDisk() + (column->times() == times ? 0 : column->times()->column().bytesOnDisk());
    for (const FieldHistory& history : fields) bytes += history.bytesOnDisk();
    return bytes;
}

void RunRecord::letGo() const
{
    times->column().letGo();
    for (const MinMaxPyramid* column : pyramids()) {
        column->values().letGo();
        if (column->times() != times) column->times()->column().letGo();
    }
    for (const FieldHistory& history : fields) history.letGo();
}

double RunRecord::lastTime() const
{
    return columns.empty() || columns.front().empty() ? 0.0 : columns.front().lastTime();
}

std::unique_ptr<RunRecord> performedRecord(const Case& c, double until, const std::function<bool()>& goOn,
                                           const RunOptions& options)
{
    Case part = c;
    part.run.duration = std::min(until, c.run.duration);
    // The gap over a disk that is not flat is sought at each sample, which takes longer than the rest of a preview.
    // These samples show oscillations up to 1 MHz.
    constexpr double coarsest = 0.4e-6; // [s]
    if (options.kept == KeptStates::Similar && c.diskSurface.kind != DiskSurfaceKind::Flat)
        part.run.sampleInterval = std::max(part.run.sampleInterval, coarsest);
    auto record = std::make_unique<RunRecord>(0, c, std::string(), recordedQuantities(c), recordedFields(c));
    const auto take = [&](const RunUpdate& update) {
        record->append(update.samples, update.events, update.fields);
        return goOn();
    };
    record->finish(run(part, take, options));
    return record;
}

std::unique_ptr<RunRecord> recordFromFile(int number, const QString& file, QString& problem)
{
    const std::optional<FileIdentity> identity = identityOf(file.toStdString());
    StoredRun stored = readResults(std::filesystem::path(file.toStdString()));
    if (!stored.problem.empty()) {
        problem = QString::fromStdString(stored.problem);
        return nullptr;
    }
    // A file whose case this version cannot read still shows its samples.
    const CaseDocument document = parseCase(stored.caseText, file.toStdString());
    auto record =
        std::make_unique<RunRecord>(number, document.value, stored.caseText, stored.quantities, stored.recorded);
    if (!document.valid()) record->caseProblem = QString::fromStdString(document.problems.front().text());
    record->name = QString::fromStdString(stored.title);
    record->file = file;
    record->identity = identity;
    record->fromFile = true;
    record->continued = stored.continued;
    // What the record has is freed at once: a long run would be in memory twice.
    for (std::size_t i = 0; i < stored.samples.columns.size(); ++i) {
        record->columns[i].append(stored.samples.time, stored.samples.columns[i]);
        stored.samples.columns[i] = {};
    }
    for (FieldSnapshot& snapshot : stored.fields) record->append({}, {}, {std::exchange(snapshot, {})});
    Summary summary;
    summary.status = statusFromName(stored.status);
    summary.message = stored.message;
    record->interrupted = stored.status == "interrupted";
    if (record->interrupted) summary.message = tr("The program that wrote this run was interrupted.").toStdString();
    summary.endTime = record->lastTime();
    for (const Quantity& quantity : stored.quantities)
        if (const std::optional<double> last = record->last(quantity.name))
            summary.final.emplace_back(quantity.name, *last);
    summary.verdict.motion = motionFromName(stored.motion);
    summary.verdict.swing = stored.swing;
    record->finish(summary);
    for (StoredCheckpoint& checkpoint : stored.checkpoints) {
        const bool isFirst = &checkpoint == &stored.checkpoints.front(); // the latest
        const auto shared = std::make_shared<const StoredCheckpoint>(std::move(checkpoint));
        if (isFirst && summary.status != RunStatus::Completed) record->checkpoints.newest = shared;
        if (shared->at.extends) record->checkpoints.extends = shared;
    }
    return record;
}

QString saveHdf5(const RunRecord& record, const QString& file)
{
    const bool held = record.fieldsComplete();
    if (const QString whole = wholeFile(record); !whole.isEmpty() && (record.fromFile || !held))
        return copyWholeFile(whole, file);
    if (record.fromFile) return replacedProblem(record);
    if (!held) return incompleteProblem(record);
    ResultsWriter writer(std::nullopt);
    std::vector<RecordedFields> sets;
    for (const FieldHistory& history : record.fields) sets.push_back(history.fields);
    std::string problem =
        writer.open(std::filesystem::path(file.toStdString()), record.value, record.caseText, record.quantities, sets);
    for (std::size_t part = 0; part < record.parts() && problem.empty(); ++part)
        problem = writer.append(record.samples(part));
    for (const FieldHistory& history : record.fields)
        for (std::size_t i = 0; i < history.snapshots.size() && problem.empty(); ++i)
            problem = writer.append({}, {history.snapshot(i)});
    for (const Quantity& quantity : record.quantities) {
        if (!problem.empty() || quantity.name != "minimum_spacing") continue;
        const Spectrum spectrum =
            spectrumOf(record, quantity.name, welchOptions(record.value.spectrum, record.value.run.sampleInterval),
                       record.value.spectrum.start);
        if (!spectrum.empty()) problem = writer.addSpectrum(quantity, spectrum, record.value.spectrum);
    }
    for (const auto& checkpoint : {record.checkpoints.extends, record.checkpoints.newest})
        if (checkpoint && problem.empty()) problem = writer.keep(checkpoint);
    if (problem.empty()) problem = writer.finish(record.summary.value_or(Summary{}));
    return QString::fromStdString(problem);
}

QString saveTimeSeries(const RunRecord& record, const QString& file)
{
    CsvWriter writer;
    std::string problem = writer.open(std::filesystem::path(file.toStdString()), record.quantities);
    for (std::size_t part = 0; part < record.parts() && problem.empty(); ++part)
        problem = writer.append(record.samples(part));
    if (problem.empty()) problem = writer.close();
    return QString::fromStdString(problem);
}

std::size_t evenSamples(const MinMaxPyramid& column, std::size_t count)
{
    constexpr double rounding = 1e-6; // [-]
    if (count < 3) return count;
    const double interval = column.time(1) - column.time(0), last = column.time(count - 1) - column.time(count - 2);
    return last < (1.0 - rounding) * interval ? count - 1 : count;
}

Signal signalOf(const RunRecord& record, std::string_view quantity, double start)
{
    const MinMaxPyramid* column = record.pyramid(quantity);
    if (!column || column->empty()) return {};
    const auto [begin, end] = column->samplesWithin(start, column->lastTime());
    if (end - begin < 8) return {};
    Signal signal;
    signal.interval = column->time(begin + 1) - column->time(begin);
    const std::size_t even = evenSamples(*column, end);
    for (std::size_t k = begin; k < even;) {
        const std::size_t piece = k / SampleColumn::pieceSize;
        const std::size_t next = std::min(even, (piece + 1) * SampleColumn::pieceSize);
        signal.parts.push_back(column->values().piece(piece).subspan(k % SampleColumn::pieceSize, next - k));
        signal.owners.push_back(column->values().owner(piece));
        k = next;
    }
    return signal;
}

Spectrum spectrumOf(const Signal& signal, const WelchOptions& options)
{
    std::vector<double> samples;
    for (const std::span<const double> part : signal.parts) samples.insert(samples.end(), part.begin(), part.end());
    return samples.empty() ? Spectrum{} : welch(samples, signal.interval, options);
}

Spectrum spectrumOf(const RunRecord& record, std::string_view quantity, const WelchOptions& options, double start)
{
    return spectrumOf(signalOf(record, quantity, start), options);
}

} // namespace touchdown
