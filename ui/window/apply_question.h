// SPDX-License-Identifier: GPL-3.0-or-later
//
// The questions of studies: before the values that a study found replace those of the open case, with a list of the
// changes; before a report that is not saved is replaced.
#pragma once

#include <functional>

#include <QWidget>

#include "core/case/case.h"

namespace touchdown {

struct StudyReport;

/// Asks without blocking the window; calls `apply` on yes. `isOther`: `found` is another case than the open one (see
/// CaseFiles::isOpen). `title` is that of the study. Says so where nothing changes.
void askToApply(QWidget& window, const Case& open, const Case& found, bool isOther, const QString& title,
                const std::function<void()>& apply);

/// Asks whether another report takes the place of one that is not saved.
void askToReplaceReport(QWidget& window, const StudyReport& report, const std::function<void()>& replace);

} // namespace touchdown
