// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a calculation, a bar and a text in one line.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QWidget>

#include "ui/calculation/calculation_controller.h"

namespace touchdown {

class ProgressStrip : public QWidget {
    Q_OBJECT

public:
    QString text() const { return text_->text(); }

protected:
    /// `what` is that of which it tells, "run"; `told` what the text tells.
    ProgressStrip(const QString& what, const QString& told, QWidget* parent);

    /// A calculation begins or ends; how it ended is `conclude`'s to say.
    void follow(CalculationController::State state, const QString& running);
    void begin(const QString& state);
    /// A share below 0: nobody knows how far it is, and the bar moves without saying.
    void advance(double share, const QString& text);
    void conclude(const QString& state, const QString& text);
    void setStateText(const QString& state) { state_->setText(state); }
    void setText(const QString& text) { text_->setText(text); }

private:
    QLabel* state_;
    QProgressBar* bar_;
    QLabel* text_;
};

} // namespace touchdown
