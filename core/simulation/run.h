// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of a case: case -> model -> integrator -> batches of samples -> Summary.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// Why a valid case cannot be run in time, in a sentence; "" when it can.
std::string reasonNotToRun(const Case& c);

/// The quantities that a run of this case records, in the order of its columns; none where it cannot be run.
std::vector<Quantity> recordedQuantities(const Case& c);

/// Whether a run of this case records fields, as far as this is known at once.
bool recordsFields(const Case& c);

/// The sets of fields of which this case's run records snapshots, none of them empty. The parts of the slider that can
/// touch are sought, which may take seconds; the answer means nothing after `goOn`, asked meanwhile, returned false.
/// Throws std::runtime_error, a sentence, as diskTopography() in core/case/disk_setup.h does.
std::vector<RecordedFields> recordedFields(const Case& c, const std::function<bool()>& goOn = {});

/// Runs a valid case to its end; one of a film solves one static state at most. Never throws for numerics: see
/// Summary::status.
Summary run(const Case& c, const RunCallback& callback = {}, const RunOptions& options = {});

} // namespace touchdown
