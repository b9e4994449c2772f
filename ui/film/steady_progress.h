// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the static solution is: grid, iteration, residual, attitude so far.
#pragma once

#include "ui/calculation/progress_strip.h"
#include "ui/film/steady_controller.h"

namespace touchdown {

class SteadyProgressLine : public ProgressStrip {
    Q_OBJECT

public:
    explicit SteadyProgressLine(QWidget* parent = nullptr);

    void setState(SteadyController::State state);
    void advance(const SteadyProgress& progress);
    void end(const SteadyResult& result);
};

} // namespace touchdown
