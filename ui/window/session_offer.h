// SPDX-License-Identifier: GPL-3.0-or-later
//
// The offer to restore a session that ended without being closed.
#pragma once

#include <functional>
#include <memory>

#include <QWidget>

#include "ui/window/session_folder.h"

namespace touchdown {

/// The newest session that broke off with something in it, held until it is let go. Those without work are removed.
std::unique_ptr<SessionFolder> newestBrokenOff();

/// Asks Restore, Discard or Later, without blocking the window; calls `restore` if that is chosen. Nobody else is
/// offered the folder meanwhile.
void offerSession(QWidget& window, std::unique_ptr<SessionFolder> folder,
                  const std::function<void(std::unique_ptr<SessionFolder>)>& restore);

} // namespace touchdown
