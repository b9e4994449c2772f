// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields over the slider at one time, as the maps show them and a results file keeps them. What lies on one grid is a
// set: the film over the whole slider, the contact over the patch that can touch.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

struct FieldSnapshot {
    double time = 0.0;                       // [s]
    std::size_t set = 0;                     // which of recordedFields()
    std::vector<std::vector<double>> values; // one field for each recorded one, on the cells of the grid [unit]; finite
};

/// What snapshots of one set hold, the same from the first of a run to its last.
struct RecordedFields {
    std::string group = "fields";     // of a results file; "fields" and "contact_fields" where a run has two
    CellGrid grid;                    // over the slider, or over the pad where a pad alone is modelled [m]
    std::vector<Quantity> quantities; // "contact_pressure", "adhesion_pressure", "gap", "disk_surface"
    bool empty() const { return quantities.empty(); }
};

} // namespace touchdown
