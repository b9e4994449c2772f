// SPDX-License-Identifier: GPL-3.0-or-later
//
// A stored run as the beginning of one that continues it, to the same bits as if it had never been interrupted.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/results/results_reader.h"

namespace touchdown {

struct ContinuedRun {
    std::string problem;     // why it does not continue, in a sentence; "" if it does
    bool isOfOthers = false; // why: another version or machine began it, which may be allowed
    std::string remark;      // what was allowed, now and before: the sentence in the file, "" where nothing was
    /// The state. Null where there is none that fits, for the reason in `startsAgain`: then the run starts again.
    std::shared_ptr<const StoredCheckpoint> from;
    std::string startsAgain;
    std::vector<std::shared_ptr<const StoredCheckpoint>> states; // not after it, itself last: for the file of the run
};

enum class OtherOrigin : bool { Refused, Allowed };

/// Of a run with the case `before`: its status, version, quantities and checkpoints. It continues as `now`, which may
/// differ by a longer run.duration alone. `other`: of runs that another version of the program or another machine
/// began, whose bits may differ.
ContinuedRun continueRun(const StoredRun& stored, const Case& before, const Case& now,
                         OtherOrigin other = OtherOrigin::Refused);

/// Leaves the samples and the snapshots that came before a state.
void cutTo(const StoredCheckpoint& checkpoint, SampleBatch& samples, std::vector<FieldSnapshot>& fields);

} // namespace touchdown
