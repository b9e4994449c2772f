// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

StudyPerformance planAdvisor(StudyReader& reader);
StudyForm advisorForm(const Case& c);

} // namespace touchdown
