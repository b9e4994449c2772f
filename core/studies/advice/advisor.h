// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

/// Reads the study's keys; what is wrong, or why this case cannot be studied so, is added to the reader's problems.
StudyPerformance planAdvisor(StudyReader& reader);
/// Its keys with their defaults for a case.
StudyForm advisorForm(const Case& c);

} // namespace touchdown
