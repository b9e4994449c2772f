// SPDX-License-Identifier: GPL-3.0-or-later
//
// State, bar and progress of a calculation in one line: share, activity, figures, time left. At the end, its outcome.
#pragma once

#include <QLabel>
#include <QProgressBar>

#include "core/simulation/recording/progress.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

class ProgressStrip : public QWidget {
    Q_OBJECT

public:
    /// `calculation` names it for assistive programs ("run"); `running` is its state while it runs ("Solving").
    ProgressStrip(CalculationController& controller, const QString& calculation, QString running, QWidget* parent);

    QString text() const { return text_->text(); }
    /// Shows how a calculation ended; `status` as the core names it.
    void conclude(std::string_view status, const QString& text);
    /// Nothing has ended that matters still.
    void clear();
    /// The time left is estimated anew: the rate has changed.
    void restartEstimate() { timeLeft_.restart(); }

private:
    void setState(CalculationController::State state);
    void advance(const Progress& progress);
    void showText();

    QString running_;
    QLabel* state_;
    QProgressBar* bar_;
    QLabel* text_;
    Progress progress_;
    TimeLeft timeLeft_;
};

} // namespace touchdown
