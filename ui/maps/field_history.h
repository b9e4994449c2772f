// SPDX-License-Identifier: GPL-3.0-or-later
//
// The snapshots of one set of fields that a run has recorded so far. Their number is bounded: when there is no room for
// more, every second one goes. The values of a snapshot may be on the disk (ui/style/unnamed_file.h).
#pragma once

#include "core/simulation/recording/field_snapshot.h"
#include "ui/plot/plot_axis.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace touchdown {

struct FieldHistory {
    RecordedFields fields;
    std::size_t capacity;                 // values of all fields of all snapshots
    std::vector<FieldSnapshot> snapshots; // in the order of time; without values that are on the disk
    std::vector<PlotRange> ranges;        // of each field over the whole run, snapshots that went included
    std::size_t stride = 1;               // of those that came, every how many-th is held
    std::size_t arrived = 0;
    std::vector<std::vector<PlotRange>> extremes{};        // of each snapshot that is held, of each field
    std::vector<std::shared_ptr<const double[]>> onDisk{}; // the fields of each snapshot, one after another; or nullptr

    /// The range of a field without the highest and the lowest tenth of the snapshots that are held. A tenth is left
    /// out only if it reaches further by more than the rest spans, as in a landing, and if there are at least ten
    /// snapshots.
    PlotRange usualRange(std::size_t field) const;

    void add(const FieldSnapshot& snapshot);
    /// The values of a field.
    std::span<const double> values(std::size_t index, std::size_t field) const;
    /// With its values.
    FieldSnapshot snapshot(std::size_t index) const;
    /// The values of the snapshot at that time are on the disk from now on; no effect if it has gone.
    void moveToDisk(double time, std::shared_ptr<const double[]> values);
    /// The process holds pages of what is on the disk no longer.
    void letGo() const;
    std::size_t bytesInMemory() const;
    std::size_t bytesOnDisk() const;
    /// The snapshot that is nearest to a time [s]; there is one at least.
    std::size_t nearest(double time) const;
};

} // namespace touchdown
