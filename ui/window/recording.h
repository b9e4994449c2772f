// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file to which runs are recorded as they go. Each run takes the place of the one before it; a file that
// another program has written there meanwhile is not written over without a question.
#pragma once

#include <functional>
#include <optional>

#include <QAction>
#include <QWidget>

#include "core/formats/file_identity.h"

namespace touchdown {

class RunWindow;

class Recording : public QObject {
    Q_OBJECT

public:
    /// All must outlive this. `action` is checked while a file is chosen.
    Recording(QAction& action, RunWindow& runs, QWidget& window);

    /// Asks for the file; off: no run is recorded any more.
    void choose(bool on);
    QString file() const { return file_; }
    /// Calls `next` if the file may be written over; asks where another program has changed it.
    void whenFree(const std::function<void()>& next);

private:
    void expect(const QString& file);

    QAction& action_;
    RunWindow& runs_;
    QWidget& window_;
    QString file_;
    std::optional<FileIdentity> identity_; // when it was chosen or recorded last; none: there was no file
};

} // namespace touchdown
