// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters and targets of a design study. Without any of both the study searches the preload with which the
// slider flies at its initial height; where the attitude is held, the height at which the film carries the preload.
#pragma once

#include "core/studies/design/design.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

inline constexpr std::size_t mostParameters = 20;
inline constexpr std::size_t mostTargets = 20;

/// The keys of the study with their defaults for a case.
StudyForm designForm(const Case& c);
/// Adds what is wrong to the reader's problems; of use only where there is none.
DesignTask readDesignTask(StudyReader& reader);

} // namespace touchdown
