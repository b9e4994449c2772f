// SPDX-License-Identifier: GPL-3.0-or-later
//
// The progress of a session that is restored, with a button that stops it; hidden otherwise. Reports the result.
#pragma once

#include <QWidget>

namespace touchdown {

class MessageStrip;
class Session;

/// All must outlive the strip.
QWidget* restoreStrip(Session& session, MessageStrip& messages, QWidget& window);

} // namespace touchdown
