// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields over the slider at one time, as the maps show them and /fields of a results file keeps them.
#pragma once

#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/simulation/quantity.h"

namespace touchdown {

struct FieldSnapshot {
    double time = 0.0;                       // [s]
    std::size_t set = 0;                     // of recordedFields
    std::vector<std::vector<double>> values; // one field for each recorded one, on the cells of the grid [unit]; finite
};

/// What snapshots of a run hold, the same from its first to its last.
struct RecordedFields {
    std::string group = "fields";     // of a results file
    CellGrid grid;                    // over the slider, or over the pad where a pad alone is modelled [m]
    std::vector<Quantity> quantities; // "contact_pressure", "adhesion_pressure", "gap", "disk_surface"
    bool empty() const { return quantities.empty(); }
};

} // namespace touchdown
