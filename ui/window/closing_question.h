// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one question before the window closes. It names what would be lost; one folder takes all that is to be saved.
#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>

#include "ui/window/unsaved_work.h"

namespace touchdown {

class ClosingQuestion : public QObject {
    Q_OBJECT

public:
    ClosingQuestion(const SessionParts& parts, QWidget& window);

    /// Whether nothing would be lost. Else asks, without blocking the window, and emits `answered` if it may close.
    /// `kept`: what is not saved stays in the folder of the session for a while.
    bool nothingLost(bool kept);

signals:
    /// All was saved, or is not wanted.
    void answered();

private:
    void ask(const UnsavedWork& work, bool kept);
    void saveAll();
    void saveInto(const QString& folder);

    SessionParts parts_;
    QWidget& window_;
    QPointer<QWidget> asking_; // the dialog that is open
};

} // namespace touchdown
