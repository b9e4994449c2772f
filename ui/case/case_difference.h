// SPDX-License-Identifier: GPL-3.0-or-later
//
// The changes from one case to another, in words.
#pragma once

#include "core/case/case.h"

#include <QStringList>

namespace touchdown {

/// "Take-off height 5 nm → 8 nm" for each parameter that differs and that one of the cases uses.
QStringList caseDifference(const Case& before, const Case& after);

} // namespace touchdown
