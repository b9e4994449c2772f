// SPDX-License-Identifier: GPL-3.0-or-later
//
// The question before an action takes work away that no file has.
#pragma once

#include <functional>

#include <QWidget>

namespace touchdown {

struct Loss {
    QString name;   // of the box
    QString title;  // of the box: "Delete run 3"
    QString what;   // "The report “Touchdown and take-off” is not saved."
    QString why;    // it would be lost
    QString button; // that goes on all the same: "&Replace"
};

/// Asks without blocking the window, in the place of a question of this name; Cancel is the default. `goOn` is called
/// when the person goes on all the same.
void askBeforeLoss(QWidget& window, const Loss& loss, const std::function<void()>& goOn);

/// Closes the question of this name, if it is open: nothing is done. One that is asked anew takes its place.
void withdrawQuestion(const QWidget& window, const QString& name);

} // namespace touchdown
