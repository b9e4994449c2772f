// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a run is: state, simulated time, rate, time left.
#pragma once

#include <QElapsedTimer>

#include "ui/calculation/progress_strip.h"
#include "ui/runs/run_controller.h"

namespace touchdown {

class RunProgress : public ProgressStrip {
    Q_OBJECT

public:
    explicit RunProgress(QWidget* parent = nullptr);

    void begin();
    void setState(RunController::State state);
    void advance(double time, double duration);
    void end(const Summary& summary);

private:
    QString stateText(RunController::State state) const;
    void updateText();

    QElapsedTimer clock_;
    double time_ = 0.0;     // [s]
    double duration_ = 0.0; // [s]
    double rate_ = 0.0;     // simulated per wall time, smoothed [s/s]
    double rateTime_ = 0.0; // of the last estimate [s]
    RunController::State runState_ = RunController::State::Idle;
};

} // namespace touchdown
