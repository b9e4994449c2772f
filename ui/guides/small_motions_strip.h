// SPDX-License-Identifier: GPL-3.0-or-later
//
// Film, small motions: below the runs of a case whose film is linear about its static state, values that the reader
// moves, what that film is about with its errors, and the same run with the full film for comparison.
#pragma once

#include <string>
#include <vector>

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "core/case/case.h"
#include "core/studies/lesson/lesson.h"

namespace touchdown {

class LiveRuns;
class LiveValues;
class Workbench;
struct RunRecord;

/// What a small motion of this film answers to: its start, waves of the disk, menisci and friction, suspension. Each
/// from zero or from a lower value to a few times its own.
std::vector<LiveValue> valuesOfSmallMotions(const Case& c);

class SmallMotionsStrip : public QWidget {
    Q_OBJECT

public:
    /// `live` makes the runs of what is moved; `action` makes the film linear or full; where `guide` is shown, the
    /// strip is not. All must last.
    SmallMotionsStrip(Workbench& bench, LiveRuns& live, QAction& action, const QWidget& guide);

    /// Whether there is room for it, its text and its button.
    void showState();
    /// Makes the film of the case linear, and its start a small one; it is then run. Or makes the film full again.
    void makeLinear(bool on);
    LiveValues& values() const { return *values_; }
    QPushButton* full() const { return full_; }
    QString text() const { return text_->text(); }

private:
    void takeCase();
    const RunRecord* newest() const;
    void repeatInFull();

    Workbench& bench_;
    LiveRuns& live_;
    QAction& action_;
    const QWidget& guide_;
    QLabel* text_;
    LiveValues* values_;
    QPushButton* full_;
    std::vector<std::string> keys_; // of the sliders
    bool linear_ = false;
};

} // namespace touchdown
