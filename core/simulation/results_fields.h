// SPDX-License-Identifier: GPL-3.0-or-later
//
// The group /fields of a results file: snapshots of fields over a grid of cells. Each function throws Hdf5Error. Hold a
// Hdf5Access around them.
#pragma once

#include <span>
#include <vector>

#include "core/simulation/field_snapshot.h"
#include "core/simulation/hdf5_access.h"

namespace touchdown {

/// Nothing where there are no fields, here and below.
void createFields(hid_t file, const RecordedFields& fields);

void appendFields(hid_t file, const RecordedFields& fields, std::span<const FieldSnapshot> snapshots);

/// Brings `to` to the snapshots of `from`, an earlier or later state of the same run. Compressed chunks go over as they are.
void copyMissingFields(hid_t from, hid_t to, const RecordedFields& fields);

/// Bytes that snapshots take in the file, compressed.
hsize_t storedFieldBytes(hid_t file, const RecordedFields& fields);

struct StoredFields {
    RecordedFields fields;
    std::vector<FieldSnapshot> snapshots;
};
StoredFields readFields(hid_t file);

} // namespace touchdown
