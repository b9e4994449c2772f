// SPDX-License-Identifier: GPL-3.0-or-later
//
// Before the values that a study found replace those of the open case: what will change.
#pragma once

#include <functional>

#include <QWidget>

#include "core/case/case.h"

namespace touchdown {

/// Asks without blocking the window; `apply` follows on yes. `title`: of the study. Where nothing would change, says
/// so.
void askToApply(QWidget& window, const Case& open, const Case& found, const QString& title,
                const std::function<void()>& apply);

} // namespace touchdown
