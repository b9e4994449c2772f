// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run as the window holds it: its case, its samples, its events, how it ended.
//
// A pyramid holds the samples of a quantity, at most a fixed number; beyond that only the extremes are kept (see
// `complete`). Pyramids do not move, so that curves may point to them. Snapshots of fields are bounded too (see
// FieldHistory).
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

#include "core/case/case.h"
#include "core/simulation/recording/run_summary.h"
#include "ui/lists/record_list.h"
#include "ui/maps/field_history.h"
#include "ui/plot/min_max_pyramid.h"

namespace touchdown {

struct Spectrum;
struct WelchOptions;

struct RunRecord : ListedRecord {
    /// Samples held of each quantity, at least.
    static constexpr std::size_t capacity = std::size_t(1) << 20;
    static constexpr std::size_t capacityStep = std::size_t(1) << 14; // between one quantity and the next

    /// Values of all fields of all snapshots, shared by the sets: 256 MB.
    static constexpr std::size_t fieldCapacity = std::size_t(1) << 25;

    /// A run that is to start.
    RunRecord(int number, const Case& c, std::string caseText, std::vector<Quantity> quantities,
              const std::vector<RecordedFields>& fields = {});
    RunRecord(const RunRecord&) = delete;
    RunRecord& operator=(const RunRecord&) = delete;

    void append(const SampleBatch& batch, const std::vector<RunEvent>& newEvents,
                const std::vector<FieldSnapshot>& newFields = {});
    void finish(const Summary& ended) { summary = ended; }
    bool finished() const { return summary.has_value(); }

    /// nullptr if the run does not record it, or has no sample yet.
    const MinMaxPyramid* pyramid(std::string_view quantity) const;
    /// The last sample; nothing if there is none.
    std::optional<double> last(std::string_view quantity) const;
    std::size_t sampleCount() const { return arrived; }
    /// Whether every sample is still held.
    bool complete() const { return columns.empty() || columns.front().size() == arrived; }
    /// Whether every snapshot is still held.
    bool fieldsComplete() const;
    std::size_t snapshotsArrived() const;
    /// All samples held; only of a complete record.
    SampleBatch samples() const;
    double lastTime() const; // [s]

    QString label; // what changed: "FH(0) 20 nm"; see RunsModel
    std::string caseText;
    std::vector<Quantity> quantities;
    std::deque<MinMaxPyramid> columns; // in the order of `quantities`
    std::size_t arrived = 0;
    std::vector<RunEvent> events;
    std::vector<FieldHistory> fields; // in the order of the sets
    std::optional<Summary> summary;
    bool fromFile = false;    // it holds only a part of what its file does: no events, no figures
    bool interrupted = false; // read from a file whose writer was killed
};

/// Where a run ended: the flying height on springs, the minimum spacing on a film. The list of runs, the message and
/// the card show the same number.
struct EndHeight {
    const Quantity* quantity;
    double value; // [m]
};
std::optional<EndHeight> endHeight(const RunRecord& run);

/// A run read back from a file; nothing when the file could not be read, with `problem` set.
std::unique_ptr<RunRecord> recordFromFile(int number, const QString& file, QString& problem);
/// The whole run as an HDF5 file, with the spectrum that its case asks for; of a run that was read from a file, a copy
/// of that file. "" or the problem in a sentence.
QString saveHdf5(const RunRecord& record, const QString& file);
/// The time series as CSV.
QString saveTimeSeries(const RunRecord& record, const QString& file);

/// The power spectrum of a quantity over what the record holds, from `start` on; empty while there is too little.
Spectrum spectrumOf(const RunRecord& record, std::string_view quantity, const WelchOptions& options, double start);

} // namespace touchdown
