// SPDX-License-Identifier: GPL-3.0-or-later
//
// The question before the values that a study found replace those of the open case. It lists the changes.
#pragma once

#include <functional>

#include <QWidget>

#include "core/case/case.h"

namespace touchdown {

/// Asks without blocking the window; calls `apply` on yes. `title` is that of the study. Says so where nothing changes.
void askToApply(QWidget& window, const Case& open, const Case& found, const QString& title,
                const std::function<void()>& apply);

} // namespace touchdown
