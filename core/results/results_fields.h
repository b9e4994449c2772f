// SPDX-License-Identifier: GPL-3.0-or-later
//
// The groups /fields, /contact_fields of a results file: each has snapshots of one set of fields over a grid of cells.
// Each function throws Hdf5Error. Hold a Hdf5Access around them.
#pragma once

#include <span>
#include <vector>

#include "core/formats/hdf5_access.h"
#include "core/simulation/recording/field_snapshot.h"

namespace touchdown {

/// One group for each set; the order in which they come into being is that of the sets.
void createFields(hid_t file, const std::vector<RecordedFields>& sets);

void appendFields(hid_t file, const std::vector<RecordedFields>& sets, std::span<const FieldSnapshot> snapshots);

/// Brings `to` to the snapshots of `from`, an earlier or later state of the same run. Compressed chunks go over as they
/// are.
void copyMissingFields(hid_t from, hid_t to, const std::vector<RecordedFields>& sets);

/// Bytes that snapshots take in the file, compressed.
hsize_t storedFieldBytes(hid_t file, const std::vector<RecordedFields>& sets);

struct StoredFields {
    std::vector<RecordedFields> sets;
    std::vector<FieldSnapshot> snapshots; // in the order of time
};
StoredFields readFields(hid_t file);

} // namespace touchdown
