// SPDX-License-Identifier: GPL-3.0-or-later
//
// The group /checkpoint of a results file: the states from which its run can be continued.
//
//   newest    the last one that was sent; gone when the run has completed
//   extends   the last one from which a longer run continues, too
//
// Where both are one state it stands once, as `extends`. Each is the bytes of its state as 64-bit integers, with the
// attributes time [s], bytes, layout, version, machine, extends, and the numbers of samples and snapshots that came
// before it.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/formats/hdf5_group.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/run_checkpoint.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

struct StoredCheckpoint {
    RunCheckpoint at;
    int layout = checkpointLayout;
    std::string version = TOUCHDOWN_VERSION; // of the program that made it
    std::string machine;                     // on which it was made, see thisMachine()
    std::size_t samples = 0;                 // that came before it
    std::vector<std::size_t> snapshots;      // that came before it, of each set
};

/// What decides the last bits of a result beside the program: processor, compiler, library of mathematical functions.
std::string thisMachine();

/// The newest, and the newest that extends; null: none.
struct ResultsCheckpoints {
    std::shared_ptr<const StoredCheckpoint> newest, extends;

    void add(std::shared_ptr<const StoredCheckpoint> checkpoint);
    void add(const ResultsCheckpoints& later);
    /// Leaves those from which a run that has ended so can be continued.
    void leave(RunStatus status);
    std::vector<std::shared_ptr<const StoredCheckpoint>> all() const; // the latest first
};

/// Brings the group to these; nothing is written where they are there. Throw Hdf5Error; hold a Hdf5Access around them.
void writeCheckpoints(const Hdf5Group& file, const std::vector<RecordedFields>& sets,
                      const ResultsCheckpoints& checkpoints);
/// Bytes that they take in the file.
hsize_t storedBytesOfCheckpoints(const Hdf5Group& file);
/// Those that are there, the latest first; `sets` are those of which there are snapshots.
std::vector<StoredCheckpoint> readCheckpoints(const Hdf5Group& file, const std::vector<RecordedFields>& sets);

} // namespace touchdown
