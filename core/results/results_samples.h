// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arrays of a results file that grow with time: /timeseries, and /fields, /contact_fields with snapshots of one set
// of fields each over a grid of cells. Each function throws Hdf5Error. Hold a Hdf5Access around them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/formats/hdf5_group.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

/// Empty groups; the order in which those of the fields are created is that of the sets.
void createSamples(const Hdf5Group& file, const std::vector<Quantity>& quantities,
                   const std::vector<RecordedFields>& sets);

/// Paths of all arrays that grow.
std::vector<std::string> growingArrays(const std::vector<Quantity>& quantities,
                                       const std::vector<RecordedFields>& sets);

void appendSamples(const Hdf5Group& file, const std::vector<Quantity>& quantities, const SampleBatch& batch);
void appendSnapshots(const Hdf5Group& file, const std::vector<RecordedFields>& sets,
                     std::span<const FieldSnapshot> snapshots);

struct StoredSamples {
    std::vector<Quantity> quantities;
    SampleBatch samples;
    std::vector<RecordedFields> sets;     // of which there are snapshots
    std::vector<FieldSnapshot> snapshots; // in the order of time
};
StoredSamples readSamples(const Hdf5Group& file);

} // namespace touchdown
