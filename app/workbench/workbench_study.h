// SPDX-License-Identifier: GPL-3.0-or-later
//
// Performs a study and writes its charts as pictures, without a window: for scripts and for the README.
#pragma once

#include <QString>

#include "core/studies/study_plan.h"

namespace touchdown {

/// Performs a valid plan and writes each chart as <kind>.png and <kind>.svg to the folder, numbered from 1 where there
/// are several; their paths go to stdout, the findings to stderr. `width` in pixels of the screen. The exit code: 0, 1
/// when the study came to no valid answer, 2 when something could not be written.
int pictureStudy(const StudyPlan& plan, const QString& folder, int width);

} // namespace touchdown
