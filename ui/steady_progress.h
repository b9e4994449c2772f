// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the static solution is: grid, iteration, residual, attitude so far.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QWidget>

#include "ui/steady_controller.h"

namespace touchdown {

class SteadyProgressLine : public QWidget {
    Q_OBJECT

public:
    explicit SteadyProgressLine(QWidget* parent = nullptr);

    void setState(SteadyController::State state);
    void advance(const SteadyProgress& progress);
    void end(const SteadyResult& result);
    QString text() const { return text_->text(); }

private:
    QLabel* state_;
    QProgressBar* bar_; // moves without saying how far: nobody knows how many iterations it takes
    QLabel* text_;
};

} // namespace touchdown
