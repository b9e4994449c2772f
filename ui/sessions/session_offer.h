// SPDX-License-Identifier: GPL-3.0-or-later
//
// What happens to sessions that ended: one that broke off is offered, those that take too much space are removed.
#pragma once

#include <functional>
#include <memory>

#include <QStringList>
#include <QWidget>

#include "ui/sessions/session_folder.h"

namespace touchdown {

struct SessionState;

/// Leaves only these results and texts in the folder of a session that was restored; removes it when there are none.
/// Returns the problem in a sentence, or "".
QString leaveRest(std::unique_ptr<SessionFolder> folder, const SessionState& rest);

/// A session that broke off while it restored another one: takes over the files of that one that it lists.
void finishRestoring(const SessionFolder& folder);

/// The newest session that broke off with something in it, held until it is let go. Those without work are removed. A
/// state that is not understood is set aside, with a sentence in `remarks`; so is said which session nobody can take.
std::unique_ptr<SessionFolder> newestBrokenOff(QStringList& remarks);

/// Removes folders of sessions that have ended until all together take at most `budget` [byte]: the oldest first, those
/// that the user closed before those that broke off. The newest session that broke off stays, and so do those that a
/// window uses. Returns the bytes that remain.
qint64 keepSessionsWithin(qint64 budget);

/// Asks Restore, Discard or Later, without blocking the window; calls `restore` if that is chosen. Nobody else is
/// offered the folder meanwhile. `remarks` are shown, too.
void offerSession(QWidget& window, std::unique_ptr<SessionFolder> folder, const QStringList& remarks,
                  const std::function<void(std::unique_ptr<SessionFolder>)>& restore);

} // namespace touchdown
