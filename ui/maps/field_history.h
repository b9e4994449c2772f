// SPDX-License-Identifier: GPL-3.0-or-later
//
// The snapshots of one set of fields that a run has recorded so far. Their number is bounded: when there is no room for
// more, every second one goes.
#pragma once

#include "core/simulation/recording/field_snapshot.h"
#include "ui/plot/plot_axis.h"

#include <cstddef>
#include <vector>

namespace touchdown {

struct FieldHistory {
    RecordedFields fields;
    std::size_t capacity;                 // values of all fields of all snapshots
    std::vector<FieldSnapshot> snapshots; // in the order of time
    std::vector<PlotRange> ranges;        // of each field over the whole run, snapshots that went included
    std::size_t stride = 1;               // of those that came, every how many-th is held
    std::size_t arrived = 0;
    std::vector<std::vector<PlotRange>> extremes{}; // of each snapshot that is held, of each field

    /// The range of a field without the highest and the lowest tenth of the snapshots that are held. A tenth is left
    /// out only if it reaches further by more than the rest spans, as in a landing, and if there are at least ten
    /// snapshots.
    PlotRange usualRange(std::size_t field) const;

    void add(const FieldSnapshot& snapshot);
    /// The snapshot that is nearest to a time [s]; there is one at least.
    std::size_t nearest(double time) const;
};

} // namespace touchdown
