// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run as the window holds it: its case, its samples, its events, how it ended.
//
// A pyramid holds the samples of a quantity. Pyramids do not move, so that curves may point to them. What takes too
// much memory is on the disk (RunMemory); whoever reads samples does not notice. The number of snapshots of fields is
// bounded (see FieldHistory).
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

#include "core/case/case.h"
#include "core/results/results_checkpoint.h"
#include "core/simulation/recording/run_summary.h"
#include "ui/lists/record_list.h"
#include "ui/maps/field_history.h"
#include "ui/plot/min_max_pyramid.h"

namespace touchdown {

struct Spectrum;
struct WelchOptions;

struct RunRecord : ListedRecord {
    /// Values of all fields of all snapshots, shared by the sets: 256 MB.
    static constexpr std::size_t fieldCapacity = std::size_t(1) << 25;

    /// A run that is to start, or one of a file, whose sets of fields are known.
    RunRecord(int number, const Case& c, std::string caseText, std::vector<Quantity> quantities,
              const std::vector<RecordedFields>& sets = {});
    /// Once, before the first snapshot.
    void setFields(const std::vector<RecordedFields>& sets);
    RunRecord(const RunRecord&) = delete;
    RunRecord& operator=(const RunRecord&) = delete;

    void append(const SampleBatch& batch, const std::vector<RunEvent>& newEvents,
                const std::vector<FieldSnapshot>& newFields = {});
    void keep(const ResultsCheckpoints& newCheckpoints) { checkpoints.add(newCheckpoints); }
    void finish(const Summary& ended);
    bool finished() const { return summary.has_value(); }

    /// nullptr if the run does not record it, or has no sample yet.
    const MinMaxPyramid* pyramid(std::string_view quantity) const;
    /// The last sample; nothing if there is none.
    std::optional<double> last(std::string_view quantity) const;
    std::size_t sampleCount() const { return times->size(); }
    /// Whether every snapshot is still held.
    bool fieldsComplete() const;
    std::size_t snapshotsArrived() const;
    /// The samples in parts, one after another, for writers: together they may not fit into memory.
    std::size_t parts() const { return times->column().pieces(); }
    SampleBatch samples(std::size_t part) const;
    double lastTime() const; // [s]

    /// All columns of numbers, of the differences, too: the times first.
    std::vector<SampleColumn*> numbers();
    /// What the run takes of the memory and of the disk.
    std::size_t bytesInMemory() const;
    std::size_t bytesOnDisk() const;
    /// The process holds pages of what is on the disk no longer.
    void letGo() const;

    /// Of the quantities and of the differences.
    std::vector<const MinMaxPyramid*> pyramids() const;

    QString label; // what changed: "FH(0) 20 nm"; see RunsModel
    std::string caseText;
    std::vector<Quantity> quantities;
    std::shared_ptr<SampleTimes> times = std::make_shared<SampleTimes>();
    std::deque<MinMaxPyramid> columns;                // in the order of `quantities`
    std::map<std::string, MinMaxPyramid> differences; // from the baseline, by quantity (RunDifferences)
    std::vector<RunEvent> events;
    std::vector<FieldHistory> fields; // in the order of the sets
    std::optional<Summary> summary;
    ResultsCheckpoints checkpoints; // from which it can be continued
    std::string continued;          // which other version or machine began it; "" for none
    bool fromFile = false;          // it holds only a part of what its file did: no events, no figures
    bool ofGuide = false;           // of the lesson or of a demonstration: by a button or a slider
    QString caseProblem;      // why the case in its file cannot be read: `value` is not its case; empty: it was read
    bool interrupted = false; // read from a file whose writer was killed
};

/// Where a run ended: the flying height on springs, the minimum spacing on a film.
struct EndHeight {
    const Quantity* quantity;
    double value; // [m]
};
std::optional<EndHeight> endHeight(const RunRecord& run);
/// The minimum spacing over the last tenth of a run, peak to peak [m]; 0: not known.
double endSwing(const Summary& summary);
/// How the height of a finished run ends, in the words that the list of runs, the message and the panes share: "ends at
/// 7.000 nm"; of a motion that lasts, whose last sample is anywhere, "swings by 8.08 nm", peak to peak; "at 7.000
/// nm" where the motion goes on or may. Empty for a pad.
QString endText(const RunRecord& run);

/// Performs a case until a time [s], or to its end; `goOn` is asked after each batch of samples, and ends the run with
/// false. Throws what the run throws.
std::unique_ptr<RunRecord> performedRecord(const Case& c, double until, const std::function<bool()>& goOn,
                                           const RunOptions& options = {});

/// A run read back from a file; nothing when the file could not be read, with `problem` set.
std::unique_ptr<RunRecord> recordFromFile(int number, const QString& file, QString& problem);
/// The whole run as an HDF5 file, with the spectrum that its case asks for; of a run that was read from a file, a copy
/// of that file, which is refused if the file is another one by now. "" or the problem in a sentence.
QString saveHdf5(const RunRecord& record, const QString& file);
/// The time series as CSV.
QString saveTimeSeries(const RunRecord& record, const QString& file);

/// Of the first `count` samples of a quantity those at equal intervals: all but the last one, where that is the end of
/// a run between two of them.
std::size_t evenSamples(const MinMaxPyramid& column, std::size_t count);

/// Samples of a quantity, for another thread: they stay as they are whatever happens to the record.
struct Signal {
    double interval = 0.0; // between samples [s]
    std::vector<std::span<const double>> parts;
    std::vector<std::shared_ptr<const double[]>> owners; // of the parts
};
/// From `start` [s] on, at equal intervals; without parts while there is too little for a spectrum.
Signal signalOf(const RunRecord& record, std::string_view quantity, double start);
Spectrum spectrumOf(const Signal& signal, const WelchOptions& options);
/// The power spectrum of a quantity over what the record holds, from `start` on; empty while there is too little.
Spectrum spectrumOf(const RunRecord& record, std::string_view quantity, const WelchOptions& options, double start);

} // namespace touchdown
