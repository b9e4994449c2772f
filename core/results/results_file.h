// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results on disk. HDF5 for all of a run; CSV for the time series.
//
// The file starts with status "interrupted" and is flushed at least once a second, so that after a kill
// it opens, holds all up to the last flush, and says that the run was interrupted.
//
// HDF5 changes a file in many small writes, and between any two of them the file may be unreadable. So
// none happens in the file that others see: NAME.part is brought up to date and closed, then the two
// names are exchanged (one atomic call), and the next flush works on what was the older file. While a
// run lasts this takes its results' space twice; chunks are compressed once and copied as they are.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/numerics/spectrum.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

inline constexpr int resultsFormatMajor = 1;
inline constexpr int resultsFormatMinor = 2;

/// Why results could not go to `file`, before anything is written: a directory, no permission, no such folder. "" if
/// they can.
std::string checkResultsTarget(const std::filesystem::path& file);

/// Writes one run, on a thread of its own. Every call returns "" or the problem in one sentence (disk full, no
/// permission, ...).
class ResultsWriter {
public:
    explicit ResultsWriter(std::chrono::milliseconds flushInterval = std::chrono::milliseconds(700));
    ~ResultsWriter(); // writes what came; the status stays "interrupted" if finish() was not called
    ResultsWriter(ResultsWriter&&) noexcept;
    ResultsWriter& operator=(ResultsWriter&&) noexcept;

    /// `caseText` is the exact input; the parameters come from `c`. An existing file is replaced only when `finish` or
    /// the first flush has written the new one whole.
    std::string open(const std::filesystem::path& file, const Case& c, const std::string& caseText,
                     const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& fields = {});
    /// Takes samples and snapshots; waits only when the disk is far behind. A problem of an earlier flush is told here.
    std::string append(const SampleBatch& batch, const std::vector<FieldSnapshot>& fields = {});
    /// Kept for `finish`.
    std::string addSpectrum(const Quantity& quantity, const Spectrum& spectrum, const SpectrumCase& options);
    /// Samples still to be written, status, message, events, summary, spectra; closes the file.
    std::string finish(const Summary& summary);

private:
    struct File;
    std::chrono::milliseconds flushInterval_;
    std::unique_ptr<File> file_;
};

/// A run read back.
struct StoredRun {
    std::string title;
    std::string status; // of RunStatus, or "interrupted"
    std::string message;
    std::string caseText;
    std::string softwareVersion;
    std::string date;
    std::vector<Quantity> quantities;
    SampleBatch samples;
    std::vector<RecordedFields> recorded; // sets of which there are snapshots
    std::vector<FieldSnapshot> fields;    // in the order of time
    std::string problem;                  // "" when it was read; else one sentence, and nothing else is set
};
StoredRun readResults(const std::filesystem::path& file);

/// CSV as RFC 4180: a header "time [s],flying_height [m],...", full precision, '.' decimal point whatever the locale.
class CsvWriter {
public:
    CsvWriter();
    ~CsvWriter();
    CsvWriter(CsvWriter&&) noexcept;
    CsvWriter& operator=(CsvWriter&&) noexcept;
    std::string open(const std::filesystem::path& file, const std::vector<Quantity>& quantities);
    std::string append(const SampleBatch& batch);
    std::string close();

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace touchdown
