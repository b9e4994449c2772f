// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a run to a results file (HDF5).
//
// The file exists from the beginning of the run, with status "interrupted", and is flushed several times a second. So
// after a kill it opens, holds all but about the last second, and says that the run was interrupted.
//
// HDF5 changes a file in many small writes, and between any two of them the file may be unreadable. So a part beside it
// is brought up to date and closed, then the two names are exchanged (one atomic call), and the next flush works on the
// older file. During a run this takes the space of the results twice; chunks are compressed once and copied as they
// are.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/numerics/spectrum.h"
#include "core/results/results_checkpoint.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/recording/run_checkpoint.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

struct ResultsHeader;

/// Writes one run, on a thread of its own. Every call returns "" or the problem in one sentence (disk full, no
/// permission, another run that writes to the file, ...).
class ResultsWriter {
public:
    /// `flushInterval`: from the beginning of a flush to that of the next; none for a file that appears whole or not at
    /// all, when finish() has written it.
    explicit ResultsWriter(std::optional<std::chrono::milliseconds> flushInterval = std::chrono::milliseconds(300));
    ~ResultsWriter(); // writes pending samples; the status stays "interrupted" if finish() was not called
    ResultsWriter(ResultsWriter&&) noexcept;
    ResultsWriter& operator=(ResultsWriter&&) noexcept;

    /// Writes the file without samples, in place of an existing one. `caseText` is the exact input; the parameters come
    /// from `c`.
    std::string open(const std::filesystem::path& file, const Case& c, const std::string& caseText,
                     const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& fields = {});
    /// The same for a run that continues another one. An existing file stays until this one has samples from `seenFrom`
    /// [s] on or has completed; where it ends before, finish() says that the file stayed as it was. `remark`: where
    /// another version or machine began the run, a sentence; else "".
    std::string openAgain(const std::filesystem::path& file, const Case& c, const std::string& caseText,
                          const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& fields,
                          double seenFrom, const std::string& remark);
    /// Takes samples and snapshots; waits only when the disk is far behind. Reports the problem of an earlier flush.
    std::string append(const SampleBatch& batch, const std::vector<FieldSnapshot>& fields = {});
    /// Takes the state of the run after all that came, or one that says itself what came before it.
    std::string keep(const RunCheckpoint& checkpoint);
    std::string keep(std::shared_ptr<const StoredCheckpoint> checkpoint);
    /// Kept for `finish`.
    std::string addSpectrum(const Quantity& quantity, const Spectrum& spectrum, const SpectrumCase& options);
    /// Writes pending samples, status, message, events, summary and spectra; closes the file.
    std::string finish(const Summary& summary);

private:
    struct File;
    std::string open(const std::filesystem::path& file, ResultsHeader header, std::optional<double> seenFrom);

    std::optional<std::chrono::milliseconds> flushInterval_;
    std::unique_ptr<File> file_;
};

} // namespace touchdown
