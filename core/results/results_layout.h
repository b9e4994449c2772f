// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of a results file (HDF5):
//
//   /                                attributes format, format_version, software_version, date, seed, status,
//                                    message, title
//   /case/text                       the input as it was
//   /case/parameters/<key>           every parameter that the model uses, with unit and long_name
//   /timeseries/time, <quantity>     float64, chunked, unlimited, shuffle + deflate; time is the dimension scale
//   /fields/time, x, y, <quantity>   snapshots (time, y, x) at cell centres; x_lines and y_lines bound the cells
//   /contact_fields/...              the same for the patch that can touch, where the film above it has its own
//                                    /fields; since 1.2
//   /spectra/<quantity>/frequency, density | power
//   /events/time, name
//   /summary/...                     numbers and texts of the Summary
//
// Each function throws Hdf5Error. Hold a Hdf5Access around them.
#pragma once

#include "core/case/case.h"
#include "core/formats/hdf5_access.h"
#include "core/simulation/recording/run_summary.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchdown {

inline constexpr const char* resultsFormat = "touchdown-run";
inline constexpr const char* interruptedStatus = "interrupted";

/// What is known before the first sample.
struct ResultsHeader {
    Case value;
    std::string caseText;
    std::string date; // ISO 8601, UTC
    std::vector<Quantity> quantities;
    std::vector<RecordedFields> fields;
};

struct ResultsSpectrum {
    Quantity quantity;
    Spectrum spectrum;
    SpectrumCase options;
};

/// The time now as ISO 8601, in UTC.
std::string dateNow();

/// What every file says of itself: format, version, the program, date and title.
void writeFileHeader(hid_t file, const std::string& format, int major, int minor, const std::string& date,
                     const std::string& title);

/// The group /case: the text, and the parameters that the model uses.
void writeCaseGroup(hid_t file, const Case& c, const std::string& text);

/// A new file without samples, with the status "interrupted".
Hdf5Handle createResultsFile(const std::filesystem::path& file, const ResultsHeader& header);

/// Samples in a file.
hsize_t storedSamples(hid_t file);

/// Brings `to` to the samples of `from`, an earlier or later state of the same run. Compressed chunks go over as they
/// are.
void copyMissingSamples(hid_t from, hid_t to, const std::vector<Quantity>& quantities);

void appendSamples(hid_t file, const std::vector<Quantity>& quantities, const SampleBatch& batch);

void writeSpectrum(hid_t file, const ResultsSpectrum& spectrum);

void writeSummary(hid_t file, const std::vector<Quantity>& quantities, const Summary& summary);

/// Bytes that samples take in the file, compressed.
hsize_t storedBytes(hid_t file, const std::vector<Quantity>& quantities);

} // namespace touchdown
