// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout of a results file (HDF5):
//
//   /                        attributes format, format_version, software_version, date, seed, status, message, title
//   /case/text               the input as it was
//   /case/parameters/<key>   every parameter that the model uses, with unit and long_name
//   /timeseries/time, <quantity>
//                            float64, chunked, unlimited, shuffle + deflate; time is the dimension scale
//   /fields/time, x, y, <quantity>
//                            snapshots (time, y, x) at cell centres; x_lines and y_lines bound the cells
//   /contact_fields/...      the same for the patch that can touch, where the film above it has its own /fields
//                            (since 1.2)
//   /spectra/<quantity>/frequency, density | power
//   /events/time, name
//   /checkpoint/newest, extends
//                            states from which the run can be continued (core/results/results_checkpoint.h), since 1.4
//   /summary/...             numbers and texts of the Summary; the verdict on the last part, and the extremes of
//                            the whole run, since 1.3
//
// Each function throws Hdf5Error. Hold a Hdf5Access around them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/formats/hdf5_group.h"
#include "core/numerics/spectrum.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

inline constexpr const char* resultsFormat = "touchdown-run";
inline constexpr int resultsFormatMajor = 1;
inline constexpr int resultsFormatMinor = 4;

/// What is known before the first sample.
struct ResultsHeader {
    Case value;
    std::string caseText;
    std::string date; // ISO 8601, UTC
    std::vector<Quantity> quantities;
    std::vector<RecordedFields> fields;
    std::string continued{}; // of a run that another version or machine began: a sentence, the attribute "continued"
};

/// A new file without samples, with the status "interrupted".
Hdf5Group createResultsFile(const std::filesystem::path& file, const ResultsHeader& header);

struct ResultsSpectrum {
    Quantity quantity;
    Spectrum spectrum;
    SpectrumCase options;
};
void writeSpectrum(const Hdf5Group& file, const ResultsSpectrum& spectrum);

} // namespace touchdown
