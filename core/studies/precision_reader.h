// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a study of accuracy against speed: see core/studies/work_precision.h.
#pragma once

#include "core/studies/precision_task.h"
#include "core/studies/study_reader.h"

namespace touchdown {

/// Adds what is wrong to the reader's problems; of use only where there is none.
PrecisionTask readPrecisionTask(StudyReader& reader);

} // namespace touchdown
