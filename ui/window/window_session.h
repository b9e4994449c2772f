// SPDX-License-Identifier: GPL-3.0-or-later
//
// Settings that last from one session to the next: geometry and panes, theme and font, overlay, speed, last case.
#pragma once

#include <QMainWindow>
#include <QSplitter>
#include <QString>

namespace touchdown {

class RunsPanel;
class WindowActions;

class WindowSession {
public:
    /// All must outlive this.
    struct Parts {
        QMainWindow& window;
        WindowActions& actions;
        QSplitter& splitter;
        RunsPanel& runsPanel;
    };
    explicit WindowSession(const Parts& parts) : parts_(parts) {}

    void save(const QString& lastCase) const;
    void restore() const;
    /// A file or a sample case; empty when there is none.
    static QString lastCase();

private:
    Parts parts_;
};

} // namespace touchdown
