// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convergence of a contact patch (convergence.h) as a study.
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

struct ConvergenceStudy;

/// Reads the study's keys; what is wrong, or why this case cannot be studied so, is added to the reader's problems.
StudyPerformance planConvergence(StudyReader& reader);
/// Its keys with their defaults for a case.
StudyForm convergenceForm(const Case& c);

StudyReport convergenceReport(const ConvergenceStudy& study);

} // namespace touchdown
