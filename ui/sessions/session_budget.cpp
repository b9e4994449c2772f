// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session_budget.h"

#include "ui/sessions/session_folder.h"
#include "ui/sessions/session_state.h"

namespace touchdown {

qint64 keepSessionsWithin(qint64 budget)
{
    qint64 bytes = 0;
    for (const QString& path : SessionFolder::all()) bytes += bytesIn(path);
    if (bytes <= budget) return bytes;
    QStringList closed, brokenOff; // the newest first
    for (const auto& [path, state] : endedSessions()) {
        if (!state.notUnderstood.isEmpty()) continue; // nobody knows what it is
        (state.closed || state.empty() ? closed : brokenOff) << path;
    }
    if (!brokenOff.isEmpty()) brokenOff.removeFirst();
    QStringList order = brokenOff + closed;
    while (bytes > budget && !order.isEmpty()) {
        std::unique_ptr<SessionFolder> folder = SessionFolder::take(order.takeLast());
        if (!folder) continue; // a window restores it
        bytes -= bytesIn(folder->path());
        SessionFolder::remove(std::move(folder));
    }
    return bytes;
}

} // namespace touchdown
