// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one question before the window closes, or before another case takes results of this one away. It names what would
// be lost; one folder takes all that is to be saved.
#pragma once

#include <functional>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

#include "ui/workbench/unsaved_work.h"

namespace touchdown {

class ClosingQuestion : public QObject {
    Q_OBJECT

public:
    ClosingQuestion(Workbench& bench, QWidget& window);

    /// Whether nothing would be lost. Else asks, without blocking the window, and emits `answered` if it may close.
    /// `kept`: what is not saved stays in the folder of the session for a while, which is enough for the changes of a
    /// sample.
    bool nothingLost(bool kept);
    /// Whether another case would take results away. Then asks about them, and about changes of the case, and calls
    /// `next` if the case may be left.
    bool asksBeforeAnotherCase(const std::function<void()>& next);

signals:
    /// All was saved, or is not wanted.
    void answered();

private:
    UnsavedWork work() const;
    void ask(const UnsavedWork& work, bool kept);
    void saveAll();
    void saveInto(const QString& folder);

    Workbench& bench_;
    QWidget& window_;
    QPointer<QWidget> asking_;    // the dialog that is open
    bool closes_ = true;          // else another case is opened
    std::function<void()> leave_; // closes, or opens it
};

} // namespace touchdown
