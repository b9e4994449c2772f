// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a results file (HDF5), in a process of its own (core/formats/reader_process.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/results/results_checkpoint.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

struct StoredRun {
    std::string title;
    std::string status; // of RunStatus, or "interrupted"
    std::string message;
    std::string caseText;
    std::string softwareVersion;
    std::string date;
    std::vector<Quantity> quantities;
    SampleBatch samples;
    std::vector<RecordedFields> recorded;      // sets of which there are snapshots
    std::vector<FieldSnapshot> fields;         // in the order of time
    std::string continued;                     // which other version or machine began it; "" for none
    std::string motion;                        // how it ends, as Motion is named; "" where the file does not say
    std::vector<StoredCheckpoint> checkpoints; // from which it can be continued, the latest first
    double swing = 0.0;  // of the minimum spacing over the last tenth, peak to peak [m]; 0: not known
    std::string problem; // "" when it was read; else one sentence, and nothing else is set
};
StoredRun readResults(const std::filesystem::path& file);
/// The same in this process: for that process, and for files that this program wrote.
StoredRun readResultsDirectly(const std::filesystem::path& file);

} // namespace touchdown
