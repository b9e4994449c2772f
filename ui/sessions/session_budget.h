// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace touchdown {

/// Removes folders of sessions that have ended until all together take at most `budget` [byte]: the oldest first, those
/// that the user closed before those that broke off. The newest session that broke off stays, and so do those that a
/// window uses. Returns the bytes that remain.
qint64 keepSessionsWithin(qint64 budget);

} // namespace touchdown
